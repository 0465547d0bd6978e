// SPDX-License-Identifier: Apache-2.0
// Checkpoints that are damaged, or of something else.
#include <filesystem>
#include <fstream>

#include "input/objects.h"
#include "support/random.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

class Checkpoints : public Arguments {
 protected:
  Checkpoints() {
    must(awdRenderPass(render_, 2, nullptr));
    must(awdSaveRender(render_, file_.c_str()));
  }
  void expectRefused(AWDScene scene, AWDField field, const AWDRenderDesc* desc, AWDResult code,
                     const std::vector<std::string>& parts) {
    AWDRender none = render_;
    expectFailure(awdLoadRender(scene, file_.c_str(), field, desc, &none), code, parts);
    EXPECT_EQ(none, nullptr);
  }

  TemporaryFolder folder_;
  const std::string file_ = folder_.path("a.checkpoint");
};

TEST_F(Checkpoints, OfAnotherScene) {
  const auto expectOther = [&](const SceneBuilder& room, const char* part) {
    expectRefused(room.commit(device_), nullptr, nullptr, AWD_ERROR_INVALID_ARGUMENT,
                  {"scene is not the one", file_, part});
  };
  expectOther(sevenLampRoom(), "triangles there");
  SceneBuilder larger = lampRoom(), moved = lampRoom(), other = lampRoom();
  larger.scale(2.0);  // the same, in another unit
  expectOther(larger, "other places");
  moved.translate({0.5, 0, 0});
  expectOther(moved, "other places");
  other.material(grey(0.25));
  expectOther(other, "materials");
  Render same;
  must(awdLoadRender(lampRoom().commit(device_), file_.c_str(), nullptr, nullptr, same.out()));
  Scene open;
  must(awdNewScene(device_, open.out()));
  expectRefused(open, nullptr, nullptr, AWD_ERROR_INVALID_OPERATION, {"awdCommitScene"});
}

TEST_F(Checkpoints, OfOtherSettings) {
  const auto expectOther = [&](const char* part, const auto& change) {
    AWDCamera camera = camera_;
    AWDRenderDesc desc = desc_;
    desc.camera = &camera;
    change(desc, camera);
    expectRefused(scene_, nullptr, &desc, AWD_ERROR_INVALID_ARGUMENT, {part, file_});
  };
  using Desc = AWDRenderDesc;
  using View = AWDCamera;
  expectOther("desc->camera", [](Desc&, View& view) { view.eye[0] += 0.125f; });
  expectOther("desc->camera", [](Desc&, View& view) { ++view.width; });
  expectOther("desc->preset", [](Desc& desc, View&) { desc.preset = AWD_PRESET_PAPER; });
  expectOther("desc->guide", [](Desc& desc, View&) { desc.guide = AWD_GUIDE_COSINE; });
  expectOther("desc->direct", [](Desc& desc, View&) { desc.direct = AWD_DIRECT_NONE; });
  expectOther("desc->roulette", [](Desc& desc, View&) { desc.roulette = AWD_ROULETTE_ALBEDO; });
  expectOther("desc->shadowRays", [](Desc& desc, View&) { desc.shadowRays = 3; });
  expectOther("desc->maxLights", [](Desc& desc, View&) { desc.maxLights = 5; });
  expectOther("desc->seed", [](Desc& desc, View&) { ++desc.seed; });
  expectOther("desc->combination", [](Desc& desc, View&) { desc.combination = AWD_COMBINE_COUNT; });
  expectOther("desc->points", [](Desc& desc, View&) { desc.points = AWD_POINTS_RANDOM; });
  expectOther("desc->maxBytes", [](Desc& desc, View&) { desc.maxBytes = 1u << 30; });
  expectOther("desc->maxSplit", [](Desc& desc, View&) { desc.maxSplit = 2; });
  expectOther("desc->lights", [](Desc& desc, View&) { desc.lights = AWD_LIGHTS_POWER; });
  AWDRenderDesc unset = desc_;
  unset.structSize = 3;
  expectRefused(scene_, nullptr, &unset, AWD_ERROR_INVALID_ARGUMENT, {"structSize"});

  // What an open setting stands for may also be said.
  AWDRenderDesc explicitly = desc_;
  explicitly.maxSplit = 8;
  explicitly.points = AWD_POINTS_SOBOL;
  Render same;
  must(awdLoadRender(scene_, file_.c_str(), field_, &explicitly, same.out()));

  AWDFieldDesc haar = AWD_FIELD_DESC_INIT, rms = haar;
  haar.basis = "haar";
  rms.target = AWD_TARGET_RMS;
  expectRefused(scene_, newField(device_, &haar), &desc_, AWD_ERROR_INVALID_ARGUMENT,
                {"field differs", "its basis", file_});
  expectRefused(scene_, newField(device_, &rms), nullptr, AWD_ERROR_INVALID_ARGUMENT,
                {"field differs", "target"});
}

