// SPDX-License-Identifier: Apache-2.0
#include "density/tensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "density/levels.h"
#include "density/point.h"

namespace awd {
namespace {

constexpr uint32_t kLevel = 2;

/// Three axes of different families, each on level 2 or 3.
struct Product {
  std::vector<Family> families;
  const BasisLevel* levels[3] = {};
  Shape shape;

  Product(const char* first, const char* second, const char* third, uint32_t level = kLevel) {
    for (const char* name : {first, second, third}) families.push_back(family(name, 3));
    for (uint32_t a = 0; a < 3; ++a) levels[a] = &families[a].level(level);
    shape = shapeOf(levels, 3);
  }
  double valueAt(const Coefficients& c, const double* x) const {
    AxisValues at[3];
    const std::size_t strides[3] = {shape.stride(0), shape.stride(1), shape.stride(2)};
    evaluatePoint<3>(levels, x, at);
    return contract<3>(c.data(), strides, at);
  }
};

Coefficients someCoefficients(std::size_t size, Uniforms& random) {
  Coefficients c(size, 0.0);
  for (double& value : c) value = 2.0 * random() - 0.5;
  return c;
}

double dot(const Coefficients& a, const Coefficients& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

const char* const kProducts[][3] = {
    {"haar", "m3", "linear-bspline"},
    {"quadratic-bspline", "f2", "quadratic-bspline-periodic"},
    {"linear-bspline-periodic", "m2", "haar"},
};

template <class Test>
void forEachProduct(Test&& test) {
  for (const auto& names : kProducts) {
    SCOPED_TRACE(std::string(names[0]) + ", " + names[1] + ", " + names[2]);
    test(Product(names[0], names[1], names[2]));
  }
}

TEST(Tensor, RefiningKeepsTheFunction) {
  Uniforms random(1);
  forEachProduct([&](Product product) {
    Coefficients c = someCoefficients(product.shape.size(), random);
    std::vector<double> points(3 * 50), before;
    for (double& x : points) x = random();
    for (std::size_t i = 0; i < 50; ++i) before.push_back(product.valueAt(c, &points[3 * i]));
    for (const uint32_t a : {1u, 2u, 0u}) {
      const BasisLevel& fine = product.families[a].level(kLevel + 1);
      c = refineAlong(*product.levels[a], fine, a, product.shape, c);
      product.levels[a] = &fine;
      EXPECT_TRUE(product.shape == shapeOf(product.levels, 3));
      ASSERT_EQ(c.size(), product.shape.size());
      for (std::size_t i = 0; i < 50; ++i) {
        EXPECT_NEAR(product.valueAt(c, &points[3 * i]), before[i], 1e-14) << "axis " << a;
      }
    }
  });
}

/// Sums over samples: sum_j s_j c_j is the same with fine sums and refined coefficients.
TEST(Tensor, RestrictingIsTheTransposeOfRefining) {
  Uniforms random(2);
  forEachProduct([&](const Product& product) {
    for (uint32_t a = 0; a < 3; ++a) {
      const BasisLevel& coarse = *product.levels[a];
      const BasisLevel& fine = product.families[a].level(kLevel + 1);
      Shape up = product.shape;
      const Coefficients c = someCoefficients(product.shape.size(), random);
      const Coefficients refined = refineAlong(coarse, fine, a, up, c);
      const Coefficients sums = someCoefficients(up.size(), random);
      Shape down = up;
      const Coefficients restricted = restrictAlong(coarse, a, down, sums);
      EXPECT_TRUE(down == product.shape);
      EXPECT_NEAR(dot(restricted, c), dot(sums, refined), 1e-12) << "axis " << a;
    }
  });
}

/// b_j = int f N_j of a function of the basis, by the Gram matrices, gives its coefficients again.
TEST(Tensor, SolvingInvertsTheGramMatrices) {
  Uniforms random(3);
  forEachProduct([&](const Product& product) {
    const Coefficients c = someCoefficients(product.shape.size(), random);
    Coefficients b = c;
    for (uint32_t a = 0; a < 3; ++a) {
      const auto gram = gramMatrix(std::pmr::get_default_resource(), *product.levels[a]);
      const std::size_t n = product.shape.count[a], stride = product.shape.stride(a);
      const Coefficients from = b;
      for (std::size_t i = 0; i < b.size(); ++i) {
        const std::size_t j = i / stride % n;
        b[i] = 0.0;
        for (std::size_t k = 0; k < n; ++k)
          b[i] += gram[j * n + k] * from[i + k * stride - j * stride];
      }
    }
    for (uint32_t a = 0; a < 3; ++a) {
      solveAlong(GramSolver(std::pmr::get_default_resource(), *product.levels[a]), a, product.shape,
                 b);
    }
    for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(b[i], c[i], 1e-10);
  });
}

TEST(Tensor, Weights) {
  Uniforms random(4);
  forEachProduct([&](const Product& product) {
    const Coefficients c = someCoefficients(product.shape.size(), random);
    Coefficients masses = c;
    timesWeights(product.levels, product.shape, masses);
    double sum = 0.0;
    for (std::size_t i = 0; i < c.size(); ++i) {
      double weight = 1.0;
      for (uint32_t a = 0; a < 3; ++a) {
        weight *= product.levels[a]->weights[i / product.shape.stride(a) % product.shape.count[a]];
      }
      EXPECT_NEAR(masses[i], c[i] * weight, 1e-16);
      sum += c[i] * weight;
    }
    EXPECT_NEAR(integral(product.levels, product.shape, c.data()), sum, 1e-14);
    overWeights(product.levels, product.shape, masses);
    for (std::size_t i = 0; i < c.size(); ++i) EXPECT_NEAR(masses[i], c[i], 1e-15);
    const Coefficients ones(product.shape.size(), 1.0);
    EXPECT_NEAR(integral(product.levels, product.shape, ones.data()), 1.0, 1e-15);
  });
}

/// Two points of Gauss on every eighth of every axis: exact up to degree 3.
TEST(Tensor, BoxIntegrals) {
  constexpr double kGauss[] = {0.21132486540518711775, 0.78867513459481288225};
  Uniforms random(5);
  forEachProduct([&](const Product& product) {
    const Coefficients c = someCoefficients(product.shape.size(), random);
    const auto over = [&](const double* lower, const double* upper) {
      return boxIntegral(std::pmr::get_default_resource(), product.levels, product.shape, c.data(),
                         lower, upper);
    };
    const double zero[] = {0.0, 0.0, 0.0}, one[] = {1.0, 1.0, 1.0};
    EXPECT_NEAR(over(zero, one), integral(product.levels, product.shape, c.data()), 1e-14);
    EXPECT_EQ(over(one, one), 0.0);
    const double lower[] = {0.125, 0.5, 0.25}, upper[] = {0.5, 0.625, 1.0};
    double sum = 0.0;
    for (uint32_t i = 0; i < 512; ++i) {
      const double corner[] = {(i & 7) / 8.0, (i >> 3 & 7) / 8.0, (i >> 6) / 8.0};
      bool inside = true;
      for (int a = 0; a < 3; ++a) inside = inside && lower[a] <= corner[a] && corner[a] < upper[a];
      for (uint32_t g = 0; inside && g < 8; ++g) {
        const double x[] = {corner[0] + kGauss[g & 1] / 8, corner[1] + kGauss[g >> 1 & 1] / 8,
                            corner[2] + kGauss[g >> 2] / 8};
        sum += product.valueAt(c, x) / (8.0 * 512.0);
      }
    }
    EXPECT_NEAR(over(lower, upper), sum, 1e-15);
    // Parts of a cell add up.
    const double middle[] = {0.3, 0.3, 0.3}, right[] = {0.3, 1.0, 1.0}, left[] = {0.3, 0.0, 0.0};
    EXPECT_NEAR(over(zero, right) + over(left, one), over(zero, one), 1e-14);
    EXPECT_GT(std::fabs(over(zero, middle)), 0.0);
  });
}

}  // namespace
}  // namespace awd
