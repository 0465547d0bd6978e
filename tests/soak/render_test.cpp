// SPDX-License-Identifier: Apache-2.0
// A render of a thousand passes: no drift, no growth, the same bits whatever the threads, and the
// same bits from a checkpoint after any of them.
#include <gtest/gtest.h>

#include "support/counting_allocator.h"
#include "support/outcome.h"
#include "support/scenes.h"
#include "support/soak.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 16;
constexpr uint64_t kFieldBytes = 1 << 20;

/// One more pass of one sample per pixel, with the adapt before it.
void goOn(AWDRender render, uint32_t passes) {
  const std::vector<uint32_t> plan(passes, 1u);
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = plan.data();
  schedule.passCount = passes;
  schedule.resume = 1;
  must(awdRenderPasses(render, &schedule));
}

AWDFieldDesc fieldDesc() {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.maxBytes = kFieldBytes;  // which it reaches: from then on it can't grow
  return desc;
}

uint64_t bytesOf(AWDRender render) {
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  must(awdGetRenderStatistics(render, &statistics));
  return statistics.bytes;
}

TEST(Render, OfAThousandPasses) {
  const auto passes = static_cast<uint32_t>(soakSize(8, 1000));
  const SceneBuilder room = sevenLampRoom();
  const AWDCamera view = lampRoomCamera(kSize);
  const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_ADAPTIVE, 11);
  const AWDFieldDesc learns = fieldDesc();
  CountingAllocator allocator;
  const AWDDeviceDesc deviceDesc = allocator.desc(1);
  const Device device = newDevice(&deviceDesc), elsewhere = newDevice(3u);
  const Scene scene = room.commit(device), again = room.commit(elsewhere);
  const TemporaryFolder folder;
  const std::string file = folder.path("checkpoint");

  Field field;
  must(awdNewSceneField(scene, &learns, field.out()));
  const Render render = newRender(scene, desc, field);
  size_t held = 0;
  for (uint32_t pass = 0; pass < passes; ++pass) {
    SCOPED_TRACE("after pass " + std::to_string(pass));
    must(awdSaveRender(render, file.c_str()));
    Render loaded;
    must(awdLoadRender(again, file.c_str(), nullptr, &desc, loaded.out()));
    goOn(loaded, pass + 1);
    goOn(render, pass + 1);
    ASSERT_TRUE(readFilm(loaded).radiance == readFilm(render).radiance);
    ASSERT_TRUE(fieldBytes(loaded) == fieldBytes(render));
    ASSERT_LE(bytesOf(render), 2 * kFieldBytes);
    if (pass == passes / 2) held = allocator.held();
  }
  // The figures of the passes are kept, in a vector that grows by doubling; all else is there.
  EXPECT_LE(allocator.held(), held + kFieldBytes / 4 + 3 * passes * sizeof(AWDPassStatistics));

  // Null hypothesis: the mean over the image is that of an unguided render. One test a channel,
  // false alarms 1 in 10^4 in all.
  const Film guided = readFilm(render);
  EXPECT_EQ(guided.samplesPerPixel, passes);
  const Film unguided = renderFilm(scene, renderDesc(view, AWD_GUIDE_COSINE, 12), {8 * passes});
  std::vector<double> scores;
  for (size_t channel = 0; channel < 3; ++channel) {
    scores.push_back(zScore(imageMean(guided, channel), imageMean(unguided, channel)));
  }
  EXPECT_LT(largest(scores), familyThreshold(1e-4, 3));
}

}  // namespace
