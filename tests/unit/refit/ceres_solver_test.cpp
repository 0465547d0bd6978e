// SPDX-License-Identifier: Apache-2.0
#include "refit/ceres_solver.h"

#include <gtest/gtest.h>

#include "refit/descent.h"
#include "refit/solving.h"
#include "refit/sparse_factor.h"

namespace awd {
namespace {

Solved byCeres(const TestProblem& p) {
  Solved s;
  const std::string printed = printedBy([&] { s = solved(minimiseByCeres, p); });
  EXPECT_EQ(printed, "");
  return s;
}

/// Objective to 1e-8 of |Q|; coefficients to 1e-6 of the largest, where lambda makes them firm.
void expectAgreement(const TestProblem& p, bool regularised) {
  const Solved ours = solved(minimiseByDescent, p), theirs = byCeres(p);
  ASSERT_EQ(theirs.result, AWD_SUCCESS);
  EXPECT_EQ(theirs.outcome.status, AWD_REFIT_CONVERGED) << theirs.outcome.message;
  const auto best = static_cast<double>(p.objective(ours.c));
  EXPECT_NEAR(static_cast<double>(p.objective(theirs.c)), best, 1e-8 * std::abs(best))
      << theirs.outcome.message;
  double largest = 0.0;
  for (const double c : ours.c) largest = std::max(largest, std::abs(c));
  for (std::size_t j = 0; j < p.size(); ++j) {
    ASSERT_GE(theirs.c[j], p.lower[j]);
    ASSERT_NEAR(theirs.c[j], ours.c[j], (regularised ? 1e-6 : 1.0) * largest) << "unknown " << j;
  }
  EXPECT_TRUE(!regularised || theirs.outcome.atBound == ours.outcome.atBound);
}

/// spline, order, cells, dimensions, samples, lambda, floor, occupied, noise
const Recipe kRegularised[] = {
    {true, 1, 16, 1, 20, 0.5},
    {true, 2, 16, 1, 8, 1.0},
    {true, 2, 256, 1, 1000, 0x1p-6},
    {true, 3, 64, 1, 100, 0x1p-6},
    {true, 3, 10, 2, 300, 0.25},
    {true, 2, 16, 2, 1000, 0x1p-10},
    {true, 2, 16, 2, 100, 1.0},
    {true, 3, 12, 2, 6000, 0x1p-6, 0.01, 0.5},
    {true, 2, 4, 3, 500, 0x1p-6},
    {true, 2, 2, 4, 300, 0.5},
    {false, 2, 16, 1, 300, 0x1p-6},
    {false, 8, 8, 1, 500, 0x1p-10},
    {false, 3, 4, 2, 300, 0.5, 0.5},
    {true, 3, 32, 1, 500, 0x1p-6, 0.5},
    {true, 4, 32, 1, 2000, 0x1p-10, 0.01, 1.0, 5.0},
};

TEST(Ceres, AgreesWithDescent) {
  for (const Recipe& r : kRegularised) {
    SCOPED_TRACE("order " + std::to_string(r.order) + ", cells " + std::to_string(r.cells));
    expectAgreement(gramProblem(r), true);
  }
}

TEST(Ceres, AgreesInTheObjectiveWhereSamplesAreStarved) {
  for (const Recipe& r :
       {Recipe{true, 3, 128, 1, 80, 0x1p-26}, Recipe{true, 2, 12, 2, 150, 0x1p-26},
        Recipe{false, 6, 8, 1, 40, 0x1p-26}}) {
    SCOPED_TRACE("order " + std::to_string(r.order) + ", cells " + std::to_string(r.cells));
    expectAgreement(gramProblem(r), false);
  }
}

TEST(Ceres, DoesNotDependOnUnits) {
  // Its tolerances are absolute: values of 1e-12 once came back 67 % wrong.
  for (const double unit : {1e-100, 1e-12, 1e30}) {
    TestProblem p = gramProblem(kRegularised[4]);
    for (std::vector<double>* v : {&p.rhs, &p.lower, &p.start}) {
      for (double& value : *v) value *= unit;
    }
    SCOPED_TRACE(unit);
    expectAgreement(p, true);
  }
  TestProblem p = gramProblem(kRegularised[4]);
  std::mt19937_64 random(7);
  std::vector<double> factor(p.size());
  for (double& f : factor) f = std::pow(10.0, static_cast<double>(random() % 61) - 30.0);
  const Solved plain = byCeres(p);
  p.rescale(factor);
  const Solved scaled = byCeres(p);
  ASSERT_EQ(scaled.outcome.status, AWD_REFIT_CONVERGED);
  const double largest = *std::max_element(plain.c.begin(), plain.c.end());
  for (std::size_t j = 0; j < p.size(); ++j) {
    EXPECT_NEAR(scaled.c[j] * factor[j], plain.c[j], 1e-6 * largest);
  }
}

TEST(Ceres, MeetsAllBoundsOrNone) {
  TestProblem p = gramProblem(kRegularised[4]);
  p.lower.assign(p.size(), 10.0);
  p.start.assign(p.size(), 12.0);
  const Solved held = byCeres(p);
  EXPECT_EQ(held.outcome.status, AWD_REFIT_CONVERGED);
  EXPECT_EQ(held.c, p.lower);
  EXPECT_EQ(held.outcome.atBound, p.size());
  p.start = p.lower;  // nothing left to do, and nothing that may move
  EXPECT_EQ(byCeres(p).c, p.lower);

  p.lower.assign(p.size(), -50.0);
  p.start.assign(p.size(), 12.0);
  expectAgreement(p, true);
  EXPECT_EQ(byCeres(p).outcome.atBound, 0u);
}

TEST(Ceres, SolvesForOneUnknownAndForZeros) {
  TestProblem p = testProblem(1, {{{0, 0}, 4.0}}, {3.0}, {0.0});
  EXPECT_DOUBLE_EQ(byCeres(p).c[0], 0.75);
  p.rhs[0] = -3.0;
  EXPECT_EQ(byCeres(p).c[0], 0.0);

  p = gramProblem({});
  for (std::vector<double>* v : {&p.rhs, &p.lower, &p.start}) v->assign(p.size(), 0.0);
  const Solved s = byCeres(p);
  EXPECT_EQ(s.outcome.status, AWD_REFIT_CONVERGED) << s.outcome.message;
  EXPECT_EQ(s.c, p.start);
}

TEST(Ceres, StaysAtTheOptimum) {
  for (const Recipe& r : {kRegularised[2], kRegularised[3], kRegularised[10], kRegularised[13]}) {
    TestProblem p = gramProblem(r);
    p.start = byCeres(p).c;
    for (int i = 0; i < 3; ++i) {  // next to it steps are rounding, uphill as often as not
      const Solved again = byCeres(p);
      EXPECT_EQ(again.outcome.status, AWD_REFIT_CONVERGED) << again.outcome.message;
      for (std::size_t j = 0; j < p.size(); ++j) ASSERT_NEAR(again.c[j], p.start[j], 1e-10);
      for (std::size_t j = 0; j < p.size(); ++j) {
        p.start[j] =
            std::max(p.lower[j], again.c[j] * (1.0 + (static_cast<double>(j % 3) - 1.0) * 1e-13));
      }
    }
  }
}

TEST(Ceres, HasTheSameBitsAgain) {
  const TestProblem p = gramProblem(kRegularised[4]);
  EXPECT_EQ(byCeres(p).c, byCeres(p).c);
}

TEST(Ceres, KeepsSilentAboutBadProblems) {
  for (const TestProblem& p : poisonedProblems()) {
    const Solved s = byCeres(p);
    EXPECT_EQ(s.result, AWD_SUCCESS);
    EXPECT_EQ(s.outcome.status, AWD_REFIT_FAILED);
    EXPECT_STRNE(s.outcome.message, "");
  }
  // Positive minors, negative determinant: there is no factor.
  std::map<std::pair<uint32_t, uint32_t>, double> a;
  for (uint32_t j = 0; j < 3; ++j) {
    for (uint32_t k = 0; k < 3; ++k) a[{j, k}] = j == k ? 1.0 : -0.9;
  }
  const TestProblem p = testProblem(3, a, {1, 1, 1}, {0, 0, 0});
  const Solved s = byCeres(p);
  EXPECT_EQ(s.outcome.status, AWD_REFIT_FAILED);
  EXPECT_STREQ(s.outcome.message, "the matrix is not positive definite to rounding");
  EXPECT_EQ(s.c, p.start);
}

TEST(Ceres, KeepsSilentAtTheEndsOfTheNumbers) {
  // Whatever comes of them: no output, no abort, nothing that is not finite.
  for (const double large : {1e139, 1e-200, -1e139}) {
    for (const double diagonal : {1e-250, 1.0, 1e250}) {
      const double b = large * std::sqrt(diagonal), low = std::min(b, 0.0) / diagonal;
      const TestProblem p = testProblem(2,
                                        {{{0, 0}, diagonal},
                                         {{1, 1}, diagonal},
                                         {{0, 1}, -0.999999999 * diagonal},
                                         {{1, 0}, -0.999999999 * diagonal}},
                                        {b, 0.5 * b}, {low, 2.0 * low});
      for (const Minimise solver : {minimiseByCeres, minimiseByDescent}) {
        Solved s;
        EXPECT_EQ(printedBy([&] { s = solved(solver, p); }), "");
        for (const double c : s.c) EXPECT_TRUE(std::isfinite(c)) << s.outcome.message;
      }
    }
  }
}

TEST(Ceres, IsCancelledAnywhere) {
  const TestProblem p = gramProblem({true, 2, 8, 2, 100, 0.25});
  int calls = 0;
  while (true) {
    Patience host{calls + 1};
    AWDRefitProblem view = p.view();
    view.progress = &Patience::progress;
    view.user = &host;
    Solved s;
    EXPECT_EQ(printedBy([&] { s = solved(minimiseByCeres, view); }), "");
    if (s.result != AWD_ERROR_CANCELLED) break;
    EXPECT_EQ(s.c, p.start);
    ++calls;
  }
  EXPECT_GE(calls, 2);
}

TEST(SparseFactor, CountsItsEntriesBeforehand) {
  const TestProblem p = gramProblem(kRegularised[5]);
  const AWDRefitProblem view = p.view();
  const Quadratic q(view);
  const SparseFactor factor = sparseFactor(q, uint64_t{1} << 20);
  ASSERT_EQ(factor.lower.rows(), static_cast<int>(q.size()));
  EXPECT_EQ(factor.entries, static_cast<uint64_t>(factor.lower.nonZeros()));
  EXPECT_EQ(sparseFactor(q, factor.entries).lower.rows(), static_cast<int>(q.size()));
  const SparseFactor refused = sparseFactor(q, factor.entries - 1);
  EXPECT_EQ(refused.lower.rows(), 0);
  EXPECT_EQ(refused.entries, factor.entries);

  // P S A S P' = L L', entry by entry.
  const Eigen::SparseMatrix<double> product = factor.lower * factor.lower.transpose();
  std::vector<int> row(q.size());
  for (uint32_t i = 0; i < q.size(); ++i) row[factor.unknown[i]] = static_cast<int>(i);
  for (uint32_t j = 0; j < q.size(); ++j) {
    q.forEachEntry(j, [&](uint32_t k, double value) {
      EXPECT_NEAR(product.coeff(row[j], row[k]), value * factor.scale[j] * factor.scale[k], 1e-13);
    });
  }
}

}  // namespace
}  // namespace awd
