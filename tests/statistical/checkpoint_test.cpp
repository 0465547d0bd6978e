// SPDX-License-Identifier: Apache-2.0
// A render that was interrupted, saved and loaded goes on with the bits of one that never was.
#include <gtest/gtest.h>

#include "support/outcome.h"
#include "support/scenes.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

/// Cancels in the middle of a pass.
struct Stopper {
  int passes = 0;
  int stopIn = 0;  // 1 for the first pass; 0: never

  Device device(uint32_t threads) {
    AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
    desc.threads = threads;
    desc.progressUser = this;
    desc.progress = [](void* user, const AWDProgress* progress) -> int32_t {
      Stopper& stopper = *static_cast<Stopper*>(user);
      if (std::string(progress->operation) != "pass") return 1;
      // Each tile reports, the last of each pass the whole; the second of a pass is in its middle.
      const double f = progress->fraction;
      const bool goOn = stopper.passes + 1 != stopper.stopIn || f < 0.3;
      stopper.passes += f == 1.0;
      return goOn;
    };
    return newDevice(&desc);
  }
};

struct Way {
  const char* name;
  AWDRenderDesc desc;
  AWDSchedule schedule;
};

class Checkpoint : public testing::Test {
 protected:
  Checkpoint() {
    AWDRenderDesc paper = renderDesc(view_, AWD_GUIDE_ADAPTIVE, 5);
    paper.preset = AWD_PRESET_PAPER;
    AWDSchedule divided = AWD_SCHEDULE_INIT, listed = divided, few = divided, limited = divided;
    divided.totalSamples = 12;
    listed.samplesPerPass = kPasses;
    listed.passCount = 3;
    few.totalSamples = 4;  // too few for guiding
    limited.error = 1e-9;  // never reached
    limited.totalSamples = 10;
    ways_ = {{"divided", renderDesc(view_, AWD_GUIDE_ADAPTIVE, 7), divided},
             {"paper", paper, listed},
             {"unguided", renderDesc(view_, AWD_GUIDE_COSINE, 7), listed},
             {"few", renderDesc(view_, AWD_GUIDE_ADAPTIVE, 7), few},
             {"limited", renderDesc(view_, AWD_GUIDE_ADAPTIVE, 7), limited}};
  }
  static int passesOf(const Outcome& outcome) {
    return static_cast<int>(outcome.figures.size()) / kFiguresOfAPass;
  }
  Outcome undisturbed(const Way& way) const {
    const Device device = newDevice(1u);
    const Scene scene = room_.commit(device);
    const Render render = newRender(scene, way.desc);
    must(awdRenderPasses(render, &way.schedule));
    return outcomeOf(render);
  }

  static constexpr uint32_t kPasses[] = {2, 3, 4};
  const SceneBuilder room_ = sevenLampRoom();
  const AWDCamera view_ = lampRoomCamera(20);  // 4 tiles, of which 3 are cut
  std::vector<Way> ways_;
  TemporaryFolder folder_;
  const std::string file_ = folder_.path("a.checkpoint");
};

TEST_F(Checkpoint, GoesOnInTheMiddleOfAScheduleSlow) {
  for (const Way& way : ways_) {
    const Outcome whole = undisturbed(way);
    for (int stopIn = 1; stopIn <= passesOf(whole); ++stopIn) {
      SCOPED_TRACE(way.name + std::string(", cancelled in pass ") + std::to_string(stopIn));
      Stopper stopper;
      const Device device = stopper.device(1);
      const Scene scene = room_.commit(device);
      const Render render = newRender(scene, way.desc);
      stopper.stopIn = stopIn;
      ASSERT_EQ(awdRenderPasses(render, &way.schedule), AWD_ERROR_CANCELLED);
      uint32_t passes = 0;
      must(awdGetPassCount(render, &passes));
      ASSERT_EQ(passes, stopIn - 1u);
      must(awdSaveRender(render, file_.c_str()));

      // Here and, as in another process, with other threads, from the file.
      AWDSchedule rest = way.schedule;
      rest.resume = 1;
      stopper.stopIn = 0;
      must(awdRenderPasses(render, &rest));
      expectSameOutcome(outcomeOf(render), whole);

      const Device elsewhere = newDevice(2u);
      const Scene again = room_.commit(elsewhere);
      Render loaded;
      must(awdLoadRender(again, file_.c_str(), nullptr, &way.desc, loaded.out()));
      must(awdRenderPasses(loaded, &rest));
      expectSameOutcome(outcomeOf(loaded), whole);
      // What is complete stays as it is.
      must(awdRenderPasses(loaded, &rest));
      expectSameOutcome(outcomeOf(loaded), whole);
    }
  }
}

