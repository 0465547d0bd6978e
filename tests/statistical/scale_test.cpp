// SPDX-License-Identifier: Apache-2.0
// An image does not depend on the unit of length, nor on where the scene lies.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 32, kBlock = 8;

Film roomAt(double scale, Vec3 translation, AWDGuide guide, uint64_t seed) {
  SceneBuilder room = lampRoom();
  room.scale(scale);
  room.translate(translation);
  Device device = newDevice();
  const AWDCamera view = lampRoomCamera(kSize, scale, translation);
  return renderFilm(room.commit(device), renderDesc(view, guide, seed), {16, 32, 64});
}

/// Null hypothesis: both films have the same mean in every block and channel. False-alarm rate
/// 1 % a comparison (Bonferroni over its 48 scores).
void expectSameImage(const Film& a, const Film& b) {
  const std::vector<double> scores = blockScores(a, b, kBlock);
  const double limit = familyThreshold(0.01, scores.size());
  std::printf("  largest |z| %.2f of %zu, limit %.2f; standard error of the whole image %.2g\n",
              largest(scores), scores.size(), limit, imageMean(a, 1).error / imageMean(a, 1).mean);
  EXPECT_LT(largest(scores), limit);
}

class Scale : public testing::TestWithParam<AWDGuide> {};
INSTANTIATE_TEST_SUITE_P(Guides, Scale, testing::Values(AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE));

TEST_P(Scale, TinyAndHugeScenesGiveTheSameImageSlow) {
  const Film unit = roomAt(1.0, {}, GetParam(), 1);
  expectSameImage(unit, roomAt(1e-3, {}, GetParam(), 2));
  expectSameImage(unit, roomAt(1e3, {}, GetParam(), 3));
}

TEST_P(Scale, APowerOfTwoGivesTheSameBits) {
  const Film unit = roomAt(1.0, {}, GetParam(), 4);
  for (const double scale : {0x1p10, 0x1p-10}) {
    const Film scaled = roomAt(scale, {}, GetParam(), 4);
    EXPECT_EQ(unit.radiance, scaled.radiance) << scale;
    EXPECT_EQ(unit.variance, scaled.variance) << scale;
  }
}

/// All coordinates are multiples of 1/8 and stay exact.
TEST_P(Scale, FarFromTheOriginTheImageIsTheSameSlow) {
  const Film unit = roomAt(1.0, {}, GetParam(), 5);
  expectSameImage(unit, roomAt(1.0, {4000, -3000, 4000}, GetParam(), 6));
}

}  // namespace
