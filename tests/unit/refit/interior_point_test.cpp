// SPDX-License-Identifier: Apache-2.0
#include "refit/interior_point.h"

#include <gtest/gtest.h>

#include "refit/descent.h"
#include "refit/solving.h"

namespace awd {
namespace {

/// From far away and without any hint it ends next to the optimum, and knows what the bounds hold.
TEST(InteriorPoint, FindsTheBounds) {
  for (const Recipe& r : {Recipe{true, 3, 64, 1, 100, 0x1p-20}, Recipe{true, 2, 8, 2, 200, 0x1p-10},
                          Recipe{false, 4, 8, 1, 100, 0x1p-10}}) {
    const TestProblem p = gramProblem(r);
    const AWDRefitProblem view = p.view();
    const Quadratic q(view);
    const Solved exact = solved(minimiseByDescent, p);
    ASSERT_EQ(exact.outcome.status, AWD_REFIT_CONVERGED);
    FreeSolver solver(q);
    FreeSet set(q.size());
    std::vector<double> x(q.size(), 3.0);
    followCentralPath(q, solver, 0.0, set, x);
    const double largest = *std::max_element(exact.c.begin(), exact.c.end());
    for (uint32_t j = 0; j < q.size(); ++j) {
      EXPECT_GE(x[j], p.lower[j]);
      EXPECT_NEAR(x[j], exact.c[j], 1e-6 * largest);
      EXPECT_EQ(static_cast<bool>(set.isFree[j]), exact.c[j] > p.lower[j]) << "unknown " << j;
    }
  }
}

}  // namespace
}  // namespace awd
