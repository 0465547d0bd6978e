// SPDX-License-Identifier: Apache-2.0
// A field trained at low resolution speeds up a final render.
#include <gtest/gtest.h>

#include <cstdio>
#include <vector>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

// What a render of 12 x 12 pixels has learned, saved and loaded, makes one of 48 x 48 pixels better
// at as many samples. Squared errors by the films themselves, over 8 seeds; a fifth less is asked,
// and 0.58 less was seen.
TEST(TrainedField, SpeedsUpALargerRenderSlow) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera small = lampRoomCamera(12), large = lampRoomCamera(48);
  const Render training = newRender(scene, renderDesc(small, AWD_GUIDE_ADAPTIVE, 1));
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = 512;
  must(awdRenderPasses(training, &schedule));
  Field learned;
  must(awdGetRenderField(training, learned.out()));
  must(awdAdaptField(learned, nullptr));
  size_t size = 0;
  must(awdSaveField(learned, nullptr, 0, &size));
  std::vector<char> bytes(size);
  must(awdSaveField(learned, bytes.data(), size, &size));

  schedule.totalSamples = 8;
  double fresh = 0.0, trained = 0.0;
  for (uint64_t seed = 10; seed < 18; ++seed) {
    const AWDRenderDesc desc = renderDesc(large, AWD_GUIDE_ADAPTIVE, seed);
    Field loaded;
    must(awdLoadField(device, bytes.data(), size, loaded.out()));
    for (const AWDField field : {AWDField(nullptr), AWDField(loaded)}) {
      const Render render = newRender(scene, desc, field);
      must(awdRenderPasses(render, &schedule));
      AWDRenderError error = AWD_RENDER_ERROR_INIT;
      must(awdGetRenderError(render, &error));
      (field ? trained : fresh) += error.error * error.error;
    }
  }
  std::printf("  squared error, trained to fresh: %.2f\n", trained / fresh);
  EXPECT_LT(trained, 0.8 * fresh);
}

}  // namespace
