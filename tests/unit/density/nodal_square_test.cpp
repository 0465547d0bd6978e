// SPDX-License-Identifier: Apache-2.0
// The fast sampler of hat functions against the simple one, which is its oracle.
#include "density/nodal_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "density/levels.h"
#include "density/square_sampler.h"

namespace awd {
namespace {

/// Coefficients of integral 1 over so many decades; every third is 0.
std::pmr::vector<double> someCoefficients(const BasisLevel& level, uint64_t seed, double decades) {
  Uniforms random(seed);
  const uint32_t n = level.count;
  std::pmr::vector<double> c(std::size_t{n} * n);
  double integral = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = random() < 1.0 / 3.0 ? 0.0 : std::pow(10.0, -decades * random());
    integral += c[i] * level.weights[i / n] * level.weights[i % n];
  }
  for (double& value : c) value /= integral;
  return c;
}

struct Both {
  Both(const BasisLevel& level, const std::pmr::vector<double>& c)
      : simple(level, c), tables(NodalSquare::tables(level, c)), fast(tables.data(), level.cells) {}
  SquareSampler simple;
  std::pmr::vector<float> tables;
  NodalSquare fast;
};

TEST(NodalSquare, FitsLinearSplinesOfTwoToThirtyTwoCells) {
  const Family linear = family("linear-bspline");
  for (uint32_t l = 0; l <= 6; ++l) {
    EXPECT_EQ(NodalSquare::fits(linear.level(l)), l >= 1 && l <= 5) << l;
  }
  EXPECT_FALSE(NodalSquare::fits(family("haar").level(3)));
  EXPECT_FALSE(NodalSquare::fits(family("quadratic-bspline").level(3)));
}

TEST(NodalSquare, DrawsAndKnowsWhatTheSimpleOneDoes) {
  const Family linear = family("linear-bspline");
  for (uint32_t l = 1; l <= 5; ++l) {
    for (const double decades : {0.5, 3.0}) {
      const Both both(linear.level(l), someCoefficients(linear.level(l), 70 + l, decades));
      Uniforms random(71);
      int apart = 0;
      for (int i = 0; i < 20000; ++i) {
        const double a = random(), b = random();
        const SquareSampler::Sample simple = both.simple.sample(a, b);
        const NodalSquare::Sample fast = both.fast.sample(a, b);
        // Floats tell u apart to 1e-7 of the mass: where the density is low, to far less.
        if (std::abs(simple.u - fast.u) > 1e-4f || std::abs(simple.v - fast.v) > 1e-3f) ++apart;
        const auto u = static_cast<float>(random()), v = static_cast<float>(random());
        const double pdf = both.simple.pdf(u, v);
        ASSERT_NEAR(static_cast<double>(both.fast.pdf(u, v)), pdf, 1e-6 * pdf + 1e-12) << l;
      }
      EXPECT_LE(apart, 20) << "level " << l << ", decades " << decades;
    }
  }
}

TEST(NodalSquare, IsMonotoneAndKnowsItsPdfToTheBit) {
  const Family linear = family("linear-bspline");
  for (uint32_t l = 1; l <= 5; ++l) {
    const Both both(linear.level(l), someCoefficients(linear.level(l), 80 + l, 14.0));
    Uniforms random(81);
    float lastU = 0.0f, lastV = 0.0f;
    for (int i = 0; i <= 20000; ++i) {
      const double rising = i < 20000 ? i / 20000.0 : 1.0 - 0x1p-53;
      const NodalSquare::Sample alongU = both.fast.sample(rising, random());
      ASSERT_GE(alongU.u, lastU - 1e-6f);
      lastU = alongU.u;
      const NodalSquare::Sample alongV = both.fast.sample(0.3, rising);
      ASSERT_GE(alongV.v, lastV - 1e-6f);
      lastV = alongV.v;
      for (const NodalSquare::Sample& s : {alongU, alongV}) {
        ASSERT_TRUE(s.u > 0.0f && s.u < 1.0f && s.v > 0.0f && s.v < 1.0f);
        ASSERT_TRUE(s.pdf > 0.0f && std::isfinite(s.pdf)) << "level " << l;
        const float pdf = both.fast.pdf(s.u, s.v);
        ASSERT_EQ(std::memcmp(&s.pdf, &pdf, sizeof pdf), 0) << "level " << l;
      }
    }
  }
}

TEST(NodalSquare, IsDefinedOnTheWholeClosedSquare) {
  const Family linear = family("linear-bspline");
  const Both both(linear.level(3), someCoefficients(linear.level(3), 90, 1.0));
  for (const float u : {0.0f, 1.0f}) {
    for (const float v : {0.0f, 1.0f}) {
      EXPECT_NEAR(static_cast<double>(both.fast.pdf(u, v)), both.simple.pdf(u, v), 1e-5);
    }
  }
}

}  // namespace
}  // namespace awd
