// SPDX-License-Identifier: Apache-2.0
#include "guide/light_sums.h"

#include <gtest/gtest.h>

#include <limits>

namespace awd {
namespace {

LightSums sumsFor(double magnitude) {
  return {std::pmr::get_default_resource(), 2, LightSums::unitExponentFor(magnitude)};
}

TEST(LightSums, AddSquaresOfAnyMagnitude) {
  for (const double unit : {1e-30, 1e-6, 1.0, 1e6, 1e30}) {
    LightSums sums = sumsFor(unit);
    for (int i = 0; i < 1000; ++i) sums.record(1, (i % 4) * unit);
    EXPECT_EQ(sums.count(0), 0u);
    EXPECT_EQ(sums.count(1), 1000u);
    EXPECT_EQ(sums.samples(), 1000u);
    EXPECT_NEAR(sums.squares(1) / (3500.0 * unit * unit), 1.0, 1e-4);
    EXPECT_NEAR(sums.magnitude() / (std::sqrt(3.5) * unit), 1.0, 1e-4);
    EXPECT_EQ(sums.saturated(), 0u);
  }
}

TEST(LightSums, OneGiantSetsTheUnitOfTheNextPass) {
  LightSums sums = sumsFor(1.0);
  for (int i = 0; i < 100000; ++i) sums.record(0, i == 0 ? 1e3 : 1e-3);
  LightSums next = sumsFor(sums.magnitude());
  for (int i = 0; i < 1000; ++i) next.record(0, 1e3);
  EXPECT_EQ(next.saturated(), 0u);
  EXPECT_FALSE(next.overflowed());
  EXPECT_NEAR(next.squares(0), 1e9, 1e3);
}

TEST(LightSums, WhatIsNoLightCountsAsDark) {
  LightSums sums = sumsFor(1.0);
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1.0}) {
    sums.record(0, value);
  }
  EXPECT_EQ(sums.count(0), 3u);
  EXPECT_EQ(sums.squares(0), 0.0);
  EXPECT_EQ(sums.rejected(), 3u);
  sums.record(0, std::numeric_limits<double>::max());
  EXPECT_EQ(sums.saturated(), 1u);
  EXPECT_FALSE(sums.overflowed());
  sums.clear();
  EXPECT_EQ(sums.samples(), 0u);
  EXPECT_EQ(sums.rejected(), 0u);
}

}  // namespace
}  // namespace awd
