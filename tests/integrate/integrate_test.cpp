// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "integrate/problem.h"
#include "support/handles.h"

namespace {

using namespace awdtest;

/// The errors reported are honest (honesty_test.cpp): the value of one run is off by more than six
/// of them once in 5e8 runs.
constexpr double kSigmas = 6.0;

class Integrate : public testing::Test {
 protected:
  const Device device_ = newDevice(1u);
  Problem peak_{
      [](const double* x) { return 1.0 / (0.01 + x[0] * x[0] + x[1] * x[1]); }, {0, 0}, {1, 1}};
};

TEST_F(Integrate, SpendsItsBudgetAndNoMore) {
  for (const uint64_t evaluations : {256u, 257u, 1003u, 4099u, 20000u}) {
    for (const double goal : {0.0, 1e-12}) {
      IntegrateOptions options = budget(evaluations);
      options.relativeError = goal;
      peak_.calls = 0;
      const Outcome outcome = solve(device_, peak_, options);
      EXPECT_EQ(outcome.status, goal > 0.0 ? INTEGRATE_NOT_MET : INTEGRATE_DONE);
      EXPECT_EQ(outcome.evaluations, peak_.calls);
      EXPECT_LE(outcome.evaluations, evaluations);
      if (goal == 0.0) {
        EXPECT_GT(outcome.evaluations, evaluations - 8);
      }
    }
  }
}

TEST_F(Integrate, StopsOnceTheGoalIsMet) {
  IntegrateOptions options = budget(1000000);
  options.relativeError = 1e-3;
  const Outcome outcome = solve(device_, peak_, options);
  EXPECT_EQ(outcome.status, INTEGRATE_DONE);
  EXPECT_LE(outcome.error, 1e-3 * outcome.value);
  EXPECT_LT(outcome.evaluations, 100000u);
}

TEST_F(Integrate, ScalesToTheBox) {
  Problem problem{[](const double* x) { return x[0] * x[0] * x[1]; }, {-1, 2}, {3, 5}};
  const Outcome outcome = solve(device_, problem, budget(10000));
  EXPECT_NEAR(outcome.value, 28.0 / 3.0 * 10.5, kSigmas * outcome.error);
  EXPECT_LT(outcome.error, 0.05);
}

TEST_F(Integrate, TakesOneToSixDimensions) {
  for (std::size_t d = 1; d <= 6; ++d) {
    Problem problem{[d](const double* x) {
                      double product = 1.0;
                      for (std::size_t a = 0; a < d; ++a) product *= std::exp(x[a]);
                      return product;
                    },
                    std::vector<double>(d, 0.0), std::vector<double>(d, 1.0)};
    const Outcome outcome = solve(device_, problem, budget(4096));
    EXPECT_EQ(outcome.status, INTEGRATE_DONE) << outcome.message;
    EXPECT_NEAR(outcome.value, std::pow(M_E - 1.0, d), kSigmas * outcome.error) << d;
  }
}

TEST_F(Integrate, ZeroAndConstants) {
  for (const double c : {0.0, 3.0, -3.0}) {
    Problem problem{[c](const double*) { return c; }, {0, 0, 0}, {1, 2, 5}};
    const Outcome outcome = solve(device_, problem, budget(4096));
    EXPECT_EQ(outcome.status, INTEGRATE_DONE);
    EXPECT_NEAR(outcome.value, 10.0 * c, 1e-12);
    EXPECT_LE(outcome.error, 1e-12);
  }
}

TEST_F(Integrate, ValuesOfAnyMagnitude) {
  const Outcome plain = solve(device_, peak_, budget(4096));
  for (const int exponent : {-1060, -900, 900, 1010}) {
    Problem scaled = peak_;
    scaled.f = [&](const double* x) { return std::ldexp(peak_.f(x), exponent); };
    const Outcome outcome = solve(device_, scaled, budget(4096));
    const double value = std::ldexp(outcome.value, -exponent);
    const double error = std::ldexp(outcome.error, -exponent);
    if (std::abs(exponent) == 900) {
      EXPECT_EQ(value, plain.value) << exponent;
      EXPECT_EQ(error, plain.error) << exponent;
    } else {  // denormal, or beyond what the integrator scales by: other roundings
      EXPECT_NEAR(value, plain.value, kSigmas * plain.error) << exponent;
      EXPECT_NEAR(error, plain.error, 0.5 * plain.error) << exponent;
    }
  }
}

TEST_F(Integrate, SpikeOfAnotherMagnitude) {
  Problem problem{[](const double* x) { return x[0] < 0.001 ? 1e100 : 1e-100; }, {0, 0}, {1, 1}};
  const Outcome outcome = solve(device_, problem, budget(20000));
  EXPECT_EQ(outcome.status, INTEGRATE_DONE);
  EXPECT_NEAR(outcome.value, 1e97, kSigmas * outcome.error);
  EXPECT_LT(outcome.error, 1e96);
}

TEST_F(Integrate, CountsValuesThatAreNotFinite) {
  Problem problem{[](const double* x) {
                    if (x[0] > 0.75) return std::numeric_limits<double>::infinity();
                    return x[0] > 0.5 ? std::nan("") : 1.0;
                  },
                  {0, 0},
                  {1, 1}};
  const Outcome outcome = solve(device_, problem, budget(10000));
  EXPECT_EQ(outcome.status, INTEGRATE_DONE);
  EXPECT_GT(outcome.nonFinite, 500u);
  EXPECT_NEAR(outcome.value, 0.5, kSigmas * outcome.error + 1e-9);
}

TEST_F(Integrate, SameSeedSameBits) {
  const Outcome first = solve(device_, peak_, budget(4096, 7));
  const Outcome again = solve(device_, peak_, budget(4096, 7));
  const Outcome other = solve(device_, peak_, budget(4096, 8));
  EXPECT_EQ(first.value, again.value);
  EXPECT_EQ(first.error, again.error);
  EXPECT_NE(first.value, other.value);
}

TEST_F(Integrate, CancelledKeepsTheLastRound) {
  struct Limit {
    uint64_t evaluations;
    IntegrateProgress last;
  };
  const auto until = [](void* user, const IntegrateProgress* progress) -> int {
    auto* limit = static_cast<Limit*>(user);
    limit->last = *progress;
    return progress->evaluations < limit->evaluations;
  };
  IntegrateOptions options = budget(1000000);
  options.relativeError = 1e-9;
  options.progress = until;
  for (const uint64_t evaluations : {uint64_t{1}, uint64_t{50000}}) {
    Limit limit{evaluations, {}};
    options.progressUser = &limit;
    const Outcome outcome = solve(device_, peak_, options);
    EXPECT_EQ(outcome.status, INTEGRATE_CANCELLED);
    EXPECT_LT(outcome.evaluations, evaluations + 300);
    EXPECT_EQ(outcome.rounds, evaluations == 1 ? 0u : 1u);
    EXPECT_EQ(std::isfinite(outcome.error), outcome.rounds > 0);
    EXPECT_EQ(outcome.value, limit.last.value);
    EXPECT_LE(limit.last.fraction, 1.0);
  }
}

TEST_F(Integrate, RefusesWrongArguments) {
  const auto refused = [&](const std::vector<double>& lower, const std::vector<double>& upper,
                           const IntegrateOptions& options, const std::string& text) {
    Problem problem{[](const double*) { return 1.0; }, lower, upper};
    const Outcome outcome = solve(device_, problem, options);
    EXPECT_EQ(outcome.status, INTEGRATE_INVALID);
    EXPECT_NE(std::string(outcome.message).find(text), std::string::npos) << outcome.message;
    EXPECT_EQ(problem.calls, 0u);
  };
  const std::vector<double> seven(7, 0.0);
  refused({}, {}, budget(1000), "dimensions is 0: give 1 to 6");
  refused(seven, seven, budget(1000), "dimensions is 7");
  refused({0, std::nan("")}, {1, 1}, budget(1000), "axis 1 goes from nan to 1");
  refused({0}, {HUGE_VAL}, budget(1000), "axis 0 goes from 0 to inf");
  refused({1}, {0}, budget(1000), "axis 0 goes from 1 to 0");
  refused({-1e300, -1e300}, {1e300, 1e300}, budget(1000), "the volume of the box is inf");
  refused({0}, {1}, budget(255), "evaluations is 255: give at least 256");
  IntegrateOptions options = budget(1000);
  options.relativeError = -1.0;
  refused({0}, {1}, options, "the goals are 0 and -1");
  options.relativeError = std::nan("");
  refused({0}, {1}, options, "the goals are");
}

}  // namespace
