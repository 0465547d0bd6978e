// SPDX-License-Identifier: Apache-2.0
// Every formula of the families that we ship, plugin and compiled tables, against exact.h: levels
// 0 to 5, entry by entry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "basis/self_test.h"
#include "density/axis.h"
#include "density/exact.h"
#include "density/gram.h"
#include "density/levels.h"

namespace awd {
namespace {

constexpr uint32_t kLevels = 5;

std::string identifier(const testing::TestParamInfo<const char*>& name) {
  std::string text = name.param;
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

class Bases : public testing::TestWithParam<const char*> {
 protected:
  const ExactFamily exact_{GetParam()};
  const AWDBasisFamily& table_ = table(GetParam());
  const Family family_ = family(GetParam(), kLevels);
};

INSTANTIATE_TEST_SUITE_P(Shipped, Bases, testing::ValuesIn(kShipped), identifier);

TEST_P(Bases, PassTheSelfTest) {
  for (const Check& check : selfTest(table_)) {
    EXPECT_TRUE(check.ok()) << check.sentence();
    EXPECT_LE(check.worst(), 0.5 * check.limit()) << check.name();
  }
}

TEST_P(Bases, Values) {
  for (uint32_t l = 0; l <= kLevels; ++l) {
    const ExactLevel exact = exact_.level(l);
    ASSERT_EQ(table_.count(l), exact.count);
    ASSERT_EQ(table_.cells(l), exact.cells);
    for (uint32_t i = 0; i <= 8 * exact.cells; ++i) {
      const uint32_t c = std::min(i / 8, exact.cells - 1);
      const Rational t(int64_t{i} - 8 * c, 8);
      const double x = i / (8.0 * exact.cells);
      std::vector<double> values(exact.count, 0.0), ours(exact.count, 0.0);
      uint32_t first = 0;
      double alive[AWD_BASIS_MAX_ORDER];
      const uint32_t size = table_.eval(l, x, &first, alive);
      for (uint32_t a = 0; a < size; ++a) values[(first + a) % exact.count] += alive[a];
      AxisValues compiled;
      evaluateAxis(family_.level(l), x, compiled);
      for (uint32_t a = 0; a < compiled.count; ++a) ours[compiled.function[a]] += compiled.value[a];
      for (uint32_t j = 0; j < exact.count; ++j) {
        const double want = valueAt(exact.pieces[j][c], t).value();
        ASSERT_NEAR(values[j], want, 1e-15) << "level " << l << " function " << j << " x " << x;
        ASSERT_NEAR(ours[j], want, 1e-15) << "level " << l << " function " << j << " x " << x;
      }
    }
  }
}

TEST_P(Bases, Weights) {
  for (uint32_t l = 0; l <= kLevels; ++l) {
    const ExactLevel exact = exact_.level(l);
    for (uint32_t j = 0; j < exact.count; ++j) {
      const double want = exact.weight(j).value();
      EXPECT_NEAR(table_.weight(l, j), want, 1e-16) << "level " << l << " function " << j;
      EXPECT_NEAR(family_.level(l).weights[j], want, 1e-16) << "level " << l << " function " << j;
    }
  }
}

/// The smallest interval outside of which the function is 0; those all around the circle aside.
TEST_P(Bases, Supports) {
  for (uint32_t l = 0; l <= kLevels; ++l) {
    const ExactLevel exact = exact_.level(l);
    for (uint32_t j = 0; j < exact.count; ++j) {
      double ab[2];
      table_.support(l, j, ab);
      for (uint32_t c = 0; c < exact.cells; ++c) {
        const double middle = (c + 0.5) / exact.cells;
        const bool inside = (ab[0] < middle && middle < ab[1]) || middle + 1.0 < ab[1];
        EXPECT_EQ(inside, !(integralTo(exact.pieces[j][c], 1) == Rational(0)))
            << "level " << l << " function " << j << " cell " << c;
      }
    }
  }
}

TEST_P(Bases, TwoScale) {
  for (uint32_t l = 0; l < kLevels; ++l) {
    const RationalMatrix exact = exact_.twoScale(l);
    const BasisLevel& level = family_.level(l);
    const uint32_t fine = table_.count(l + 1);
    ASSERT_EQ(exact.size(), level.count);
    for (uint32_t j = 0; j < level.count; ++j) {
      ASSERT_EQ(exact[j].size(), fine);
      std::vector<double> plugin(fine, 0.0), compiled(fine, 0.0);
      uint32_t first = 0;
      double h[2 * AWD_BASIS_MAX_ORDER];
      const uint32_t size = table_.twoScale(l, j, &first, h);
      for (uint32_t i = 0; i < size; ++i) plugin[(first + i) % fine] += h[i];
      for (uint32_t i = level.twoScaleBegin[j]; i < level.twoScaleBegin[j + 1]; ++i) {
        compiled[level.twoScale[i].fine] += level.twoScale[i].value;
      }
      for (uint32_t k = 0; k < fine; ++k) {  // powers of 2 alone in the denominators: exact
        EXPECT_EQ(plugin[k], exact[j][k].value()) << "level " << l << ": " << j << " " << k;
        EXPECT_EQ(compiled[k], exact[j][k].value()) << "level " << l << ": " << j << " " << k;
      }
    }
  }
}

TEST_P(Bases, GramMatrix) {
  // Gauss's rule of three points is exact up to degree 5.
  constexpr double kPoints[] = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr double kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  for (uint32_t l = 0; l <= kLevels; ++l) {
    const RationalMatrix exact = exact_.level(l).gram();
    const BasisLevel& level = family_.level(l);
    const uint32_t n = level.count;
    const auto ours = gramMatrix(std::pmr::get_default_resource(), level);
    std::vector<double> quadrature(std::size_t{n} * n, 0.0);
    for (uint32_t c = 0; c < level.cells; ++c) {
      for (int p = 0; p < 3; ++p) {
        uint32_t first;
        double v[AWD_BASIS_MAX_ORDER];
        const uint32_t size = table_.eval(l, (c + kPoints[p]) / level.cells, &first, v);
        for (uint32_t a = 0; a < size; ++a) {
          for (uint32_t b = 0; b < size; ++b) {
            quadrature[(first + a) % n * n + (first + b) % n] +=
                kWeights[p] * v[a] * v[b] / level.cells;
          }
        }
      }
    }
    for (uint32_t j = 0; j < n; ++j) {
      for (uint32_t k = 0; k < n; ++k) {
        const double want = exact[j][k].value();
        ASSERT_NEAR(ours[j * n + k], want, 2e-16) << "level " << l << ": " << j << " " << k;
        ASSERT_NEAR(quadrature[j * n + k], want, 1e-15) << "level " << l << ": " << j << " " << k;
      }
    }
  }
}

/// G^-1 b by Gaussian elimination of the exact matrix, in long double.
std::vector<long double> eliminate(const RationalMatrix& gram, const std::vector<double>& b) {
  const std::size_t n = gram.size();
  std::vector<std::vector<long double>> rows(n, std::vector<long double>(n + 1));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) rows[i][k] = gram[i][k].value();
    rows[i][n] = b[i];
  }
  for (std::size_t p = 0; p < n; ++p) {  // positive definite: no pivoting
    for (std::size_t i = p + 1; i < n; ++i) {
      const long double factor = rows[i][p] / rows[p][p];
      if (factor == 0.0L) continue;
      for (std::size_t k = p; k <= n; ++k) rows[i][k] -= factor * rows[p][k];
    }
  }
  std::vector<long double> x(n);
  for (std::size_t i = n; i-- > 0;) {
    x[i] = rows[i][n];
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= rows[i][k] * x[k];
    x[i] /= rows[i][i];
  }
  return x;
}

TEST_P(Bases, GramSolver) {
  Uniforms random(11);
  for (uint32_t l = 0; l <= kLevels; ++l) {
    std::vector<double> b(table_.count(l));
    for (double& value : b) value = (2.0 * random() - 1.0) / table_.cells(l);
    const std::vector<long double> want = eliminate(exact_.level(l).gram(), b);
    const awd::GramSolver solver(std::pmr::get_default_resource(), family_.level(l));
    solver.solve(b.data(), 1, b.size(), 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      EXPECT_NEAR(b[j], static_cast<double>(want[j]), 1e-13) << "level " << l << ": " << j;
    }
  }
}

// --- the figures of the design ------------------------------------------------------------------

void expectRow(const ExactLevel& level, uint32_t j, uint32_t k, const std::vector<Rational>& want) {
  for (std::size_t i = 0; i < want.size(); ++i) {
    EXPECT_EQ(level.product(j, k + static_cast<uint32_t>(i)) * Rational(level.cells), want[i])
        << j << " " << k + i;
  }
}

TEST(BasesFigures, GramMatricesOverH) {
  const ExactLevel haar = ExactFamily("haar").level(3);
  expectRow(haar, 3, 2, {0, 1, 0});
  for (const char* name : {"linear-bspline", "linear-bspline-periodic"}) {
    expectRow(ExactFamily(name).level(4), 8, 6, {0, {1, 6}, {2, 3}, {1, 6}, 0});
  }
  expectRow(ExactFamily("linear-bspline").level(4), 0, 0, {{1, 3}, {1, 6}, 0});
  for (const char* name : {"quadratic-bspline", "quadratic-bspline-periodic"}) {
    expectRow(ExactFamily(name).level(4), 8, 5,
              {0, {1, 120}, {13, 60}, {11, 20}, {13, 60}, {1, 120}, 0});
  }
  const ExactLevel quadratic = ExactFamily("quadratic-bspline").level(2);
  expectRow(quadratic, 0, 0, {{1, 5}, {7, 60}, {1, 60}, 0});
  expectRow(quadratic, 1, 0, {{7, 60}, {1, 3}, {5, 24}, {1, 120}, 0});
  const ExactLevel m2 = ExactFamily("m2").level(1), m3 = ExactFamily("m3").level(1);
  expectRow(m2, 2, 1, {0, {2, 6}, {1, 6}});
  expectRow(m3, 3, 2, {0, {6, 30}, {3, 30}, {1, 30}});
  expectRow(m3, 4, 3, {{3, 30}, {4, 30}, {3, 30}});
}

/// Largest over smallest eigenvalue of D G D, by Jacobi's rotations.
double condition(const ExactLevel& level, bool scaled) {
  const std::size_t n = level.count;
  const RationalMatrix gram = level.gram();
  std::vector<std::vector<double>> a(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const double scale = scaled ? std::sqrt(gram[i][i].value() * gram[k][k].value()) : 1.0;
      a[i][k] = gram[i][k].value() / scale;
    }
  }
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (std::size_t p = 0; p < n; ++p) {
      for (std::size_t q = p + 1; q < n; ++q) {
        if (std::abs(a[p][q]) < 1e-15) continue;
        const double theta = 0.5 * std::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
        const double c = std::cos(theta), s = std::sin(theta);
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[k][p], y = a[k][q];
          a[k][p] = c * x - s * y;
          a[k][q] = s * x + c * y;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double x = a[p][k], y = a[q][k];
          a[p][k] = c * x - s * y;
          a[q][k] = s * x + c * y;
        }
      }
    }
  }
  double least = a[0][0], most = a[0][0];
  for (std::size_t i = 0; i < n; ++i) {
    least = std::min(least, a[i][i]);
    most = std::max(most, a[i][i]);
  }
  return most / least;
}

