// SPDX-License-Identifier: Apache-2.0
#include "density/projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "density/axis.h"
#include "density/levels.h"

namespace awd {
namespace {

/// c up to a common factor, so that c[reference] is as given.
std::pmr::vector<double> scaledTo(std::pmr::vector<double> c, std::size_t reference, double value) {
  const double factor = value / c[reference];
  for (double& x : c) x *= factor;
  return c;
}

// f(x,y) = x^2 on clamped linear splines of level 1: exact means of f over p_j are 1/24, 7/24 and
// 17/24, and the dual gives c = (-1, 5, 23)/24 (exact rationals): negative although f >= 0.
TEST(Projection, TurnsDualIntoPrimal) {
  const Family linear = family("test-linear");
  const BasisLevel& level = linear.level(1);
  const GramSolver gram(memory(), level);
  SquareStatistics statistics(memory(), 9, -40);
  const double means[] = {1.0, 7.0, 17.0};
  for (std::size_t i = 0; i < 9; ++i) statistics.record(i, means[i / 3]);
  const auto c = scaledTo(project(memory(), level, gram, statistics), 8, 23.0);
  const double expected[] = {-1.0, 5.0, 23.0};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(c[i], expected[i / 3], 1e-12);
}

TEST(Projection, HaarIsTheMeanOfEachCell) {
  const Family haar = family("haar");
  const GramSolver gram(memory(), haar.level(1));
  SquareStatistics statistics(memory(), 4, -40);
  statistics.record(0, 1.0);
  statistics.record(0, 2.0);
  statistics.record(1, 3.0);
  statistics.record(3, 0.5);
  const auto c = scaledTo(project(memory(), haar.level(1), gram, statistics), 0, 1.5);
  EXPECT_DOUBLE_EQ(c[1], 3.0);
  EXPECT_EQ(c[2], 0.0);  // never drawn
  EXPECT_DOUBLE_EQ(c[3], 0.5);
}

// Null hypothesis: the paper's estimate of the coefficients is unbiased. f = a known element of the
// space with multiplicative noise; each coefficient's z-score over 64 repetitions, 25 x 3
// coefficients; |z| > 5.5 happens with probability 3e-6 in all. Fixed seed.
TEST(Projection, IsUnbiased) {
  for (const char* name : {"test-linear", "test-linear-periodic", "test-quadratic"}) {
    const Family compiled = family(name);
    const BasisLevel& level = compiled.level(2);
    const GramSolver gram(memory(), level);
    const uint32_t n = level.count;
    std::pmr::vector<double> truth(std::size_t{n} * n);
    for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = 1.0 + double(i * 7 % 5);
    const SquareDensity f(level, AWD_SAMPLER_COMPONENT, truth);
    const SquareDensity start(memory(), level, AWD_SAMPLER_COMPONENT);
    std::vector<double> sums(truth.size(), 0.0), squares(truth.size(), 0.0);
    Uniforms random(14);
    constexpr int kRepetitions = 64;
    for (int r = 0; r < kRepetitions; ++r) {
      SquareStatistics statistics(memory(), truth.size(), -40);
      double largest = 0.0;
      for (int i = 0; i < 4000; ++i) {
        const double u[3] = {random(), random(), random()};
        const SquareSample s = start.sample(u);
        statistics.record(s.component, f.pdf(s.u, s.v) * 2.0 * random());
      }
      for (std::size_t i = 0; i < truth.size(); ++i) {
        largest = std::max(largest, statistics.sum(i) / double(statistics.count(i)));
      }
      const double scale = std::ldexp(1.0, std::ilogb(largest));
      const auto c = project(memory(), level, gram, statistics);
      for (std::size_t i = 0; i < c.size(); ++i) {
        sums[i] += c[i] * scale;
        squares[i] += c[i] * c[i] * scale * scale;
      }
    }
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const double mean = sums[i] / kRepetitions;
      const double error =
          std::sqrt((squares[i] / kRepetitions - mean * mean) / (kRepetitions - 1));
      EXPECT_LT(std::abs(mean - f.coefficients()[i]), 5.5 * error) << name << " " << i;
    }
  }
}

TEST(Clamp, RaisesToTauTimesTheMean) {
  const Family haar = family("haar");
  std::pmr::vector<double> c = {4.0, 0.0, -3.0, 0.0};
  ASSERT_TRUE(clampCoefficients(haar.level(1), 0.1, c));
  EXPECT_EQ(c[0], 4.0);
  for (int i = 1; i < 4; ++i) EXPECT_DOUBLE_EQ(c[i], 0.1);
  c = {4.0, 0.0, -3.0, 0.0};
  ASSERT_TRUE(clampCoefficients(haar.level(1), -1.0, c));
  EXPECT_EQ(c[2], 0.0);
}

TEST(Clamp, RefusesWhatHasNoMean) {
  const Family haar = family("haar");
  std::pmr::vector<double> c = {0.0, 0.0, -1.0, 0.0};
  EXPECT_FALSE(clampCoefficients(haar.level(1), 0.1, c));
  c[0] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(clampCoefficients(haar.level(1), 0.1, c));
}

}  // namespace
}  // namespace awd
