// SPDX-License-Identifier: Apache-2.0
// Arguments that no call can take: NULL, numbers outside of enumerations, cameras that see
// nothing, schedules without samples.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr AWDResult kInvalid = AWD_ERROR_INVALID_ARGUMENT;

/// One good object of each kind.
class Arguments : public testing::Test {
 protected:
  Arguments()
      : device_(newDevice(1u)),
        scene_(lampRoom().commit(device_)),
        field_(newField(device_)),
        camera_(lampRoomCamera(4)),
        desc_(renderDesc(camera_, AWD_GUIDE_ADAPTIVE, 1)),
        render_(newRender(scene_, desc_, field_)) {
    must(awdNewImage(device_, 2, 2, image_.out()));
  }

  void expectNoRender(const AWDRenderDesc& desc, const std::vector<std::string>& parts) {
    AWDRender render = render_;
    expectFailure(awdNewRender(scene_, nullptr, &desc, &render), kInvalid, parts);
    EXPECT_EQ(render, nullptr);
  }

  Device device_;
  Scene scene_;
  Field field_;
  AWDCamera camera_;
  AWDRenderDesc desc_;
  Render render_;
  Image image_;
  const float up_[3] = {0, 0, 1};
  const double uniforms_[3] = {0.5, 0.5, 0.5};
  float floats_[64] = {};
};

TEST_F(Arguments, NullHandles) {
  const AWDMaterialDesc material = AWD_MATERIAL_DESC_INIT;
  const AWDMeshDesc mesh = AWD_MESH_DESC_INIT;
  const AWDRay ray = {{0, 0, 0}, 0, {0, 0, 1}, 1};
  AWDHit hit;
  AWDScene scene;
  AWDField field;
  AWDRender render;
  AWDImage image;
  AWDBasisInfo basisInfo = AWD_BASIS_INFO_INIT;
  AWDSceneInfo sceneInfo = AWD_SCENE_INFO_INIT;
  AWDPatchInfo patchInfo = AWD_PATCH_INFO_INIT;
  AWDFieldStatistics fieldFigures = AWD_FIELD_STATISTICS_INIT;
  AWDPassStatistics passFigures = AWD_PASS_STATISTICS_INIT;
  AWDDirectionSample sample = {};
  must(awdSampleField(field_, 0, up_, uniforms_, &sample));
  uint8_t occluded;
  uint32_t id;
  size_t count;
  double coefficients[64];
  const char* text;
  const std::function<AWDResult()> calls[] = {
      [&] { return awdLoadBasisModule(nullptr, "/nowhere"); },
      [&] { return awdGetBasisCount(nullptr, &count); },
      [&] { return awdGetBasisInfo(nullptr, 0, &basisInfo); },
      [&] { return awdNewScene(nullptr, &scene); },
      [&] { return awdAddMaterial(nullptr, &material, &id); },
      [&] { return awdAddMesh(nullptr, &mesh, &id); },
      [&] { return awdCommitScene(nullptr); },
      [&] { return awdGetSceneInfo(nullptr, &sceneInfo); },
      [&] { return awdIntersect(nullptr, &ray, 1, &hit); },
      [&] { return awdOccluded(nullptr, &ray, 1, &occluded); },
      [&] { return awdGetTrianglePatch(nullptr, 0, 0, 0, &id); },
      [&] { return awdGetPointPatch(nullptr, up_, &id); },
      [&] { return awdNewField(nullptr, nullptr, &field); },
      [&] { return awdSampleField(nullptr, 0, up_, uniforms_, &sample); },
      [&] { return awdGetFieldPdf(nullptr, 0, up_, up_, floats_); },
      [&] { return awdRecordField(nullptr, 0, &sample, 1.0); },
      [&] { return awdSetFieldScale(nullptr, 1.0); },
      [&] { return awdMarkField(nullptr); },
      [&] { return awdRevertField(nullptr); },
      [&] { return awdAdaptField(nullptr, &fieldFigures); },
      [&] { return awdGetFieldStatistics(nullptr, &fieldFigures); },
      [&] { return awdGetFieldPatches(nullptr, nullptr, 0, &count); },
      [&] { return awdGetPatchInfo(nullptr, 0, &patchInfo); },
      [&] { return awdGetPatchCoefficients(nullptr, 0, coefficients, 64); },
      [&] { return awdGetPatchPdf(nullptr, 0, 2, floats_, 0); },
      [&] { return awdNewRender(nullptr, nullptr, &desc_, &render); },
      [&] { return awdGetRenderField(nullptr, &field); },
      [&] { return awdRenderPass(nullptr, 1, &passFigures); },
      [&] { return awdRenderPasses(nullptr, nullptr); },
      [&] { return awdGetPassCount(nullptr, &id); },
      [&] { return awdGetPassStatistics(nullptr, 0, &passFigures); },
      [&] { return awdGetRenderStatistics(nullptr, &passFigures); },
      [&] { return awdReadFilm(nullptr, AWD_FILM_RADIANCE, floats_, 0, 0); },
      [&] { return awdGetFilmInfo(nullptr, &id, nullptr, nullptr); },
      [&] { return awdGetPixelPatch(nullptr, 0, 0, &id); },
      [&] { return awdNewImage(nullptr, 1, 1, &image); },
      [&] { return awdNewFilmImage(nullptr, &image); },
      [&] { return awdNewPatchImage(nullptr, 0, 2, &image); },
      [&] { return awdReadImage(nullptr, "/nowhere", &image); },
      [&] { return awdGetImageInfo(nullptr, &id, nullptr, nullptr); },
      [&] { return awdGetImageChannelName(nullptr, 0, &text); },
      [&] { return awdSetImageChannel(nullptr, "Y", floats_, 0, 0); },
      [&] { return awdGetImageChannel(nullptr, "Y", floats_, 0, 0); },
      [&] { return awdSetImageMetadata(nullptr, "key", "value"); },
      [&] { return awdGetImageMetadata(nullptr, "key", &text); },
      [&] { return awdWriteImageEXR(nullptr, "/nowhere"); },
      [&] { return awdWriteImagePNG(nullptr, "/nowhere", nullptr); },
  };
  int number = 0;
  for (const auto& call : calls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {"NULL"});
  }
}

