// SPDX-License-Identifier: Apache-2.0
// Values of no use, of any magnitude, and too many of them: the density stays a density.
#include <limits>

#include "field/learning.h"

namespace {

using namespace awdtest;

using Extremes = Learning;
INSTANTIATE_TEST_SUITE_P(Maps, Extremes,
                         testing::Values(AWD_MAP_SPHERICAL, AWD_MAP_CONCENTRIC_COSINE));

TEST_P(Extremes, OnlyZerosKeepTheDensity) {
  begin(2, 2, 0.0);
  Random random(7);
  record(5000, random, steps);
  adapt(field_);
  const Coefficients before = coefficientsOf(field_, kPatch);
  record(5000, random, [](double, double) { return 0.0; });
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.kept, 1u);
  EXPECT_EQ(figures.samples, 5000u);
  EXPECT_EQ(coefficientsOf(field_, kPatch).c, before.c);
  EXPECT_EQ(adapt(field_).samples, 0u);
  EXPECT_EQ(coefficientsOf(field_, kPatch).c, before.c) << "a pass without samples";
}

/// Rejected samples count as zeros: the outcome is that of zeros in their place.
TEST_P(Extremes, NonsenseIsRejectedAndCounted) {
  const double nonsense[] = {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL, -1.0,
                             -1e-300};
  Coefficients outcome[2];
  for (const bool zeros : {false, true}) {
    begin(2, 2, 0.0);
    Random random(8);
    size_t i = 0;
    record(4000, random, [&](double u, double v) {
      ++i;
      if (i % 10 != 0) return steps(u, v);
      return zeros ? 0.0 : nonsense[i / 10 % 5];
    });
    const AWDFieldStatistics figures = adapt(field_);
    EXPECT_EQ(figures.samples, 4000u);
    EXPECT_EQ(figures.rejected, zeros ? 0u : 400u);
    EXPECT_EQ(figures.saturated, 0u);
    outcome[zeros] = coefficientsOf(field_, kPatch);
  }
  EXPECT_EQ(outcome[0].c, outcome[1].c);
}

TEST_P(Extremes, OnlyNonsenseKeepsTheDensity) {
  begin(2, 2, 0.0);
  Random random(9);
  record(100, random, [](double, double) { return std::nan(""); });
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.rejected, 100u);
  EXPECT_EQ(figures.kept, 1u);
  EXPECT_EQ(coefficientsOf(field_, kPatch).c, std::vector<double>(16, 1.0));
}

void expectSane(const Coefficients& density) {
  for (const double c : density.c) EXPECT_TRUE(std::isfinite(c) && c > 0.0);
  EXPECT_NEAR(density.integral(), 1.0, 1e-12);
}

/// With the scale told, any magnitude is learned alike.
TEST_P(Extremes, ExtremeMagnitudesWithTheirScale) {
  std::vector<double> first;
  for (const double magnitude : {1.0, 0x1p996, 0x1p-996, 0x1p-1030}) {
    begin(2, 3, 0.0);
    must(awdSetFieldScale(field_, magnitude));
    Random random(10);
    for (int pass = 0; pass < 2; ++pass) {
      record(5000, random, [&](double u, double v) { return magnitude * steps(u, v); });
      const AWDFieldStatistics figures = adapt(field_);
      EXPECT_EQ(figures.saturated, 0u) << magnitude;
      EXPECT_EQ(figures.kept, 0u) << magnitude;
    }
    const Coefficients found = coefficientsOf(field_, kPatch);
    expectSane(found);
    if (first.empty()) first = found.c;
    for (size_t i = 0; i < first.size(); ++i) {
      EXPECT_NEAR(found.c[i], first[i], 0.02 * first[i]) << magnitude;
    }
  }
}

/// Without it the first pass can't, but says so, stays sane, and the next ones know better.
TEST_P(Extremes, ExtremeMagnitudesWithoutTheirScale) {
  begin(2, 2, 0.0);
  Random random(11);
  const auto huge = [](double u, double v) { return 1e300 * steps(u, v); };
  record(5000, random, huge);
  EXPECT_EQ(adapt(field_).saturated, 5000u);
  expectSane(coefficientsOf(field_, kPatch));

  begin(2, 2, 0.0);
  for (const double tiny : {1e-300, 5e-324}) {
    record(5000, random, [&](double u, double v) { return tiny * steps(u, v); });
    const AWDFieldStatistics figures = adapt(field_);
    EXPECT_EQ(figures.rejected, 0u);
    expectSane(coefficientsOf(field_, kPatch));
  }

  begin(2, 2, 0.0);  // sixty decades in one pass
  record(5000, random, [&](double u, double) { return u < 0.5 ? 1e-30 : 1e30; });
  adapt(field_);
  expectSane(coefficientsOf(field_, kPatch));
}

/// What is lost by rounding is not taken for the dark: but for its unit the next pass learns as if
/// it were the first.
TEST_P(Extremes, ValuesBelowTheUnitAreNotZeros) {
  const auto tiny = [](double u, double v) { return 1e-20 * steps(u, v); };
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;  // of the estimator that pools passes
  desc.map = GetParam();
  desc.basis = "haar";
  desc.startLevel = desc.maxLevel = AWD_LEVEL(2);
  std::vector<double> c[2];
  for (const bool told : {true, false}) {
    FedField::begin(desc);
    Random random(20);
    if (told) {
      must(awdSetFieldScale(field_, 1e-20));
    } else {
      Random other(21);
      record(5000, other, tiny);
      EXPECT_EQ(adapt(field_).kept, 1u);
      EXPECT_EQ(coefficientsOf(field_, kPatch).c, std::vector<double>(16, 1.0));
    }
    record(5000, random, tiny);
    EXPECT_EQ(adapt(field_).kept, 0u);
    c[told] = coefficientsOf(field_, kPatch).c;
  }
  ASSERT_EQ(c[0].size(), c[1].size());
  for (size_t i = 0; i < c[0].size(); ++i) EXPECT_NEAR(c[0][i], c[1][i], 1e-6 * c[1][i]) << i;
}

/// Every value is clamped to the same, so that the density must stay constant; the sums that hold
/// 2^63 units at 2^52 a sample must not wrap to something else.
TEST_P(Extremes, SumsOfClampedValuesDontWrap) {
  begin(1, 1, kNoFloor);
  Random random(19);
  const float up[3] = {0, 0, 1};
  size_t left[4] = {4096, 4196, 4596, 5096};  // all of them back above 0 after 2^64 units
  for (size_t toDo = 4; toDo > 0;) {
    const AWDDirectionSample s = draw(field_, kPatch, up, random);
    if (left[s.component] == 0) continue;
    must(awdRecordField(field_, kPatch, &s, 1e300));
    if (--left[s.component] == 0) --toDo;
  }
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.saturated, figures.samples);
  for (const double c : coefficientsOf(field_, kPatch).c) EXPECT_NEAR(c, 1.0, 1e-9);
}

TEST_P(Extremes, OneSampleIsEnoughForADensity) {
  begin(3, 3, 0.0);
  Random random(12);
  record(1, random, [](double, double) { return 1.0; });
  adapt(field_);
  expectSane(coefficientsOf(field_, kPatch));
}

TEST_P(Extremes, AThousandCyclesKeepTheIntegral) {
  for (const double tau : {0.0, 0.01}) {
    begin(2, 3, tau);
    Random random(13);
    for (int cycle = 0; cycle < 1000; ++cycle) {
      record(32, random, steps);
      adapt(field_);
    }
    expectSane(coefficientsOf(field_, kPatch));
  }
}

}  // namespace