TEST(BasesFigures, ConditionNumbers) {
  const auto of = [](const char* name, uint32_t level, bool scaled = false) {
    return condition(ExactFamily(name).level(level), scaled);
  };
  EXPECT_NEAR(of("haar", 3), 1.0, 1e-12);
  EXPECT_NEAR(of("f2", 3), 1.0, 1e-12);
  EXPECT_NEAR(of("m2", 2), 3.0, 1e-12);
  EXPECT_NEAR(of("m3", 2), 10.0, 1e-11);
  EXPECT_NEAR(of("linear-bspline-periodic", 5), 3.0, 1e-12);
  EXPECT_NEAR(of("quadratic-bspline-periodic", 5), 7.5, 1e-11);
  EXPECT_NEAR(of("linear-bspline", 5), 4.0, 0.05);
  EXPECT_NEAR(of("linear-bspline", 5, true), 3.0, 0.01);
  EXPECT_NEAR(of("quadratic-bspline", 6), 10.6, 0.05);
  EXPECT_NEAR(of("quadratic-bspline", 6, true), 7.65, 0.05);
  EXPECT_NEAR(of("quadratic-bspline", 0), 10.0, 1e-11) << "one cell: that of m3";
  EXPECT_LT(of("quadratic-bspline", 0, true), 10.0);
}