TEST_F(Arguments, NullOutputsAndInputs) {
  const AWDRay ray = {{0, 0, 0}, 0, {0, 0, 1}, 1};
  AWDHit hit;
  AWDDirectionSample sample = {};
  uint8_t occluded;
  uint32_t id;
  size_t count;
  const char* text;
  AWDRender render;
  must(awdSetImageChannel(image_, "Y", floats_, 0, 0));
  const std::function<AWDResult()> calls[] = {
      [&] { return awdNewDevice(nullptr, nullptr); },
      [&] { return awdLoadBasisModule(device_, nullptr); },
      [&] { return awdRegisterBasisModule(device_, nullptr); },
      [&] { return awdGetBasisCount(device_, nullptr); },
      [&] { return awdGetBasisInfo(device_, 0, nullptr); },
      [&] { return awdNewScene(device_, nullptr); },
      [&] { return awdAddMaterial(scene_, nullptr, &id); },
      [&] { return awdAddMesh(scene_, nullptr, &id); },
      [&] { return awdGetSceneInfo(scene_, nullptr); },
      [&] { return awdIntersect(scene_, nullptr, 1, &hit); },
      [&] { return awdIntersect(scene_, &ray, 1, nullptr); },
      [&] { return awdOccluded(scene_, nullptr, 1, &occluded); },
      [&] { return awdOccluded(scene_, &ray, 1, nullptr); },
      [&] { return awdGetTrianglePatch(scene_, 0, 0, 0, nullptr); },
      [&] { return awdGetPointPatch(scene_, nullptr, &id); },
      [&] { return awdGetPointPatch(scene_, up_, nullptr); },
      [&] { return awdNewField(device_, nullptr, nullptr); },
      [&] { return awdSampleField(field_, 0, nullptr, uniforms_, &sample); },
      [&] { return awdSampleField(field_, 0, up_, nullptr, &sample); },
      [&] { return awdSampleField(field_, 0, up_, uniforms_, nullptr); },
      [&] { return awdGetFieldPdf(field_, 0, nullptr, up_, floats_); },
      [&] { return awdGetFieldPdf(field_, 0, up_, nullptr, floats_); },
      [&] { return awdGetFieldPdf(field_, 0, up_, up_, nullptr); },
      [&] { return awdRecordField(field_, 0, nullptr, 1.0); },
      [&] { return awdGetFieldStatistics(field_, nullptr); },
      [&] { return awdGetFieldPatches(field_, nullptr, 1, &count); },
      [&] { return awdGetFieldPatches(field_, &id, 1, nullptr); },
      [&] { return awdGetPatchInfo(field_, 0, nullptr); },
      [&] { return awdGetPatchCoefficients(field_, 0, nullptr, 4096); },
      [&] { return awdGetPatchPdf(field_, 0, 2, nullptr, 0); },
      [&] { return awdNewRender(scene_, nullptr, nullptr, &render); },
      [&] { return awdNewRender(scene_, nullptr, &desc_, nullptr); },
      [&] { return awdGetRenderField(render_, nullptr); },
      [&] { return awdGetPassCount(render_, nullptr); },
      [&] { return awdGetRenderStatistics(render_, nullptr); },
      [&] { return awdReadFilm(render_, AWD_FILM_RADIANCE, nullptr, 0, 0); },
      [&] { return awdGetPixelPatch(render_, 0, 0, nullptr); },
      [&] { return awdNewImage(device_, 1, 1, nullptr); },
      [&] { return awdNewFilmImage(render_, nullptr); },
      [&] { return awdNewPatchImage(field_, 0, 2, nullptr); },
      [&] { return awdReadImage(device_, "/nowhere", nullptr); },
      [&] { return awdReadImage(device_, nullptr, image_.out()); },
  };
  int number = 0;
  for (const auto& call : calls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {"NULL"});
  }
  must(awdNewImage(device_, 2, 2, image_.out()));
  must(awdSetImageChannel(image_, "Y", floats_, 0, 0));
  const std::function<AWDResult()> imageCalls[] = {
      [&] { return awdGetImageChannelName(image_, 0, nullptr); },
      [&] { return awdSetImageChannel(image_, nullptr, floats_, 0, 0); },
      [&] { return awdSetImageChannel(image_, "Y", nullptr, 0, 0); },
      [&] { return awdGetImageChannel(image_, nullptr, floats_, 0, 0); },
      [&] { return awdGetImageChannel(image_, "Y", nullptr, 0, 0); },
      [&] { return awdSetImageMetadata(image_, nullptr, "value"); },
      [&] { return awdGetImageMetadata(image_, nullptr, &text); },
      [&] { return awdGetImageMetadata(image_, "key", nullptr); },
      [&] { return awdWriteImageEXR(image_, nullptr); },
      [&] { return awdWriteImagePNG(image_, nullptr, nullptr); },
  };
  for (const auto& call : imageCalls) {
    SCOPED_TRACE(number++);
    expectFailure(call(), kInvalid, {"NULL"});
  }
}

