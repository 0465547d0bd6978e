// SPDX-License-Identifier: Apache-2.0
#include "density/inverse_cdf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

std::pmr::memory_resource* memory() { return std::pmr::get_default_resource(); }

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
          double x;
          AxisValues at;
          inverse.sample<1>(c, &u, &x, &at);
          ASSERT_TRUE(x >= 0.0 && x < 1.0) << x;
          ASSERT_NEAR(mass(level, c, x), u * whole, 1e-13 * whole)
              << name << " level " << l << " kind " << kind << " u " << u;
          double p = 0.0;
          for (uint32_t k = 0; k < at.count; ++k) p += at.value[k] * c[at.function[k]];
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
      inverse.sample<3>(c, u, x, at);
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
  const Family compiled = family(name);
  const BasisLevel* levels[D];
  for (uint32_t a = 0; a < D; ++a) levels[a] = &compiled.level(3 - a);
  const Shape shape = shapeOf(levels, D);
  Coefficients c(shape.size(), 0.0);
  for (double& value : c) value = random() < 0.2 ? 0.0 : std::pow(10.0, 4.0 * random());
  const InverseCdf inverse(memory(), levels, shape, c);
  for (int i = 0; i < 500; ++i) {
    double u[D], fast[D], any[D];
    for (double& uniform : u) uniform = i < 5 ? kEnds[i] : random();
    AxisValues fastAt[D], anyAt[D];
    inverse.sample<D>(c, u, fast, fastAt);
    inverse.sampleAny<D>(c, u, any, anyAt);
    for (uint32_t a = 0; a < D; ++a) {
      ASSERT_EQ(fast[a], any[a]) << name << " axis " << a;
      ASSERT_EQ(fastAt[a].count, anyAt[a].count);
      for (uint32_t k = 0; k < fastAt[a].count; ++k) {
        ASSERT_EQ(fastAt[a].function[k], anyAt[a].function[k]);
        ASSERT_EQ(fastAt[a].value[k], anyAt[a].value[k]);
      }
    }
  }
}

/// Bases of low order have code of their own, which must not change a bit.
TEST(InverseCdf, TheFastWayGivesTheBitsOfTheGeneralOne) {
  Uniforms random(3);
  for (const char* name : kShipped) {
    compareWithAny<1>(name, random);
    compareWithAny<2>(name, random);
    compareWithAny<3>(name, random);
    compareWithAny<4>(name, random);
  }
}

}  // namespace
}  // namespace awd
