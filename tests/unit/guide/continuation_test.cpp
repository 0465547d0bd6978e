// SPDX-License-Identifier: Apache-2.0
#include "guide/continuation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace awd {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST(Continuation, IsAWeightWindow) {
  EXPECT_FLOAT_EQ(continuation(1.0f, 0.2f, 1.0f, 8.0f), 0.6f);
  EXPECT_EQ(continuation(1.0f, 0.5f, 1.0f, 8.0f), 1.0f);
  EXPECT_EQ(continuation(0.5f, 2.0f, 1.0f, 8.0f), 1.0f);
  EXPECT_FLOAT_EQ(continuation(2.0f, 5.0f, 4.0f, 8.0f), 2.5f);
  EXPECT_EQ(continuation(1.0f, 100.0f, 1.0f, 8.0f), 8.0f);
  EXPECT_EQ(continuation(1.0f, 100.0f, 1.0f, 1.0f), 1.0f);
}

/// Whatever comes in: a path neither lives for ever nor ends for sure.
TEST(Continuation, IsBoundedForAnyFloats) {
  const float values[] = {0.0f, 1e-45f, 1e-30f, 1.0f, 1e38f, kInfinity, kNaN, -1.0f};
  for (const float throughput : values) {
    for (const float reflected : values) {
      for (const float expected : {1e-45f, 1.0f, 1e38f}) {
        const float rays = continuation(throughput, reflected, expected, 8.0f);
        EXPECT_TRUE(rays >= 0.1f && rays <= 8.0f) << throughput << ' ' << reflected;
      }
    }
  }
}

TEST(RoundedBy, HasTheMean) {
  for (const float mean : {0.0f, 0.1f, 0.75f, 1.0f, 1.25f, 8.0f}) {
    double sum = 0.0;
    for (int i = 0; i < 1000; ++i) sum += roundedBy((i + 0.5) / 1000.0, mean);
    EXPECT_NEAR(sum / 1000.0, static_cast<double>(mean), 1e-3);
  }
  EXPECT_EQ(roundedBy(0.0, 0.0f), 0u);
  EXPECT_EQ(roundedBy(0.0, 1.0f), 1u);
  EXPECT_EQ(roundedBy(0.0, kNaN), 0u);
  EXPECT_EQ(roundedBy(0.5, -1.0f), 0u);
}

}  // namespace
}  // namespace awd