TEST_F(Arguments, NullWhereItMeansNothingIsFine) {
  awdRetainDevice(nullptr), awdReleaseDevice(nullptr);
  awdRetainScene(nullptr), awdReleaseScene(nullptr);
  awdRetainField(nullptr), awdReleaseField(nullptr);
  awdRetainRender(nullptr), awdReleaseRender(nullptr);
  awdRetainImage(nullptr), awdReleaseImage(nullptr);
  EXPECT_EQ(awdIntersect(scene_, nullptr, 0, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdOccluded(scene_, nullptr, 0, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdGetFilmInfo(render_, nullptr, nullptr, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdGetImageInfo(image_, nullptr, nullptr, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdSetImageMetadata(image_, "key", nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdRenderPass(render_, 1, nullptr), AWD_SUCCESS);
  EXPECT_EQ(awdAdaptField(field_, nullptr), AWD_SUCCESS);
}

TEST_F(Arguments, HandleOutputsAreNullAfterAFailure) {
  void* const rubbish = &floats_;
  AWDField field = static_cast<AWDField>(rubbish);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "nonesuch";
  EXPECT_NE(awdNewField(device_, &desc, &field), AWD_SUCCESS);
  EXPECT_EQ(field, nullptr);
  AWDScene scene = static_cast<AWDScene>(rubbish);
  EXPECT_NE(awdNewScene(nullptr, &scene), AWD_SUCCESS);
  EXPECT_EQ(scene, nullptr);
  AWDImage image = static_cast<AWDImage>(rubbish);
  EXPECT_NE(awdReadImage(device_, "/nonexistent/file.exr", &image), AWD_SUCCESS);
  EXPECT_EQ(image, nullptr);
  image = static_cast<AWDImage>(rubbish);
  EXPECT_NE(awdNewImage(device_, 0, 1, &image), AWD_SUCCESS);
  EXPECT_EQ(image, nullptr);
  AWDDevice device = static_cast<AWDDevice>(rubbish);
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.structSize = 3;
  EXPECT_NE(awdNewDevice(&deviceDesc, &device), AWD_SUCCESS);
  EXPECT_EQ(device, nullptr);
}

TEST_F(Arguments, UnknownEnumerators) {
  for (const int32_t bad : {-1, 3, 77}) {
    AWDRenderDesc desc = desc_;
    desc.guide = bad;
    expectNoRender(desc, {"guide", std::to_string(bad)});
    desc = desc_;
    desc.direct = bad;
    expectNoRender(desc, {"direct", std::to_string(bad)});
    desc = desc_;
    desc.roulette = bad;
    expectNoRender(desc, {"roulette", std::to_string(bad)});
    desc = desc_;
    desc.preset = bad;
    expectNoRender(desc, {"preset", std::to_string(bad)});
    AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.preset = bad;
    AWDField field;
    expectFailure(awdNewField(device_, &fieldDesc, &field), kInvalid,
                  {"preset", std::to_string(bad)});
    fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.map = bad;
    expectFailure(awdNewField(device_, &fieldDesc, &field), kInvalid, {"map", std::to_string(bad)});
    expectFailure(awdReadFilm(render_, bad, floats_, 0, 0), kInvalid,
                  {"layer", std::to_string(bad)});
  }
  expectFailure(awdReadFilm(render_, 0, floats_, 0, 0), kInvalid, {"layer"});
}

TEST_F(Arguments, StructsOfAnotherVersion) {
  AWDRenderDesc desc = desc_;
  desc.structSize = 0;
  expectNoRender(desc, {"structSize", "AWD_RENDER_DESC_INIT"});

  struct Longer {
    AWDRenderDesc known;
    uint64_t later;
  } longer = {desc_, 0};
  longer.known.structSize = sizeof longer;
  Render render;
  must(awdNewRender(scene_, nullptr, &longer.known, render.out()));
  longer.later = 1;
  expectNoRender(longer.known, {std::to_string(sizeof(AWDRenderDesc))});

  // An output as a former version knew it: what lies behind is not written.
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  info.structSize = offsetof(AWDSceneInfo, lights);
  info.lights = 12345;
  must(awdGetSceneInfo(scene_, &info));
  EXPECT_GT(info.triangles, 0u);
  EXPECT_EQ(info.lights, 12345u);
}

TEST_F(Arguments, DegenerateCameras) {
  const auto spoil = [&](const std::function<void(AWDCamera&)>& change, const std::string& name) {
    AWDCamera camera = camera_;
    change(camera);
    AWDRenderDesc desc = desc_;
    desc.camera = &camera;
    expectNoRender(desc, {name});
  };
  for (const float bad : {kNaN, kInfinity}) {
    spoil([&](AWDCamera& c) { c.eye[1] = bad; }, "eye");
    spoil([&](AWDCamera& c) { c.lookDir[2] = bad; }, "lookDir");
    spoil([&](AWDCamera& c) { c.up[0] = bad; }, "up");
  }
  spoil([](AWDCamera& c) { c.lookDir[0] = c.lookDir[1] = c.lookDir[2] = 0.0f; }, "lookDir");
  spoil([](AWDCamera& c) { c.up[0] = c.up[1] = c.up[2] = 0.0f; }, "up");
  spoil([](AWDCamera& c) { std::copy(c.lookDir, c.lookDir + 3, c.up); }, "up");
  spoil(
      [](AWDCamera& c) {
        for (size_t i = 0; i < 3; ++i) c.up[i] = -7.0f * c.lookDir[i];
      },
      "up");
  for (const float bad : {0.0f, -0.5f, kNaN, kInfinity}) {
    spoil([&](AWDCamera& c) { c.tanHalfFovX = bad; }, "tanHalfFovX");
  }
  for (const uint32_t bad : {0u, 65537u, 0xFFFFFFFFu}) {
    spoil([&](AWDCamera& c) { c.width = bad; }, std::to_string(bad) + " x 4");
    spoil([&](AWDCamera& c) { c.height = bad; }, "4 x " + std::to_string(bad));
  }
  spoil([](AWDCamera& c) { c.structSize = 1; }, "structSize");
  AWDRenderDesc desc = desc_;
  desc.camera = nullptr;
  expectNoRender(desc, {"camera", "NULL"});
}

/// Long vectors and a slanted up are fine.
TEST_F(Arguments, CamerasAreMadeOrthonormal) {
  AWDCamera sloppy = camera_;
  const Film exact = renderFilm(scene_, desc_, {4});
  for (size_t i = 0; i < 3; ++i) {
    sloppy.up[i] = 1024.0f * sloppy.up[i];
    sloppy.lookDir[i] *= 0x1p-30f;
  }
  AWDRenderDesc desc = desc_;
  desc.camera = &sloppy;
  const Film film = renderFilm(scene_, desc, {4});
  for (size_t i = 0; i < film.radiance.size(); ++i) {
    EXPECT_NEAR(film.radiance[i], exact.radiance[i], 1e-3f + 1e-3f * exact.radiance[i]);
  }
}

TEST_F(Arguments, RenderSettingsOutOfRange) {
  AWDRenderDesc desc = desc_;
  desc.shadowRays = 1025;
  expectNoRender(desc, {"shadowRays", "1025", "1024"});
  desc.shadowRays = 1024;
  Render render;
  must(awdNewRender(scene_, nullptr, &desc, render.out()));
}

TEST_F(Arguments, OnlyAnAdaptiveRenderHasAField) {
  AWDField field = field_;
  desc_.guide = AWD_GUIDE_COSINE;
  must(awdGetRenderField(newRender(scene_, desc_, field_), &field));
  EXPECT_EQ(field, nullptr);
  must(awdGetRenderField(render_, &field));
  EXPECT_EQ(field, field_);
  awdReleaseField(field);
}

TEST_F(Arguments, Seeds) {
  for (const uint64_t seed : {uint64_t{0}, ~uint64_t{0}, uint64_t{1} << 63}) {
    desc_.seed = seed;
    const Film film = renderFilm(scene_, desc_, {2, 2});
    EXPECT_EQ(film.samplesPerPixel, 4u);
    for (const float value : film.radiance) EXPECT_TRUE(std::isfinite(value) && value >= 0.0f);
  }
}

TEST_F(Arguments, SchedulesWithoutSamples) {
  expectFailure(awdRenderPass(render_, 0, nullptr), kInvalid, {"samplesPerPixel", "0"});
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  const uint32_t passes[] = {1, 0, 1};
  schedule.samplesPerPass = passes;
  schedule.passCount = 3;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"samplesPerPass[1]"});
  schedule.passCount = 0;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"passCount"});
  schedule = AWD_SCHEDULE_INIT;
  schedule.passCount = 3;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"samplesPerPass"});
  uint32_t count = 77;
  must(awdGetPassCount(render_, &count));
  EXPECT_EQ(count, 0u) << "a refused schedule runs nothing";
  AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
  expectFailure(awdGetPassStatistics(render_, 0, &figures), kInvalid, {"index", "0"});
  expectFailure(awdGetPixelPatch(render_, 4, 0, &count), kInvalid, {"(4, 0)", "4 x 4"});
  expectFailure(awdGetPixelPatch(render_, 0, 4, &count), kInvalid, {"(0, 4)", "4 x 4"});
}

