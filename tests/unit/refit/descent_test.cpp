// SPDX-License-Identifier: Apache-2.0
#include "refit/descent.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "refit/solving.h"

namespace awd {
namespace {

using Vector = std::vector<double>;

Solved descended(const TestProblem& p) { return solved(minimiseByDescent, p); }

/// A = M' M + shift 1, dense; b of any sign.
TestProblem randomProblem(uint32_t n, double shift, uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Vector> m(n, Vector(n));
  for (Vector& row : m) {
    for (double& value : row) value = normal(random);
  }
  std::map<std::pair<uint32_t, uint32_t>, double> a;
  for (uint32_t j = 0; j < n; ++j) {
    for (uint32_t k = 0; k <= j; ++k) {
      double sum = j == k ? shift : 0.0;
      for (uint32_t i = 0; i < n; ++i) sum += m[i][j] * m[i][k];
      a[{j, k}] = a[{k, j}] = sum;
    }
  }
  Vector rhs(n), lower(n);
  for (double& value : rhs) value = normal(random);
  for (double& value : lower) value = 0.3 * normal(random);
  return testProblem(n, a, rhs, lower);
}

/// The optimum over the unknowns of a bit set, the others at their bounds, in long double.
std::optional<Vector> optimumOf(const TestProblem& p, uint32_t freeBits) {
  const auto n = static_cast<uint32_t>(p.size());
  std::vector<std::vector<long double>> rows;
  std::vector<uint32_t> unknown;
  Vector c = p.lower;
  for (uint32_t j = 0; j < n; ++j) {
    if (freeBits >> j & 1) unknown.push_back(j);
  }
  TestProblem copy = p;
  for (const uint32_t j : unknown) {
    rows.emplace_back();
    for (const uint32_t k : unknown) rows.back().push_back(copy.at(j, k));
    long double right = p.rhs[j];
    for (uint32_t k = 0; k < n; ++k) {
      if (!(freeBits >> k & 1)) right -= static_cast<long double>(copy.at(j, k)) * p.lower[k];
    }
    rows.back().push_back(right);
  }
  const std::size_t size = unknown.size();
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t r = 0; r < size; ++r) {
      if (r == i) continue;
      const long double part = rows[r][i] / rows[i][i];
      for (std::size_t k = i; k <= size; ++k) rows[r][k] -= part * rows[i][k];
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    c[unknown[i]] = static_cast<double>(rows[i][size] / rows[i][i]);
    if (c[unknown[i]] < p.lower[unknown[i]]) return std::nullopt;
  }
  return c;
}

TEST(Descent, FindsTheBestOfAllActiveSets) {
  for (uint32_t n = 1; n <= 8; ++n) {
    for (uint64_t seed = 1; seed <= 12; ++seed) {
      const TestProblem p = randomProblem(n, seed % 2 ? 1.0 : 1e-3, 100 * n + seed);
      Vector best = p.lower;
      for (uint32_t bits = 0; bits < 1u << n; ++bits) {
        const auto c = optimumOf(p, bits);
        if (c && p.objective(*c) < p.objective(best)) best = *c;
      }
      const Solved s = descended(p);
      ASSERT_EQ(s.outcome.status, AWD_REFIT_CONVERGED) << s.outcome.message;
      for (uint32_t j = 0; j < n; ++j) {
        ASSERT_NEAR(s.c[j], best[j], 1e-11) << "n " << n << " seed " << seed << " unknown " << j;
        ASSERT_EQ(s.c[j] == p.lower[j], best[j] == p.lower[j]);
      }
    }
  }
}

TEST(Descent, SolvesWithoutBounds) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    TestProblem p = randomProblem(20, 0.1, seed);
    p.lower.assign(20, -1e6);
    p.start = p.lower;
    const Vector exact = *optimumOf(p, (1u << 20) - 1);
    const Solved s = descended(p);
    ASSERT_EQ(s.outcome.status, AWD_REFIT_CONVERGED);
    EXPECT_EQ(s.outcome.atBound, 0u);
    for (uint32_t j = 0; j < 20; ++j) EXPECT_NEAR(s.c[j], exact[j], 1e-11);
  }
}

/// spline, order, cells, dimensions, samples, lambda, floor, occupied, noise, decades
const Recipe kRecipes[] = {
    {true, 1, 64, 1, 100, 0x1p-30},
    {true, 2, 16, 1, 1000, 1.0},
    {true, 3, 256, 1, 1000, 0x1p-30},
    {true, 4, 512, 1, 300, 0x1p-30},            // starved: pivoting alone goes round in circles
    {true, 8, 128, 1, 200, 0x1p-30},            //
    {true, 2, 24, 2, 600, 0x1p-30},             //
    {true, 3, 16, 2, 4000, 0x1p-10},            //
    {true, 3, 16, 2, 500, 0x1p-30, 0.01, 0.4},  // most cells never visited
    {true, 3, 16, 2, 500, 0x1p-20, 0.01, 1.0, 0.5, 60.0},
    {true, 2, 6, 3, 500, 0x1p-30},
    {true, 3, 5, 3, 2000, 0x1p-6},
    {true, 3, 12, 3, 3000, 0x1p-4},  // by conjugate gradients
    {true, 2, 2, 4, 500, 0x1p-30},
    {true, 2, 1, 6, 500, 0x1p-30},
    {false, 2, 64, 1, 300, 0x1p-30},
    {false, 8, 32, 1, 400, 0x1p-30},
    {false, 8, 2, 2, 400, 0x1p-30},
    {false, 3, 8, 2, 4000, 0x1p-10},
    {false, 5, 1, 3, 300, 0x1p-30},
};

