// SPDX-License-Identifier: Apache-2.0
#include "refit/free_solver.h"

#include <gtest/gtest.h>

#include "refit/conjugate_gradients.h"
#include "refit/cuthill_mckee.h"
#include "refit/solving.h"

namespace awd {
namespace {

using Vector = std::vector<double>;

/// spline, order, cells, dimensions, samples, lambda
const Recipe kRecipes[] = {{true, 3, 40, 1, 500, 0.1},
                           {true, 2, 12, 2, 500, 0.1},
                           {true, 3, 4, 3, 500, 0.1},
                           {false, 3, 5, 2, 500, 0.1},
                           {true, 1, 7, 1, 50, 0.1}};

/// Two thirds free, something on every diagonal.
FreeSet someFree(const Quadratic& q) {
  std::mt19937_64 random(3);
  FreeSet set(q.size());
  for (uint32_t j = 0; j < q.size(); ++j) {
    set.isFree[j] = random() % 3 > 0;
    set.extra[j] = q.diagonal(j) * static_cast<double>(random() % 8) / 8;
  }
  return set;
}

/// Largest component of (A + E)_FF x - r in units of the terms that it is a sum of.
double residual(const Quadratic& q, const FreeSet& set, const Vector& x, const Vector& r) {
  double largest = 0.0;
  for (uint32_t j = 0; j < q.size(); ++j) {
    if (!set.isFree[j]) continue;
    double sum = set.extra[j] * x[j] - r[j], terms = std::abs(sum) + std::abs(r[j]);
    q.forEachEntry(j, [&](uint32_t k, double value) {
      sum += value * x[k];
      terms += std::abs(value * x[k]);
    });
    largest = std::max(largest, std::abs(sum) / terms);
  }
  return largest;
}

TEST(FreeSolver, SolvesDirectlyAndByConjugateGradients) {
  for (const Recipe& recipe : kRecipes) {
    const TestProblem p = gramProblem(recipe);
    const AWDRefitProblem view = p.view();
    const Quadratic q(view);
    const FreeSet set = someFree(q);
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    Vector r(q.size(), 0.0);
    for (uint32_t j = 0; j < q.size(); ++j) {
      if (set.isFree[j]) r[j] = q.diagonal(j) * normal(random);
    }
    FreeSolver solver(q);
    solver.prepare(set, 0.0);
    Vector direct = r;
    solver.solve(direct);
    EXPECT_LT(residual(q, set, direct, r), 1e-13);

    Vector iterated = r;
    EXPECT_TRUE(conjugateGradients(q, set, 1e-12, 500, 0.0, iterated));
    EXPECT_LT(residual(q, set, iterated, r), 1e-9);
    for (uint32_t j = 0; j < q.size(); ++j) {
      EXPECT_TRUE(set.isFree[j] || (direct[j] == 0.0 && iterated[j] == 0.0));
    }
  }
}

TEST(FreeSolver, SolvesWithNoneAndWithOneFree) {
  const TestProblem p = gramProblem(kRecipes[1]);
  const AWDRefitProblem view = p.view();
  const Quadratic q(view);
  FreeSet set(q.size());
  FreeSolver solver(q);
  Vector x(q.size(), 1.0);
  solver.prepare(set, 0.0);
  solver.solve(x);
  EXPECT_EQ(x, Vector(q.size(), 0.0));
  set.isFree[5] = 1;
  x.assign(q.size(), 1.0);
  solver.prepare(set, 0.0);
  solver.solve(x);
  EXPECT_DOUBLE_EQ(x[5], 1.0 / q.diagonal(5));
}

TEST(CuthillMcKee, KeepsBandsShortAndPartsTogether) {
  // A grid numbered along its long axis has short rows only in the other order.
  const TestProblem p = gramProblem({true, 2, 20, 2, 2000, 0.1});
  const AWDRefitProblem view = p.view();
  const Quadratic q(view);
  std::vector<uint32_t> position(q.size());
  const std::vector<uint32_t> order = reverseCuthillMcKee(q);
  for (uint32_t i = 0; i < q.size(); ++i) position[order[i]] = i;
  uint32_t widest = 0;
  for (uint32_t j = 0; j < q.size(); ++j) {
    q.forEachEntry(j, [&](uint32_t k, double) {
      widest =
          std::max(widest, std::max(position[j], position[k]) - std::min(position[j], position[k]));
    });
  }
  EXPECT_LE(widest, 3u * 21u);

  const TestProblem leaves = gramProblem({false, 3, 9, 1, 500, 0.1});
  const AWDRefitProblem leavesView = leaves.view();
  const Quadratic blocks(leavesView);
  const std::vector<uint32_t> inBlocks = reverseCuthillMcKee(blocks);
  for (uint32_t i = 0; i < blocks.size(); ++i) EXPECT_EQ(inBlocks[i] / 3, inBlocks[i - i % 3] / 3);
}

}  // namespace
}  // namespace awd