/// 0 stands for the preset's schedule; a total is divided without loss.
TEST_F(Arguments, SchedulesByTheLibrary) {
  AWDRenderDesc desc = desc_;
  desc.preset = AWD_PRESET_PAPER;
  const Render paper = newRender(scene_, desc);
  must(awdRenderPasses(paper, nullptr));
  uint64_t samples = 0;
  must(awdGetFilmInfo(paper, nullptr, nullptr, &samples));
  EXPECT_EQ(samples, 100u);
  uint32_t count = 0;
  must(awdGetPassCount(paper, &count));
  EXPECT_EQ(count, 4u);
  for (const uint32_t total : {1u, 2u, 3u, 7u, 100u, 1000u}) {
    for (const AWDPreset preset : {AWD_PRESET_DEFAULT, AWD_PRESET_PAPER}) {
      desc.preset = preset;
      const Render render = newRender(scene_, desc);
      AWDSchedule schedule = AWD_SCHEDULE_INIT;
      schedule.totalSamples = total;
      must(awdRenderPasses(render, &schedule));
      must(awdGetFilmInfo(render, nullptr, nullptr, &samples));
      EXPECT_EQ(samples, total);
    }
  }
}

TEST_F(Arguments, FieldSettingsOutOfRange) {
  AWDField field;
  const auto refused = [&](const AWDFieldDesc& desc, const std::vector<std::string>& parts) {
    expectFailure(awdNewField(device_, &desc, &field), kInvalid, parts);
  };
  for (const double bad : {1.5, std::nan(""), HUGE_VAL}) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.tau = bad;
    refused(desc, {"tau"});
  }
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.startLevel = AWD_LEVEL(4);
  desc.maxLevel = AWD_LEVEL(3);
  refused(desc, {"startLevel", "maxLevel"});
  desc.maxLevel = desc.startLevel = AWD_LEVEL(60);
  refused(desc, {"evel"});
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    expectFailure(awdSetFieldScale(field_, bad), kInvalid, {"magnitude"});
  }
  for (const uint32_t bad : {0u, 16385u}) {
    expectFailure(awdGetPatchPdf(field_, 0, bad, floats_, 0), kInvalid, {"n", "16384"});
    AWDImage image;
    expectFailure(awdNewPatchImage(field_, 0, bad, &image), kInvalid, {"n", "16384"});
  }
  double one;
  expectFailure(awdGetPatchCoefficients(field_, 0, &one, 1), kInvalid, {"capacity", "1"});
}

