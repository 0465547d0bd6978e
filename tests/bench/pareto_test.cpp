// SPDX-License-Identifier: Apache-2.0
// The plane of cost and error, where the answers are known.
#include "pareto.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace bench;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Pareto, KeepsWhatNoOtherBeats) {
  EXPECT_EQ(paretoFront({{1, 9}, {2, 5}, {3, 6}, {4, 1}, {4, 2}}),
            (std::vector<bool>{true, true, false, true, false}));
  EXPECT_TRUE(paretoFront({}).empty());
}

TEST(Pareto, EqualPointsDoNotBeatEachOther) {
  EXPECT_EQ(paretoFront({{1, 1}, {1, 1}, {1, 2}}), (std::vector<bool>{true, true, false}));
}

TEST(Pareto, AThirdFigureCanKeepAPoint) {
  EXPECT_EQ(paretoFront({{1, 1, 8}, {2, 2, 4}, {2, 2, 9}}), (std::vector<bool>{true, true, false}));
}

TEST(Pareto, WhatIsNotFiniteNeitherStaysNorBeats) {
  EXPECT_EQ(paretoFront({{kNaN, 0}, {1, 1}, {-HUGE_VAL, 0}}),
            (std::vector<bool>{false, true, false}));
}

TEST(TimeToError, IsALineInLogarithms) {
  // error = 1 / seconds
  const std::vector<CostPoint> points = {{1, 1}, {10, 0.1}, {100, 0.01}};
  bool first = true;
  EXPECT_NEAR(timeToError(points, 0.25, &first), 4.0, 1e-12);
  EXPECT_FALSE(first);
  EXPECT_NEAR(timeToError(points, 0.02), 50.0, 1e-10);
  EXPECT_NEAR(timeToError(points, 0.01), 100.0, 1e-10);
}

TEST(TimeToError, DoesNotGoBeyondWhatWasMeasured) {
  const std::vector<CostPoint> points = {{1, 1}, {10, 0.1}};
  bool first = false;
  EXPECT_EQ(timeToError(points, 0.09), kNever);
  EXPECT_EQ(timeToError(points, 2.0, &first), 1.0);
  EXPECT_TRUE(first);
  EXPECT_EQ(timeToError({}, 1.0, &first), kNever);
  EXPECT_FALSE(first);
}

TEST(TimeToError, LeavesOutErrorsBelowTheReferences) {
  EXPECT_EQ(timeToError({{1, 1}, {10, -0.1}}, 0.5), kNever);
  EXPECT_NEAR(timeToError({{1, 1}, {10, 0}, {100, 0.01}}, 0.1), 10.0, 1e-9);
}

TEST(ErrorAtTime, IsKnownBetweenBudgetsAlone) {
  const std::vector<CostPoint> points = {{1, 1}, {4, 0.5}};
  EXPECT_NEAR(errorAtTime(points, 2.0), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(errorAtTime(points, 1.0), 1.0);
  EXPECT_EQ(errorAtTime(points, 4.0), 0.5);
  EXPECT_TRUE(std::isnan(errorAtTime(points, 0.5)));
  EXPECT_TRUE(std::isnan(errorAtTime(points, 5.0)));
}

TEST(BreakEven, IsWhereTheLinesCross) {
  // error = 8 / seconds^2 against 2 / seconds: equal at 4
  const std::vector<CostPoint> baseline = {{1, 2}, {16, 0.125}};
  const std::vector<CostPoint> method = {{2, 2}, {16, 0.03125}};
  const BreakEven even = breakEven(method, baseline);
  EXPECT_NEAR(even.seconds, 4.0, 1e-9);
  EXPECT_FALSE(even.fromFirst);
  EXPECT_EQ(breakEven(baseline, method).seconds, kNever);
}

TEST(BreakEven, FromTheFirstTimeThatBothHave) {
  const BreakEven even = breakEven({{2, 1}, {8, 0.1}}, {{1, 9}, {4, 8}, {16, 7}});
  EXPECT_EQ(even.seconds, 2.0);
  EXPECT_TRUE(even.fromFirst);
}

TEST(BreakEven, CountsTheLastCrossing) {
  const std::vector<CostPoint> baseline = {{1, 1}, {2, 1}, {4, 1}, {8, 1}};
  const BreakEven even = breakEven({{1, 2}, {2, 0.5}, {4, 2}, {8, 0.5}}, baseline);
  EXPECT_NEAR(even.seconds, std::sqrt(32.0), 1e-9);
  EXPECT_EQ(breakEven({{1, 0.5}, {2, 0.5}, {4, 2}}, baseline).seconds, kNever);
}

TEST(BreakEven, EqualIsNotBetter) {
  const std::vector<CostPoint> line = {{1, 1}, {2, 0.5}};
  EXPECT_EQ(breakEven(line, line).seconds, kNever);
}

TEST(BreakEven, IsUnknownWhereTimesDoNotOverlap) {
  EXPECT_TRUE(std::isnan(breakEven({{10, 1}, {20, 1}}, {{1, 1}, {2, 1}}).seconds));
  EXPECT_TRUE(std::isnan(breakEven({}, {{1, 1}}).seconds));
}

}  // namespace
