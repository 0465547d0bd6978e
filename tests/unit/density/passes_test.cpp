// SPDX-License-Identifier: Apache-2.0
#include "density/passes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

#include "density/levels.h"

namespace awd {
namespace {

/// A pass of these f/p; cross: for each earlier pass the mean of f^2 / (p_k p).
PassSums sums(std::initializer_list<double> ratios, std::initializer_list<double> cross = {}) {
  PassSums out(memory());
  for (const double ratio : ratios) out.add(WeighedSample(ratio, 1.0, AWD_TARGET_MEAN));
  for (const double moment : cross) {
    out.cross.emplace_back();
    out.cross.back().add(moment * static_cast<double>(ratios.size()), 0);
  }
  return out;
}

TEST(Passes, Nothing) {
  for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE}) {
    Passes passes(memory(), combination);
    passes.finish(sums({}), {});
    const Estimate estimate = passes.estimate(sums({}));
    EXPECT_EQ(estimate.integral, 0.0);
    EXPECT_EQ(estimate.standardError, 0.0);
    EXPECT_EQ(estimate.passes, 0u);
    EXPECT_EQ(passes.estimate(sums({2.0})).integral, 2.0);
    EXPECT_EQ(passes.estimate(sums({2.0})).standardError, HUGE_VAL);
  }
}

TEST(Passes, ByCount) {
  Passes passes(memory(), AWD_COMBINE_COUNT);
  passes.finish(sums({1.0, 3.0}), {});
  passes.finish(sums({}), {});
  passes.finish(sums({5.0}), {});
  EXPECT_TRUE(passes.kept().empty()) << "no density is kept";
  const Estimate estimate = passes.estimate(sums({0.0, 0.0, 6.0}));
  EXPECT_EQ(estimate.samples, 6u);
  EXPECT_EQ(estimate.passes, 3u);
  EXPECT_NEAR(estimate.integral, 15.0 / 6.0, 1e-15);
  // Variances of one sample: 2 and 12; of a single one its square stands for it.
  EXPECT_NEAR(estimate.standardError, std::sqrt(2 * 2.0 + 1 * 25.0 + 3 * 12.0) / 6.0, 1e-15);
}

/// Its square minus the square of its mean is 0: no error at all.
TEST(Passes, ByCrossVarianceOfASingleSample) {
  Passes passes(memory(), AWD_COMBINE_CROSS_VARIANCE);
  passes.finish(sums({100.0}), {});
  EXPECT_EQ(passes.estimate(sums({})).standardError, HUGE_VAL);
  const Estimate estimate = passes.estimate(sums({1.0}, {1.0}));
  EXPECT_EQ(estimate.samples, 2u);
  EXPECT_GT(estimate.standardError, 0.5);
}

/// The last pass says what variance the others have: second moments less the square of its mean.
TEST(Passes, ByCrossVariance) {
  Passes passes(memory(), AWD_COMBINE_CROSS_VARIANCE);
  passes.finish(sums({1.0, 7.0, 4.0}), {});
  ASSERT_EQ(passes.kept().size(), 1u);
  EXPECT_NEAR(double(passes.kept()[0].mean), 4.0, 1e-15);
  // Before the second: its own samples are all there is, variance 66/3 - 16 = 6.
  Estimate estimate = passes.estimate(sums({}));
  EXPECT_NEAR(estimate.integral, 4.0, 1e-15);
  EXPECT_NEAR(estimate.standardError, std::sqrt(6.0 / 3.0), 1e-15);

  // Mean 2, own second moment 5 and the first pass's 12 in its eyes: variances 1 and 8.
  const PassSums present = sums({1.0, 1.0, 3.0, 3.0}, {12.0});
  for (const bool finished : {false, true}) {
    if (finished) passes.finish(present, {});
    estimate = passes.estimate(finished ? sums({}, {0.0, 0.0}) : present);
    const double first = 3.0 / 8.0, second = 4.0 / 1.0;
    EXPECT_NEAR(estimate.integral, (first * 4.0 + second * 2.0) / (first + second), 1e-15);
    EXPECT_NEAR(estimate.standardError, 1.0 / std::sqrt(first + second), 1e-15);
    EXPECT_EQ(estimate.samples, 7u);
    EXPECT_EQ(estimate.passes, 2u);
  }
}

/// No variance is believed to be below a thousandth of the squared mean, and constants have one.
TEST(Passes, VariancesHaveAFloor) {
  Passes passes(memory(), AWD_COMBINE_CROSS_VARIANCE);
  passes.finish(sums({2.0, 2.0}), {});
  const Estimate estimate = passes.estimate(sums({3.0, 1.0}, {4.0}));
  const double first = 2.0 / (1e-3 * 4.0), second = 2.0 / 1.0;
  EXPECT_NEAR(estimate.integral, 2.0, 1e-15);
  EXPECT_NEAR(estimate.standardError, std::sqrt(second * second * 1.0 / 2.0) / (first + second),
              1e-15);
  const Estimate zeros = Passes(memory(), AWD_COMBINE_CROSS_VARIANCE).estimate(sums({0.0, 0.0}));
  EXPECT_EQ(zeros.integral, 0.0);
  EXPECT_EQ(zeros.standardError, 0.0);
}

TEST(Passes, TheOldestGoes) {
  Passes passes(memory(), AWD_COMBINE_CROSS_VARIANCE);
  for (int k = 0; k < 20; ++k) {
    PassSums present = sums({k - 1.0, k + 1.0});
    for (std::size_t i = 0; i < passes.kept().size(); ++i) {
      present.cross.emplace_back();
      present.cross.back().add(2.0 * (k * k + 1.0), 0);
    }
    passes.finish(present, {});
  }
  ASSERT_EQ(passes.kept().size(), Passes::kKept);
  ASSERT_EQ(passes.lastPass().secondMoments.size(), Passes::kKept);
  EXPECT_EQ(double(passes.kept().front().mean), 4.0);
  EXPECT_EQ(double(passes.kept().back().mean), 19.0);
  const Estimate estimate = passes.estimate(sums({}));
  EXPECT_EQ(estimate.passes, 16u);
  EXPECT_EQ(estimate.samples, 32u);
  EXPECT_NEAR(estimate.integral, (4.0 + 19.0) / 2.0, 1e-14) << "equal weights";
  EXPECT_EQ(passes.totals().samples, 40u);
}

/// Ratios whose squares are no doubles.
TEST(Passes, LargeAndSmall) {
  for (const double scale : {1e300, 1e-300, 1e-310}) {
    for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE}) {
      const Passes passes(memory(), combination);
      const Estimate estimate = passes.estimate(sums({scale, 3.0 * scale, 3.0 * scale, scale}));
      EXPECT_NEAR(estimate.integral / scale, 2.0, 1e-12);
      EXPECT_NEAR(estimate.standardError / scale,
                  combination == AWD_COMBINE_COUNT ? std::sqrt(1.0 / 3.0) : 0.5, 1e-12);
    }
  }
}

}  // namespace
}  // namespace awd