TEST_F(Arguments, UnknownBasisNamesThePathsTried) {
  const char* folder = "/nonexistent/bases";
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.basisPaths = &folder;
  deviceDesc.basisPathCount = 1;
  const Device device = newDevice(&deviceDesc);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "nonesuch";
  AWDField field;
  expectFailure(awdNewField(device, &desc, &field), AWD_ERROR_UNSUPPORTED,
                {"nonesuch", "/nonexistent/bases", "awd/bases-1", "haar"});
  for (const char* odd : {"", "Haar", "../haar", "haar "}) {
    desc.basis = odd;
    EXPECT_NE(awdNewField(device, &desc, &field), AWD_SUCCESS) << odd;
  }
}

TEST_F(Arguments, ModulesThatAreNone) {
  expectFailure(awdLoadBasisModule(device_, "/nonexistent/module.so"), AWD_ERROR_PLUGIN_LOAD,
                {"/nonexistent/module.so"});
  expectFailure(awdLoadBasisModule(device_, "relative/module.so"), kInvalid, {"absolute"});
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  const char* relative = "relative";
  desc.basisPaths = &relative;
  desc.basisPathCount = 1;
  AWDDevice device;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"basisPaths", "relative"});
  desc.basisPaths = nullptr;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"basisPaths"});
  size_t count = 0;
  must(awdGetBasisCount(device_, &count));
  AWDBasisInfo info = AWD_BASIS_INFO_INIT;
  expectFailure(awdGetBasisInfo(device_, count, &info), kInvalid, {"index"});
}

TEST_F(Arguments, HalfAnAllocator) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.alloc = [](void*, size_t, size_t) -> void* { return nullptr; };
  AWDDevice device;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"free"});
  desc = AWD_DEVICE_DESC_INIT;
  desc.free = [](void*, void*, size_t, size_t) {};
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"alloc"});
  desc = AWD_DEVICE_DESC_INIT;
  desc.flags = 0x100u;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"flags"});
}

TEST_F(Arguments, ResultsHaveNames) {
  for (AWDResult code = AWD_SUCCESS; code >= AWD_ERROR_PLUGIN_SELF_TEST; --code) {
    EXPECT_STRNE(awdGetResultString(code), "") << code;
  }
  EXPECT_NE(awdGetResultString(12345), nullptr);
  EXPECT_NE(awdGetResultString(-12345), nullptr);
}

}  // namespace
