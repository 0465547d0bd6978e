// SPDX-License-Identifier: Apache-2.0
// The true error lies within the reported one as often as claimed.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/problem.h"
#include "support/handles.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

constexpr int kRuns = 100;
constexpr double kFalseAlarms = 1e-6;

/// Null hypothesis: z = (value - truth) / error is standard normal in independent runs (some
/// hundred cells, none of which dominates). Then the sum of z^2 is chi-square of kRuns degrees.
/// Each side alarms falsely at 1e-6 at most.
void expectHonest(const char* name, Problem problem, double truth) {
  const Device device = newDevice(1u);
  double squares = 0.0;
  for (uint64_t seed = 1; seed <= kRuns; ++seed) {
    const Outcome outcome = solve(device, problem, budget(4096, 1000 + seed));
    ASSERT_EQ(outcome.status, INTEGRATE_DONE) << outcome.message;
    const double z = (outcome.value - truth) / outcome.error;
    squares += z * z;
  }
  const double tail = chiSquareTail(squares, kRuns);
  EXPECT_GT(tail, kFalseAlarms) << name << ": errors are reported too small, sum z^2 " << squares;
  EXPECT_LT(tail, 1.0 - kFalseAlarms)
      << name << ": errors are reported too large, sum z^2 " << squares;
}

double gaussIntegral(double a, double centre) {
  return std::sqrt(M_PI) / (2.0 * a) * (std::erf(a * (1.0 - centre)) + std::erf(a * centre));
}

TEST(Honesty, ProductOfGaussians) {
  const auto f = [](const double* x) {
    double sum = 0.0;
    for (int a = 0; a < 4; ++a) sum += (x[a] - 0.3) * (x[a] - 0.3);
    return std::exp(-25.0 * sum);
  };
  expectHonest("gaussian", {f, {0, 0, 0, 0}, {1, 1, 1, 1}}, std::pow(gaussIntegral(5.0, 0.3), 4));
}

TEST(Honesty, SignedWave) {
  const auto f = [](const double* x) { return std::cos(6.0 * x[0] + 5.0 * x[1] + 4.0 * x[2]); };
  // Re of the product of (exp(i a) - 1) / (i a) = exp(i a/2) sin(a/2) / (a/2).
  const double truth =
      std::cos(7.5) * (std::sin(3.0) / 3.0) * (std::sin(2.5) / 2.5) * (std::sin(2.0) / 2.0);
  expectHonest("wave", {f, {0, 0, 0}, {1, 1, 1}}, truth);
}

TEST(Honesty, DiscontinuityThatNoAxisFollows) {
  const auto f = [](const double* x) { return x[0] * x[0] + x[1] * x[1] < 1.0 ? 1.0 : 0.0; };
  expectHonest("disc", {f, {-1, -1}, {1, 1}}, M_PI);
}

}  // namespace
