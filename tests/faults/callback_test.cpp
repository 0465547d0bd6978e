// SPDX-License-Identifier: Apache-2.0
// Callbacks that call the library: what changes an object at work is refused, all else works, and
// the call at work comes to the same bits.
#include <gtest/gtest.h>

#include <cmath>

#include "awd/basis.h"
#include "faults/caller_back.h"
#include "support/expect.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

void expectAtWork(AWDResult result) {
  expectFailure(result, AWD_ERROR_INVALID_OPERATION, {"at work"});
}

void useExclusively(AWDField field, const std::string& path) {
  const float up[3] = {0, 0, 1};
  const double uniforms[3] = {0.5, 0.5, 0.5};
  AWDDirectionSample sample;
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  size_t size = 0, sums = 0, maxima = 0;
  AWDPathVertex vertex = {8, 0.5f, {}, {}, {}, {}};
  must(awdSampleField(field, 8, up, uniforms, &sample));  // reading is free
  const uint32_t patch = 8;
  const double value = 1.0;
  expectAtWork(awdRecordField(field, 8, &sample, 1.0));
  expectAtWork(awdRecordFieldBatch(field, 1, &patch, &sample, &value));
  expectAtWork(awdRecordFieldPath(field, 1, &vertex, nullptr, nullptr));
  expectAtWork(awdRecordLight(field, 8, 0, 1.0));
  expectAtWork(awdAdaptField(field, nullptr));
  expectAtWork(awdMarkField(field));
  expectAtWork(awdRevertField(field));
  expectAtWork(awdSetFieldScale(field, 2.0));
  expectAtWork(awdGetFieldStatistics(field, &figures));
  expectAtWork(awdSaveField(field, nullptr, 0, &size));
  expectAtWork(awdWriteField(field, path.c_str()));
  expectAtWork(awdMergeField(field, field));
  expectAtWork(awdExportField(field, nullptr, 0, nullptr, 0, &sums, &maxima));
  const uint64_t number = 0;
  expectAtWork(awdImportField(field, nullptr, 0, &number, 1));
}

/// All that a host may do anyhow, on the same device and on one of its own.
void liveAnotherLife(AWDDevice device) {
  for (const uint32_t threads : {1u, 2u}) {
    const Device own = newDevice(threads);
    const Scene scene = lampRoom().commit(threads == 1 ? device : own);
    const AWDCamera view = lampRoomCamera(20);
    renderFilm(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 4), {1, 2});
  }
  size_t families = 0;
  must(awdGetBasisCount(device, &families));
  EXPECT_GT(families, 0u);
}

class CallsBack : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, CallsBack, testing::Values(1u, 2u));

