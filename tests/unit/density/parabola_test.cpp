// SPDX-License-Identifier: Apache-2.0
#include "density/parabola.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "density/levels.h"

namespace awd {
namespace {

/// The share of the mass up to t, from terms of one sign.
double share(const double* b, double t) {
  const double s = 1.0 - t;
  const double below = b[0] * t * (3.0 * s * s + 3.0 * s * t + t * t) +
                       b[1] * t * t * (3.0 * s + t) + b[2] * t * t * t;
  return below / (b[0] + b[1] + b[2]);
}

TEST(ParabolaCdf, MostGuessesOfSmoothDensitiesNeedNoMore) {
  Uniforms random(1);
  int unsolved = 0;
  for (int i = 0; i < 10000; ++i) {
    // A parabola between neighbours that differ by half an order of magnitude at most.
    const double middle = 1.0, ratio = std::pow(10.0, random() - 0.5);
    const double b[] = {0.5 * (middle + middle / ratio), middle, 0.5 * (middle + middle * ratio)};
    const double u = std::max(random(), 0x1p-54);
    const ParabolaCdf cdf(b[0], b[1], b[2], u);
    const double t = cdf.guess();
    if (!cdf.solvedBy(t)) {
      ++unsolved;
      continue;
    }
    ASSERT_NEAR(share(b, t), u, 4e-15);
  }
  EXPECT_LT(unsolved, 10);
}

/// Zeros within or at the ends, and 100 decades between neighbours.
TEST(ParabolaCdf, WhatIsNoSolutionIsNotTakenForOne) {
  Uniforms random(2);
  int unsolved = 0;
  for (int i = 0; i < 10000; ++i) {
    double b[3];
    for (double& value : b) {
      value = i % 2 == 0 ? std::pow(10.0, -100.0 * random()) : random() < 0.5 ? 0.0 : random();
    }
    b[i % 3] = 1.0;
    const double u = i % 5 == 0 ? 0x1p-54 : i % 5 == 1 ? 1.0 : std::max(random(), 0x1p-54);
    const ParabolaCdf cdf(b[0], b[1], b[2], u);
    const double guess = cdf.guess();
    const bool solved = cdf.solvedBy(guess);
    unsolved += !solved;
    const double t = solved ? guess : cdf.solve();
    ASSERT_TRUE(t > 0.0 && t <= 1.0) << t;
    ASSERT_NEAR(share(b, t), u, 1e-14) << b[0] << ' ' << b[1] << ' ' << b[2];
  }
  EXPECT_GT(unsolved, 1000);
  EXPECT_LT(unsolved, 9000);
}

}  // namespace
}  // namespace awd