TEST(BasesFigures, TheDualOfAParabolaIsNegative) {
  // f = x^2 on level 1: b_j = int f N_j = (1/96, 7/48, 17/96), c = (-1, 5, 23) / 24.
  const ExactLevel exact = ExactFamily("linear-bspline").level(1);
  std::vector<double> b;
  for (uint32_t j = 0; j < 3; ++j) {
    Rational sum;
    for (uint32_t c = 0; c < 2; ++c) {
      const Polynomial x = {{c, 2}, {1, 2}};
      sum = sum + integralTo(x * x * exact.pieces[j][c], 1) / Rational(2);
    }
    b.push_back(sum.value());
  }
  EXPECT_EQ(b[1], 7.0 / 48);
  const Family linear = family("linear-bspline", 1);
  const GramSolver solver(std::pmr::get_default_resource(), linear.level(1));
  solver.solve(b.data(), 1, 3, 1);
  EXPECT_NEAR(b[0], -1.0 / 24, 1e-15);
  EXPECT_NEAR(b[1], 5.0 / 24, 1e-15);
  EXPECT_NEAR(b[2], 23.0 / 24, 1e-15);
}

// --- samplers -----------------------------------------------------------------------------------

/// int_0^x N_j / w_j
class ExactCdf {
 public:
  ExactCdf(const ExactLevel& level, uint32_t j) : cells_(level.cells) {
    const Rational whole = level.weight(j) * Rational(level.cells);
    Rational before;
    for (const Polynomial& p : level.pieces[j]) {
      before_.push_back(before.value());
      std::vector<double> integral = {0.0};
      for (std::size_t i = 0; i < p.size(); ++i) {
        integral.push_back((p[i] / whole).value() / static_cast<double>(i + 1));
      }
      pieces_.push_back(integral);
      before = before + integralTo(p, 1) / whole;
    }
  }
  double operator()(double x) const {
    const double at = x * cells_;
    const auto cell = std::min(static_cast<uint32_t>(at), cells_ - 1);
    double value = 0.0;
    for (std::size_t i = pieces_[cell].size(); i-- > 0;) {
      value = value * (at - cell) + pieces_[cell][i];
    }
    return before_[cell] + value;
  }