TEST(Descent, IsOptimalToRounding) {
  for (const Recipe& r : kRecipes) {
    const TestProblem p = gramProblem(r);
    const Solved s = descended(p);
    const Optimality o = optimalityOf(p, s.c);
    EXPECT_EQ(s.outcome.status, AWD_REFIT_CONVERGED)
        << "order " << r.order << ", cells " << r.cells << ": " << s.outcome.message;
    EXPECT_LT(o.violation, r.decades > 0.0 ? 1e-11 : 1e-14)
        << "order " << r.order << ", cells " << r.cells << ": " << s.outcome.message;
    EXPECT_EQ(s.outcome.atBound, o.atBound);
    for (std::size_t j = 0; j < p.size(); ++j) ASSERT_GE(s.c[j], p.lower[j]);
    EXPECT_LE(p.objective(s.c), p.objective(p.start));
  }
}

TEST(Descent, HasTheSameBitsAgain) {
  for (const Recipe& r : {kRecipes[3], kRecipes[6], kRecipes[9]}) {
    const TestProblem p = gramProblem(r);
    EXPECT_EQ(descended(p).c, descended(p).c);
  }
}

TEST(Descent, DoesNotDependOnUnits) {
  // Powers of two change no digit; these span 60 decades.
  std::mt19937_64 random(7);
  for (const Recipe& r : {kRecipes[3], kRecipes[6], kRecipes[10], kRecipes[15]}) {
    const TestProblem p = gramProblem(r);
    TestProblem other = p;
    Vector factor(p.size());
    for (double& f : factor) f = std::ldexp(1.0, static_cast<int>(random() % 201) - 100);
    other.rescale(factor);
    const Solved a = descended(p), b = descended(other);
    EXPECT_EQ(a.outcome.iterations, b.outcome.iterations);
    for (std::size_t j = 0; j < p.size(); ++j) ASSERT_EQ(b.c[j] * factor[j], a.c[j]);
  }
}

TEST(Descent, EndsAtBoundsThatHoldEverything) {
  TestProblem p = gramProblem(kRecipes[6]);
  p.lower.assign(p.size(), 10.0);
  p.start.assign(p.size(), 12.0);
  const Solved s = descended(p);
  EXPECT_EQ(s.outcome.status, AWD_REFIT_CONVERGED);
  EXPECT_EQ(s.c, p.lower);
  EXPECT_EQ(s.outcome.atBound, p.size());
}

TEST(Descent, SolvesNothingButZeros) {
  TestProblem p = gramProblem({});
  for (Vector* v : {&p.rhs, &p.lower, &p.start}) v->assign(p.size(), 0.0);
  const Solved s = descended(p);
  EXPECT_EQ(s.outcome.status, AWD_REFIT_CONVERGED);
  EXPECT_EQ(s.c, p.start);
}

TEST(Descent, RefusesWhatHasNoOptimum) {
  // Every 2 x 2 minor is positive, the determinant negative: Q falls for ever along (1, 1, 1).
  std::map<std::pair<uint32_t, uint32_t>, double> a;
  for (uint32_t j = 0; j < 3; ++j) {
    for (uint32_t k = 0; k < 3; ++k) a[{j, k}] = j == k ? 1.0 : -0.9;
  }
  const Solved s = descended(testProblem(3, a, {1, 1, 1}, {0, 0, 0}));
  EXPECT_EQ(s.result, AWD_SUCCESS);
  EXPECT_NE(s.outcome.status, AWD_REFIT_CONVERGED) << s.outcome.message;
  for (const double value : s.c) EXPECT_TRUE(std::isfinite(value));
}

TEST(Descent, HandsBackTheStartOfBadProblems) {
  for (const TestProblem& p : poisonedProblems()) {
    Solved s;
    const std::string printed = printedBy([&] { s = descended(p); });
    EXPECT_EQ(printed, "");
    EXPECT_EQ(s.result, AWD_SUCCESS);
    EXPECT_EQ(s.outcome.status, AWD_REFIT_FAILED);
    EXPECT_STRNE(s.outcome.message, "");
    for (std::size_t j = 0; j < p.size(); ++j) {
      EXPECT_TRUE(s.c[j] == p.start[j] || std::isnan(p.start[j]));
    }
  }
}

TEST(Descent, IsCancelledAnywhere) {
  const TestProblem p = gramProblem(kRecipes[3]);
  int calls = 0;
  for (bool cancelled = true; cancelled; ++calls) {
    Patience host{calls + 1};
    AWDRefitProblem view = p.view();
    view.progress = &Patience::progress;
    view.user = &host;
    const Solved s = solved(minimiseByDescent, view);
    cancelled = s.result == AWD_ERROR_CANCELLED;
    if (!cancelled) break;
    EXPECT_EQ(s.c, p.start);
    EXPECT_EQ(s.outcome.status, AWD_REFIT_FAILED);
  }
  EXPECT_GE(calls, 4);
}

}  // namespace
}  // namespace awd
