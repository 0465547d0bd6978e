// SPDX-License-Identifier: Apache-2.0
#include "density/gram.h"

#include <gtest/gtest.h>

#include <vector>

#include "density/axis.h"
#include "density/levels.h"

namespace awd {
namespace {

/// int N_j N_k by Gauss-Legendre with three points a cell, exact up to degree 5, of the plugin.
std::vector<double> byQuadrature(const AWDBasisFamily& t, uint32_t level) {
  constexpr double kPoints[] = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr double kWeights[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const uint32_t n = t.count(level);
  const uint32_t cells = t.cells(level);
  std::vector<double> gram(n * n, 0.0);
  for (uint32_t c = 0; c < cells; ++c) {
    for (int p = 0; p < 3; ++p) {
      uint32_t first;
      double v[AWD_BASIS_MAX_ORDER];
      const uint32_t alive = t.eval(level, (c + kPoints[p]) / cells, &first, v);
      for (uint32_t a = 0; a < alive; ++a) {
        for (uint32_t b = 0; b < alive; ++b) {
          gram[(first + a) % n * n + (first + b) % n] += kWeights[p] * v[a] * v[b] / cells;
        }
      }
    }
  }
  return gram;
}

TEST(Gram, AgreesWithQuadratureEntryByEntry) {
  for (const char* name : kFamilies) {
    const Family compiled = family(name);
    for (uint32_t l = 0; l <= 5; ++l) {
      const auto exact = gramMatrix(std::pmr::get_default_resource(), compiled.level(l));
      const std::vector<double> reference = byQuadrature(table(name), l);
      ASSERT_EQ(exact.size(), reference.size());
      for (std::size_t i = 0; i < exact.size(); ++i) {
        ASSERT_NEAR(exact[i], reference[i], 1e-15) << name << " level " << l << " entry " << i;
      }
    }
  }
}

TEST(Gram, HasTheTextbookEntriesInside) {
  constexpr double h = 1.0 / 32;
  const Family linear = family("test-linear");
  const auto g1 = gramMatrix(std::pmr::get_default_resource(), linear.level(5));
  EXPECT_NEAR(g1[10 * 33 + 10], h * 2 / 3, 1e-15);
  EXPECT_NEAR(g1[10 * 33 + 11], h / 6, 1e-15);
  const Family quadratic = family("test-quadratic");
  const auto g2 = gramMatrix(std::pmr::get_default_resource(), quadratic.level(5));
  EXPECT_NEAR(g2[10 * 34 + 10], h * 11 / 20, 1e-15);
  EXPECT_NEAR(g2[10 * 34 + 11], h * 13 / 60, 1e-15);
  EXPECT_NEAR(g2[10 * 34 + 12], h / 120, 1e-15);
}

TEST(Gram, SolvesBack) {
  Uniforms random(4);
  for (const char* name : kFamilies) {
    const Family compiled = family(name);
    for (uint32_t l = 0; l <= 6; ++l) {
      const BasisLevel& level = compiled.level(l);
      const uint32_t n = level.count;
      const auto gram = gramMatrix(std::pmr::get_default_resource(), level);
      const GramSolver solver(std::pmr::get_default_resource(), level);
      // Two vectors at once, interleaved: element j of vector v at 2 j + v.
      std::vector<double> x(2 * n), b(2 * n, 0.0);
      for (double& value : x) value = random();
      for (uint32_t j = 0; j < n; ++j) {
        for (uint32_t k = 0; k < n; ++k) {
          for (int v = 0; v < 2; ++v) b[2 * j + v] += gram[j * n + k] * x[2 * k + v];
        }
      }
      solver.solve(b.data(), 2, 1, 2);
      for (std::size_t i = 0; i < x.size(); ++i) {
        ASSERT_NEAR(b[i], x[i], 1e-12) << name << " level " << l;
      }
    }
  }
}

}  // namespace
}  // namespace awd
