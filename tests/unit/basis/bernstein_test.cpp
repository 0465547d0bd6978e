// SPDX-License-Identifier: Apache-2.0
#include "basis/bernstein.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace awd;

double binomial(uint32_t n, uint32_t k) {
  return k == 0 ? 1.0 : binomial(n, k - 1) * (n - k + 1) / k;
}

TEST(Bernstein, ValueFollowsTheDefinition) {
  const double b[kMaxOrder] = {0.5, 2.0, 0.0, 7.0, 1.0, 0.25, 3.0, 1.5};
  for (uint32_t order = 1; order <= kMaxOrder; ++order) {
    for (double t : {0.0, 0.125, 0.4, 0.5, 0.93, 1.0}) {
      double want = 0.0;
      for (uint32_t k = 0; k < order; ++k) {
        want += b[k] * binomial(order - 1, k) * std::pow(t, k) * std::pow(1 - t, order - 1 - k);
      }
      EXPECT_NEAR(bernsteinValue(b, order, t), want, 1e-14) << order << " " << t;
    }
    EXPECT_EQ(bernsteinValue(b, order, 0.0), b[0]);
    EXPECT_EQ(bernsteinValue(b, order, 1.0), b[order - 1]);
  }
}

TEST(Bernstein, IntegralFollowsSimpson) {
  const double b[4] = {1.0, 0.0, 4.0, 0.5};  // Simpson's rule is exact for cubics
  for (double t : {0.0, 0.2, 0.75, 1.0}) {
    const double want =
        t / 6 *
        (bernsteinValue(b, 4, 0) + 4 * bernsteinValue(b, 4, t / 2) + bernsteinValue(b, 4, t));
    EXPECT_NEAR(bernsteinIntegral(b, 4, t), want, 1e-15);
  }
}

TEST(Bernstein, ProductIntegralFollowsBoole) {
  const double a[3] = {1.0, -2.0, 5.0}, b[3] = {0.5, 4.0, 1.0};
  const auto product = [&](double t) { return bernsteinValue(a, 3, t) * bernsteinValue(b, 3, t); };
  // Boole's rule is exact for degree 4.
  const double want = (7 * product(0) + 32 * product(0.25) + 12 * product(0.5) +
                       32 * product(0.75) + 7 * product(1)) /
                      90;
  EXPECT_NEAR(bernsteinProductIntegral(a, b, 3), want, 1e-14);
  EXPECT_EQ(bernsteinProductIntegral(a, b, 1), 0.5) << "constants";
}

TEST(Bernstein, FitFindsTheCoefficients) {
  for (uint32_t order = 1; order <= kMaxOrder; ++order) {
    const BernsteinFit fit(order);
    for (uint32_t unit = 0; unit < order; ++unit) {
      double b[kMaxOrder] = {0.0}, values[kMaxOrder], got[kMaxOrder];
      b[unit] = 1.0;
      for (uint32_t i = 0; i < order; ++i) {
        EXPECT_GT(fit.node(i), 0.0);
        EXPECT_LT(fit.node(i), 1.0);
        values[i] = bernsteinValue(b, order, fit.node(i));
      }
      fit.solve(values, got);
      for (uint32_t k = 0; k < order; ++k) {
        // Those of the splines that we ship come out exactly.
        EXPECT_NEAR(got[k], b[k], order <= 3 ? 1e-18 : fit.rounding()) << "order " << order;
      }
    }
    EXPECT_LT(fit.rounding(), 1e-12) << "order " << order << " is badly conditioned";
  }
}

}  // namespace
