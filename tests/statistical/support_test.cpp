// SPDX-License-Identifier: Apache-2.0
// The yardsticks of the statistical tests, against values from tables.
#include <gtest/gtest.h>

#include "support/statistics.h"

namespace {

using namespace awdtest;

TEST(Support, FamilyThresholdIsTheTwoSidedNormalQuantile) {
  EXPECT_NEAR(familyThreshold(0.05, 1), 1.959964, 1e-6);
  EXPECT_NEAR(familyThreshold(0.01, 1), 2.575829, 1e-6);
  EXPECT_NEAR(familyThreshold(0.01, 10), 3.290527, 1e-6);
}

TEST(Support, ChiSquareTailAgreesWithTables) {
  EXPECT_NEAR(chiSquareTail(3.841459, 1), 0.05, 1e-7);
  EXPECT_NEAR(chiSquareTail(23.209251, 10), 0.01, 1e-8);
  EXPECT_NEAR(chiSquareTail(3.940299, 10), 0.95, 1e-7);
  EXPECT_NEAR(chiSquareTail(124.342113, 100), 0.05, 1e-7);
}

TEST(Support, ZScoreOfEqualExactValuesIsZeroAndOfUnequalOnesInfinite) {
  EXPECT_EQ(zScore({1.0, 0.0}, {1.0, 0.0}), 0.0);
  EXPECT_EQ(largest({0.5, zScore({1.0, 0.0}, {2.0, 0.0})}), HUGE_VAL);
  EXPECT_DOUBLE_EQ(zScore({5.0, 3.0}, {0.0, 4.0}), 1.0);
}

}  // namespace