TEST_P(CallsBack, InAPass) {
  const TemporaryFolder folder;
  CallerBack host, quiet;
  Begun begun(host, GetParam()), undisturbed(quiet, GetParam());
  const Film before = readFilm(begun.render);
  host.onCall("pass", 2, [&] {
    AWDSchedule schedule = AWD_SCHEDULE_INIT;
    schedule.totalSamples = 4;
    uint32_t samples = 0;
    size_t sums = 0, maxima = 0;
    const uint64_t number = 0;
    expectAtWork(awdRenderPass(begun.render, 1, nullptr));
    expectAtWork(awdRenderPasses(begun.render, &schedule));
    expectAtWork(awdRenderPassPart(begun.render, &schedule, 0, 1, &samples));
    expectAtWork(awdExportPass(begun.render, nullptr, 0, &sums, &maxima));
    expectAtWork(awdImportPass(begun.render, &number, 1, nullptr));
    expectAtWork(awdSaveRender(begun.render, folder.path("render").c_str()));
    AWDRender other = nullptr;
    const AWDRenderDesc desc = renderDesc(begun.camera, AWD_GUIDE_ADAPTIVE, 3);
    expectAtWork(awdNewRender(begun.scene, begun.field, &desc, &other));
    useExclusively(begun.field, folder.path("field"));
    // The film is that of the passes before.
    EXPECT_EQ(readFilm(begun.render).radiance, before.radiance);
    Image image;
    must(awdNewFilmImage(begun.render, image.out()));
    liveAnotherLife(begun.device);
  });
  must(awdRenderPass(begun.render, 3, nullptr));
  EXPECT_TRUE(host.acted);
  EXPECT_EQ(folder.files(), 0u);
  must(awdRenderPass(undisturbed.render, 3, nullptr));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

TEST_P(CallsBack, InAnAdapt) {
  const TemporaryFolder folder;
  CallerBack host, quiet;
  Begun begun(host, GetParam()), undisturbed(quiet, GetParam());
  host.onCall("adapt", 1, [&] {
    useExclusively(begun.field, folder.path("field"));
    expectAtWork(awdRenderPass(begun.render, 1, nullptr));
    expectAtWork(awdSaveRender(begun.render, folder.path("render").c_str()));
    liveAnotherLife(begun.device);
  });
  must(awdAdaptField(begun.field, nullptr));
  EXPECT_TRUE(host.acted);
  must(awdAdaptField(undisturbed.field, nullptr));
  expectSameOutcome(outcomeOf(begun.render), outcomeOf(undisturbed.render));
}

TEST_P(CallsBack, InACommit) {
  CallerBack host;
  Begun begun(host, GetParam());
  const SceneBuilder room = lampRoom();
  const AWDMeshDesc mesh = room.mesh();
  const AWDMaterialDesc material = AWD_MATERIAL_DESC_INIT;
  const Film before = readFilm(begun.render);
  host.onCall("commit", 1, [&] {
    expectAtWork(awdCommitScene(begun.scene));
    expectAtWork(awdAddMesh(begun.scene, &mesh, nullptr));
    expectAtWork(awdAddMaterial(begun.scene, &material, nullptr));
    AWDSceneInfo info = AWD_SCENE_INFO_INIT;
    must(awdGetSceneInfo(begun.scene, &info));
    liveAnotherLife(begun.device);
  });
  must(awdCommitScene(begun.scene));
  EXPECT_TRUE(host.acted);
  const Render again = newRender(begun.scene, renderDesc(begun.camera, AWD_GUIDE_ADAPTIVE, 3));
  must(awdRenderPass(again, 2, nullptr));
  EXPECT_EQ(readFilm(again).radiance, before.radiance);
}

TEST_P(CallsBack, WithTheLastReferences) {
  CallerBack host;
  {
    Begun begun(host, GetParam());
    AWDRender render = begun.render;
    host.onCall("pass", 2, [&] {
      begun.render = Render();
      begun.field = Field();
      begun.scene = Scene();
      begun.device = Device();
    });
    must(awdRenderPass(render, 3, nullptr));
    EXPECT_TRUE(host.acted);
  }
  EXPECT_EQ(host.allocator.blocks(), 0u);
  {
    Begun begun(host, GetParam());
    AWDField field = begun.field;
    host.onCall("adapt", 1, [&] {
      begun.render = Render();
      begun.field = Field();
      begun.scene = Scene();
      begun.device = Device();
    });
    must(awdAdaptField(field, nullptr));
    EXPECT_TRUE(host.acted);
  }
  EXPECT_EQ(host.allocator.blocks(), 0u);
}

// --- basis modules -----------------------------------------------------------------------------

AWDDevice lookingDevice = nullptr;  // the device that looks at the module
AWDDevice secondDevice = nullptr;
bool hasCalled = false;

void callTheLibrary() {
  if (!lookingDevice || hasCalled) return;
  hasCalled = true;
  size_t count = 0;
  expectFailure(awdGetBasisCount(lookingDevice, &count), AWD_ERROR_INVALID_OPERATION,
                {"basis module"});
  AWDField field = nullptr;
  expectFailure(awdNewField(lookingDevice, nullptr, &field), AWD_ERROR_INVALID_OPERATION,
                {"must not call"});
  must(awdGetBasisCount(secondDevice, &count));
}

uint32_t boxCount(uint32_t level) {
  callTheLibrary();
  return 1u << level;
}
double widthOf(uint32_t level) { return std::ldexp(1.0, -static_cast<int>(level)); }
const AWDBasisFamily kCalling = {
    sizeof kCalling,
    "test.calling",
    "boxes",
    AWD_BASIS_ORTHOGONAL | AWD_BASIS_NESTED,
    1,
    1,
    0,
    4,
    boxCount,
    boxCount,
    [](uint32_t level, uint32_t j, double ab[2]) {
      ab[0] = j * widthOf(level);
      ab[1] = (j + 1.0) * widthOf(level);
    },
    [](uint32_t level, uint32_t) { return widthOf(level); },
    [](uint32_t level, double x, uint32_t* first, double* values) -> uint32_t {
      const double n = 1u << level;
      *first = static_cast<uint32_t>(std::min(x * n, n - 1.0));
      values[0] = 1.0;
      return 1;
    },
    [](uint32_t level, uint32_t j, const double* u) { return (j + u[0]) * widthOf(level); },
    [](uint32_t, uint32_t j, uint32_t* first, double* h) -> uint32_t {
      *first = 2 * j;
      h[0] = h[1] = 1.0;
      return 2;
    },
    nullptr,
    0};
const AWDBasisFamily* const kFamilies[] = {&kCalling};
const AWDBasisModule kModule = {sizeof kModule, AWD_BASIS_ABI, 1, "1.0", "Apache-2.0", kFamilies};

TEST(CallsBackFrom, ABasisModuleThatIsLookedAt) {
  const Device device = newDevice(1u), second = newDevice(1u);
  lookingDevice = device;
  secondDevice = second;
  hasCalled = false;
  must(awdRegisterBasisModule(device, &kModule));
  lookingDevice = nullptr;
  EXPECT_TRUE(hasCalled);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "test.calling";
  newField(device, &desc);
}

TEST(CallsBackFrom, TheLogAndTheAllocator) {
  struct Host {
    CountingAllocator allocator;
    AWDDevice device = nullptr, other = nullptr;
    size_t logged = 0, allocated = 0;
  } host;
  const Device second = newDevice(1u);
  host.other = second;
  const TemporaryFolder folder;
  const std::string path = folder.path("");
  std::FILE* bad = std::fopen(folder.path("bad.so").c_str(), "w");
  std::fclose(bad);  // to be refused, which is logged
  const char* const folders[] = {path.c_str()};
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;
  desc.basisPaths = folders;
  desc.basisPathCount = 1;
  desc.log = [](void* user, int32_t, const char*) {
    Host& self = *static_cast<Host*>(user);
    size_t count = 0;
    if (self.device) must(awdGetBasisCount(self.device, &count));
    ++self.logged;
  };
  desc.logUser = &host;
  desc.alloc = [](void* user, size_t size, size_t alignment) {
    Host& self = *static_cast<Host*>(user);
    size_t count = 0;
    must(awdGetBasisCount(self.other, &count));
    AWDScene scene = nullptr;
    must(awdNewScene(self.other, &scene));
    awdReleaseScene(scene);
    ++self.allocated;
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  };
  desc.free = [](void* user, void* ptr, size_t, size_t) {
    static_cast<void>(awdGetResultString(0));
    static_cast<Host*>(user)->allocated += 0;
    std::free(ptr);
  };
  desc.allocUser = &host;
  const Device device = newDevice(&desc);
  host.device = device;
  const Field field = newField(device);
  size_t count = 0;
  must(awdGetBasisCount(device, &count));
  EXPECT_GT(host.logged, 0u);
  EXPECT_GT(host.allocated, 0u);
}

}  // namespace