TEST_F(Checkpoint, APassAtATimeAndAlwaysFromTheFile) {
  for (const Way& way : ways_) {
    SCOPED_TRACE(way.name);
    const Outcome whole = undisturbed(way);
    const Device device = newDevice(2u);
    const Scene scene = room_.commit(device);
    must(awdSaveRender(newRender(scene, way.desc), file_.c_str()));
    AWDSchedule next = way.schedule;
    next.resume = 1;
    next.maxPasses = 1;
    for (int pass = 0; pass < passesOf(whole); ++pass) {
      Render render;
      must(awdLoadRender(scene, file_.c_str(), nullptr, nullptr, render.out()));
      must(awdRenderPasses(render, &next));
      uint32_t passes = 0;
      must(awdGetPassCount(render, &passes));
      ASSERT_EQ(passes, pass + 1u);
      must(awdSaveRender(render, file_.c_str()));
    }
    Render render;
    must(awdLoadRender(scene, file_.c_str(), nullptr, nullptr, render.out()));
    expectSameOutcome(outcomeOf(render), whole);
    EXPECT_EQ(folder_.files(), 1u);
  }
}

/// A field that had learned before, and passes one by one with the host's own adapt.
TEST_F(Checkpoint, OfPassesOneByOne) {
  const Device device = newDevice(1u);
  const Scene scene = room_.commit(device);
  const AWDRenderDesc desc = renderDesc(view_, AWD_GUIDE_ADAPTIVE, 3);
  const auto rendered = [&](bool interrupted) {
    Field field;
    must(awdNewSceneField(scene, nullptr, field.out()));
    must(awdRenderPass(newRender(scene, desc, field), 3, nullptr));
    must(awdAdaptField(field, nullptr));
    Render render = newRender(scene, desc, field);
    must(awdSetFieldScale(field, 1e3));
    for (const bool adapts : {true, false, false}) {
      must(awdRenderPass(render, 2, nullptr));
      if (adapts) must(awdAdaptField(field, nullptr));
      if (!interrupted) continue;
      must(awdSaveRender(render, file_.c_str()));
      must(awdLoadRender(scene, file_.c_str(), field, &desc, render.out()));
      must(awdGetRenderField(render, field.out()));
    }
    return outcomeOf(render);
  };
  expectSameOutcome(rendered(true), rendered(false));
}

TEST_F(Checkpoint, OfTimeAllThatWasSpentCounts) {
  const Device device = newDevice(1u);
  const Scene scene = room_.commit(device);
  const Render render = newRender(scene, renderDesc(view_, AWD_GUIDE_ADAPTIVE, 3));
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.seconds = 1e-3;
  must(awdRenderPasses(render, &schedule));  // the first pass is rendered whatever it takes
  uint32_t passes = 0;
  must(awdGetPassCount(render, &passes));
  ASSERT_GE(passes, 1u);
  AWDPassStatistics total = AWD_PASS_STATISTICS_INIT;
  must(awdGetRenderStatistics(render, &total));
  schedule.seconds = total.wallSeconds;
  schedule.resume = 1;
  must(awdRenderPasses(render, &schedule));
  uint32_t after = 0;
  must(awdGetPassCount(render, &after));
  EXPECT_EQ(after, passes);
}

}  // namespace
