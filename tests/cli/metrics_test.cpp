// SPDX-License-Identifier: Apache-2.0
#include "metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace command;

namespace {

RgbImage filled(uint32_t width, uint32_t height, float value) {
  return {width, height, std::vector<float>(std::size_t{3} * width * height, value)};
}

TEST(Metrics, AgreeWithNumbersByHand) {
  // Reference: a pixel of 1 and a pixel of 3, mean 2, so the floor is 0.01 * 4 = 0.04.
  const RgbImage reference{2, 1, {1, 1, 1, 3, 3, 3}};
  const RgbImage image{2, 1, {2, 1, 1, 3, 3, 1}};
  const Metrics metrics = compareImages(image, reference);
  EXPECT_DOUBLE_EQ(metrics.l1, (1.0 + 2.0) / 6.0);
  EXPECT_NEAR(metrics.relMse, (1.0 / 3.0 / 1.04 + 4.0 / 3.0 / 9.04) / 2.0, 1e-15);
  EXPECT_DOUBLE_EQ(metrics.relMseTrimmed, metrics.relMse);  // 0.1 % of 2 pixels is none
  EXPECT_DOUBLE_EQ(metrics.mean[0], 2.5);
  EXPECT_DOUBLE_EQ(metrics.mean[1], 2.0);
  EXPECT_DOUBLE_EQ(metrics.mean[2], 1.0);
  for (const double channel : metrics.meanReference) EXPECT_DOUBLE_EQ(channel, 2.0);
}

TEST(Metrics, OfAnImageAndItselfAreZero) {
  const Metrics metrics = compareImages(filled(7, 5, 0.3f), filled(7, 5, 0.3f));
  EXPECT_EQ(metrics.l1, 0.0);
  EXPECT_EQ(metrics.relMse, 0.0);
  EXPECT_EQ(metrics.relMseTrimmed, 0.0);
}

TEST(Metrics, TrimmingDropsTheWorstThousandth) {
  // 2500 pixels: two are dropped, the worst two of three.
  const RgbImage reference = filled(50, 50, 1.0f);
  RgbImage image = reference;
  for (std::size_t c = 0; c < 3; ++c) {
    image.values[3 * 17 + c] = 101.0f;
    image.values[3 * 1200 + c] = 11.0f;
    image.values[3 * 2499 + c] = 2.0f;
  }
  const Metrics metrics = compareImages(image, reference);
  EXPECT_NEAR(metrics.relMse, (10000.0 + 100.0 + 1.0) / 1.01 / 2500.0, 1e-12);
  EXPECT_NEAR(metrics.relMseTrimmed, 1.0 / 1.01 / 2498.0, 1e-15);
}

TEST(Metrics, TheReferencesVarianceIsTakenOffWhatIsKept) {
  const RgbImage reference = filled(50, 50, 1.0f);
  RgbImage image = filled(50, 50, 2.0f);
  RgbImage variance = filled(50, 50, 0.25f);
  for (std::size_t c = 0; c < 3; ++c) {
    image.values[3 * 17 + c] = 101.0f;
    image.values[3 * 1200 + c] = 11.0f;
    // Dropped for what is seen, not for what is left of it.
    variance.values[3 * 17 + c] = 20000.0f;
  }
  const Metrics metrics = compareImages(image, reference, variance);
  const double kept = 2498.0 * 0.75 / 1.01;
  EXPECT_NEAR(metrics.relMseTrimmed, kept / 2498.0, 1e-12);
  EXPECT_NEAR(metrics.relMse, (kept + (10000.0 - 20000.0 + 99.75) / 1.01) / 2500.0, 1e-12);
  EXPECT_DOUBLE_EQ(metrics.l1, (2498.0 + 100.0 + 10.0) / 2500.0);
}

TEST(Metrics, RelativeErrorAgainstBlackIsUndefined) {
  const Metrics metrics = compareImages(filled(2, 2, 1.0f), filled(2, 2, 0.0f));
  EXPECT_EQ(metrics.l1, 1.0);
  EXPECT_TRUE(std::isnan(metrics.relMse));
  EXPECT_TRUE(std::isnan(metrics.relMseTrimmed));
}

TEST(Metrics, CountsPixelsNotChannels) {
  RgbImage image = filled(3, 2, 1.0f);
  EXPECT_EQ(countNonFinite(image), 0u);
  image.values[0] = image.values[2] = std::numeric_limits<float>::quiet_NaN();
  image.values[16] = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(countNonFinite(image), 2u);
}

TEST(Metrics, BoxFilterAverages) {
  RgbImage image{4, 2, {}};
  for (int i = 0; i < 8; ++i) {
    for (int c = 0; c < 3; ++c) image.values.push_back(static_cast<float>(i + 100 * c));
  }
  const RgbImage half = boxFilter(image, 2);
  EXPECT_EQ(half.width, 2u);
  EXPECT_EQ(half.height, 1u);
  // Pixels 0 1 4 5 and 2 3 6 7.
  EXPECT_EQ(half.values, (std::vector<float>{2.5f, 102.5f, 202.5f, 4.5f, 104.5f, 204.5f}));
}

TEST(Metrics, SizeRatioIsWholeAndTheSameBothWays) {
  EXPECT_EQ(sizeRatio(filled(8, 4, 0), filled(2, 1, 0)), std::optional<uint32_t>(4));
  EXPECT_EQ(sizeRatio(filled(8, 4, 0), filled(8, 4, 0)), std::optional<uint32_t>(1));
  EXPECT_FALSE(sizeRatio(filled(8, 4, 0), filled(2, 2, 0)));
  EXPECT_FALSE(sizeRatio(filled(8, 4, 0), filled(3, 1, 0)));
  EXPECT_FALSE(sizeRatio(filled(2, 1, 0), filled(8, 4, 0)));
}

}  // namespace
