// SPDX-License-Identifier: Apache-2.0
#include "density/inverse_cdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

constexpr double kEnds[] = {0.0, 0x1p-1074, 0x1p-53, 0.5, 1.0 - 0x1p-53};

double mass(const BasisLevel* level, const Coefficients& c, double upTo) {
  const double zero = 0.0;
  return boxIntegral(memory(), &level, shapeOf(&level, 1), c.data(), &zero, &upTo);
}

/// F(x(u)) = u F(1), for flat, sparse and high-contrast coefficients.
TEST(InverseCdf, HitsItsTarget) {
  Uniforms random(1);
  for (const char* name : kShipped) {
    const Family compiled = family(name);
    for (const uint32_t l : {0u, 1u, 2u, 5u}) {
      const BasisLevel* level = &compiled.level(l);
      for (int kind = 0; kind < 4; ++kind) {
        Coefficients c(level->count, 1.0);
        for (double& value : c) {
          if (kind == 1) value = random();
          if (kind == 2) value = random() < 0.6 ? 0.0 : random();
          if (kind == 3) value = std::pow(10.0, 60.0 * random() - 30.0);
        }
        c[static_cast<std::size_t>(random() * level->count)] = 1.0;
        const InverseCdf inverse(memory(), &level, shapeOf(&level, 1), c);
        const double whole = mass(level, c, 1.0);
        for (int i = 0; i < 200; ++i) {
          const double u = i < 5 ? kEnds[i] : random();
          double x, p;
          inverse.sample<1>(c, 1, &u, &x, &p);
          ASSERT_TRUE(x >= 0.0 && x < 1.0) << x;
          ASSERT_NEAR(mass(level, c, x), u * whole, 1e-13 * whole)
              << name << " level " << l << " kind " << kind << " u " << u;
          ASSERT_GT(p, 0.0) << name << " level " << l << " kind " << kind << " u " << u;
        }
      }
    }
  }
}

/// Each axis by itself, given the coordinates before: the coefficients of the conditional density
/// are those of the product, contracted with the values of the functions there.
TEST(InverseCdf, ConditionalsHitTheirTargets) {
  Uniforms random(2);
  const char* const products[][3] = {{"haar", "m3", "linear-bspline"},
                                     {"quadratic-bspline", "f2", "quadratic-bspline-periodic"}};
  for (const auto& names : products) {
    std::vector<Family> families;
    const BasisLevel* levels[3];
    for (const char* name : names) families.push_back(family(name, 2));
    for (uint32_t a = 0; a < 3; ++a) levels[a] = &families[a].level(2);
    const Shape shape = shapeOf(levels, 3);
    Coefficients c(shape.size(), 0.0);
    for (double& value : c) value = random() < 0.2 ? 0.0 : std::pow(10.0, 3.0 * random());
    const InverseCdf inverse(memory(), levels, shape, c);
    for (int i = 0; i < 200; ++i) {
      double u[3], x[3];
      for (double& number : u) number = i % 9 == 0 ? kEnds[i / 9 % 5] : random();
      AxisValues at[3];
      inverse.sample<3>(c, 1, u, x, nullptr);
      evaluatePoint<3>(levels, x, at);
      Coefficients given = c;
      for (uint32_t a = 0; a < 3; ++a) {
        Shape rest = shape;
        rest.dimensions = 3 - a;
        for (uint32_t b = 0; b < 3; ++b) rest.count[b] = a + b < 3 ? shape.count[a + b] : 0;
        const double lower[3] = {};
        double upper[3] = {1.0, 1.0, 1.0};
        const double whole = boxIntegral(memory(), levels + a, rest, given.data(), lower, upper);
        upper[0] = x[a];
        const double below = boxIntegral(memory(), levels + a, rest, given.data(), lower, upper);
        ASSERT_NEAR(below, u[a] * whole, 1e-12 * whole) << names[a] << ", axis " << a;
        const std::size_t inner = rest.stride(0);
        Coefficients next(inner, 0.0);
        for (uint32_t k = 0; k < at[a].count; ++k) {
          for (std::size_t j = 0; j < inner; ++j) {
            next[j] += at[a].value[k] * given[at[a].function[k] * inner + j];
          }
        }
        given = next;
      }
      ASSERT_GT(given[0], 0.0) << "p";
    }
  }
}