TEST_F(Checkpoints, ThatAreDamaged) {
  std::ifstream in(file_, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  ASSERT_GT(bytes.size(), 1000u);
  Random random(51);
  const auto below = [&](size_t n) { return static_cast<size_t>(random.uniform() * double(n)); };
  for (int i = 0; i < 200; ++i) {
    std::string damaged = bytes;
    const size_t at = below(i % 2 ? bytes.size() : 300);
    if (i % 3 == 0) {
      damaged.resize(at);
    } else {
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << below(8)));
    }
    std::ofstream(file_, std::ios::binary) << damaged;
    expectRefused(scene_, nullptr, nullptr, AWD_ERROR_IO, {file_});
  }
  std::ofstream(file_, std::ios::binary) << "";
  expectRefused(scene_, nullptr, nullptr, AWD_ERROR_IO, {"0 bytes", "not a checkpoint"});
  must(awdWriteField(field_, file_.c_str()));
  expectRefused(scene_, nullptr, nullptr, AWD_ERROR_IO, {"not a checkpoint"});
  std::filesystem::remove(file_);
  expectRefused(scene_, nullptr, nullptr, AWD_ERROR_IO, {file_, "No such"});
}

TEST_F(Checkpoints, ThatCantBeWritten) {
  const std::string nowhere = folder_.path("no/such/folder");
  expectFailure(awdSaveRender(render_, nowhere.c_str()), AWD_ERROR_IO, {nowhere, "No such"});
  expectFailure(awdSaveRender(render_, nullptr), AWD_ERROR_INVALID_ARGUMENT, {"path"});
  expectFailure(awdSaveRender(nullptr, file_.c_str()), AWD_ERROR_INVALID_ARGUMENT, {"render"});
  AWDRender none = render_;
  expectFailure(awdLoadRender(nullptr, file_.c_str(), nullptr, nullptr, &none),
                AWD_ERROR_INVALID_ARGUMENT, {"scene"});
  expectFailure(awdLoadRender(scene_, nullptr, nullptr, nullptr, &none), AWD_ERROR_INVALID_ARGUMENT,
                {"path"});
  expectFailure(awdLoadRender(scene_, file_.c_str(), nullptr, nullptr, nullptr),
                AWD_ERROR_INVALID_ARGUMENT, {"render"});
}

TEST_F(Checkpoints, SchedulesThatDontGoOnFromThere) {
  const auto expectNot = [&](std::vector<uint32_t> passes, const std::vector<std::string>& parts) {
    AWDSchedule schedule = AWD_SCHEDULE_INIT;
    schedule.samplesPerPass = passes.data();
    schedule.passCount = static_cast<uint32_t>(passes.size());
    schedule.resume = 1;
    expectFailure(awdRenderPasses(render_, &schedule), AWD_ERROR_INVALID_ARGUMENT, parts);
  };
  expectNot({3, 2}, {"resume", "pass 0", "had 2", "has 3"});
  must(awdRenderPass(render_, 5, nullptr));
  expectNot({2}, {"resume", "2 passes", "has 1"});
  EXPECT_EQ(readFilm(render_).samplesPerPixel, 7u);
}

}  // namespace