 private:
  uint32_t cells_;
  std::vector<double> before_;
  std::vector<std::vector<double>> pieces_;
};

// Null hypothesis: the plugin's sampler, and the core's from the compiled tables, draw from
// N_j / w_j. The distribution function of the samples is uniform then: Kolmogorov and Smirnov, and
// chi-square over 16 bins of it. A false alarm in 1e-6 of each test (2 exp(-2 d^2) for d; the
// quantile of 15 degrees of freedom), 8e-4 in all 768 of the 8 families; seeds are fixed.
TEST_P(Bases, SamplersFollowTheFunctions) {
  constexpr int kSamples = 4096, kBins = 16;
  constexpr double kDistance = 2.694, kChiSquare = 56.49;
  Uniforms random(12);
  for (uint32_t l = 0; l <= 3; ++l) {
    const ExactLevel exact = exact_.level(l);
    for (uint32_t j = 0; j < exact.count; ++j) {
      const ExactCdf cdf(exact, j);
      for (const bool plugin : {true, false}) {
        std::vector<double> sorted(kSamples);
        std::vector<int> bins(kBins, 0);
        for (double& u : sorted) {
          double uniforms[AWD_BASIS_MAX_ORDER];
          for (uint32_t i = 0; i < table_.sampleDims; ++i) uniforms[i] = random();
          u = cdf(plugin ? table_.sample(l, j, uniforms)
                         : sampleComponent<double>(family_.level(l), j, uniforms[0]));
          ++bins[std::clamp(static_cast<int>(u * kBins), 0, kBins - 1)];
        }
        std::sort(sorted.begin(), sorted.end());
        double distance = 0.0, chiSquare = 0.0;
        for (int i = 0; i < kSamples; ++i) {
          distance = std::max({distance, std::abs(sorted[i] - i / double{kSamples}),
                               std::abs(sorted[i] - (i + 1) / double{kSamples})});
        }
        constexpr double kExpected = double{kSamples} / kBins;
        for (const int count : bins) {
          chiSquare += (count - kExpected) * (count - kExpected) / kExpected;
        }
        EXPECT_LT(distance * std::sqrt(double{kSamples}), kDistance)
            << (plugin ? "plugin" : "core") << " level " << l << " function " << j;
        EXPECT_LT(chiSquare, kChiSquare)
            << (plugin ? "plugin" : "core") << " level " << l << " function " << j;
      }
    }
  }
}

}  // namespace
}  // namespace awd