template <uint32_t D>
void compareWithAny(const char* name, Uniforms& random) {
  constexpr std::size_t kSamples = 1000;
  const Family compiled = family(name);
  const BasisLevel* levels[D];
  std::size_t strides[D];
  for (uint32_t a = 0; a < D; ++a) levels[a] = &compiled.level(3 - a);
  const Shape shape = shapeOf(levels, D);
  for (uint32_t a = 0; a < D; ++a) strides[a] = shape.stride(a);
  Coefficients c(shape.size(), 0.0);
  for (double& value : c) value = random() < 0.2 ? 0.0 : std::pow(10.0, 4.0 * random());
  const InverseCdf inverse(memory(), levels, shape, c);
  std::vector<double> u(kSamples * D), points(u.size()), pdfs(kSamples);
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = i / D < 5 ? kEnds[i / D] : random();
  inverse.sample<D>(c, kSamples, u.data(), points.data(), pdfs.data());
  for (std::size_t i = 0; i < kSamples; ++i) {
    double x[D];
    AxisValues at[D];
    inverse.sampleAny<D>(c, &u[i * D], x, at);
    for (uint32_t a = 0; a < D; ++a) ASSERT_EQ(points[i * D + a], x[a]) << name << " axis " << a;
    ASSERT_EQ(pdfs[i], contract<D>(c.data(), strides, at)) << name;
    ASSERT_GT(pdfs[i], 0.0) << name;
  }
  for (const std::size_t batch : {1u, 31u, 64u}) {
    std::vector<double> again(u.size()), againPdfs(kSamples);
    for (std::size_t done = 0; done < kSamples; done += batch) {
      inverse.sample<D>(c, std::min(batch, kSamples - done), &u[done * D], &again[done * D],
                        &againPdfs[done]);
    }
    ASSERT_EQ(again, points) << name << " in batches of " << batch;
    ASSERT_EQ(againPdfs, pdfs) << name << " in batches of " << batch;
  }
}

/// Bases of low order are drawn from in blocks, by code of their own, which must not change a bit.
TEST(InverseCdf, BlocksGiveTheBitsOfTheGeneralWay) {
  Uniforms random(3);
  for (const char* name : kShipped) {
    compareWithAny<1>(name, random);
    compareWithAny<2>(name, random);
    compareWithAny<3>(name, random);
    compareWithAny<4>(name, random);
  }
}

/// Parabolas that the steps of a whole block don't solve, among others.
TEST(InverseCdf, SamplesThatTheBlockLeavesUnsolvedHitTheirTargets) {
  constexpr std::size_t kSamples = 100;
  Uniforms random(4);
  const Family compiled = family("m3");
  const BasisLevel* level = &compiled.level(1);
  const Coefficients c = {0.0, 1.0, 0.0, 1.0, 1.0, 1.0};
  const InverseCdf inverse(memory(), &level, shapeOf(&level, 1), c);
  double u[kSamples], x[kSamples];
  for (double& uniform : u) uniform = random();
  inverse.sample<1>(c, kSamples, u, x, nullptr);
  std::size_t unsolved = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    EXPECT_NEAR(mass(level, c, x[i]), u[i] * mass(level, c, 1.0), 1e-14);
    if (x[i] >= 0.5) continue;
    const ParabolaCdf cdf(0.0, 1.0, 0.0, 4.0 * u[i]);
    unsolved += !cdf.solvedBy(cdf.guess());
  }
  EXPECT_GT(unsolved, 10u);
  EXPECT_LT(unsolved, kSamples);
}

}  // namespace
}  // namespace awd
