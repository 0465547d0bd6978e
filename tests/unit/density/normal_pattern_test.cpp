// SPDX-License-Identifier: Apache-2.0
#include "density/normal_pattern.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "density/levels.h"
#include "density/refit.h"

namespace awd {
namespace {

/// Every N_j at a point, all others 0.
template <uint32_t D>
std::vector<double> valuesAt(const Shape& shape, const AxisValues* at) {
  std::size_t strides[D];
  for (uint32_t a = 0; a < D; ++a) strides[a] = shape.stride(a);
  std::vector<double> values(shape.size(), 0.0);
  forEachAlive<D>(strides, at, [&](std::size_t j, double n) { values[j] += n; });
  return values;
}

/// sum N_j N_k over random points, dense by brute force and through the pattern.
template <uint32_t D>
void compareOn(const std::vector<const char*>& names, uint32_t level) {
  std::vector<Family> families;
  for (const char* name : names) families.push_back(family(name, level));
  const BasisLevel* levels[D];
  for (uint32_t a = 0; a < D; ++a) levels[a] = &families[a].level(level);
  const Ref<NormalPattern> pattern = NormalPattern::make(memory(), levels, D);
  const std::size_t n = pattern->shape().size();
  std::vector<double> dense(n * n, 0.0), kept(pattern->size(), 0.0);
  Uniforms random(7);
  for (int i = 0; i < 300; ++i) {
    double x[D];
    for (double& t : x) t = i == 0 ? 1.0 : random();
    AxisValues at[D];
    evaluatePoint<D>(levels, x, at);
    const std::vector<double> values = valuesAt<D>(pattern->shape(), at);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) dense[j * n + k] += values[j] * values[k];
    }
    pattern->forEachAlive<D>(x, at, [&](std::size_t entry, double product) {
      ASSERT_LT(entry, kept.size());
      kept[entry] += product;
    });
  }
  std::vector<double> seen(n * n, 0.0);
  std::vector<int> times(n * n, 0);
  pattern->forEachPair([&](std::size_t entry, std::size_t j, std::size_t k, bool both) {
    seen[j * n + k] = kept[entry];
    ++times[j * n + k];
    if (both) seen[k * n + j] = kept[entry];
    if (both) ++times[k * n + j];
  });
  for (std::size_t i = 0; i < n * n; ++i) {
    ASSERT_NEAR(seen[i], dense[i], 1e-12) << i / n << ", " << i % n;
    ASSERT_LE(times[i], 1) << "told twice";
    ASSERT_TRUE(dense[i] == 0.0 || times[i] == 1) << i / n << ", " << i % n;
  }
}

TEST(NormalPattern, HoldsTheProductsOfAllPairs) {
  for (const char* name : kShipped) {
    SCOPED_TRACE(name);
    for (const uint32_t level : {0u, 1u, 3u}) compareOn<1>({name}, level);
    compareOn<2>({name, name}, 1);
  }
  compareOn<2>({"quadratic-bspline", "haar"}, 2);
  compareOn<2>({"f2", "linear-bspline-periodic"}, 2);
  compareOn<3>({"linear-bspline", "m2", "quadratic-bspline-periodic"}, 1);
}

TEST(NormalPattern, CountsPairsWithoutMakingThem) {
  // A band of 2 * order - 1 functions, of which the first axis keeps the upper half.
  const Family quadratic = family("quadratic-bspline", 4);
  const BasisLevel* level = &quadratic.level(4);
  const uint64_t n = level->count;
  EXPECT_EQ(NormalPattern::pairsOf(*level, false), 5 * n - 6);
  EXPECT_EQ(NormalPattern::pairsOf(*level, true), 3 * n - 3);
  const BasisLevel* levels[] = {level, level};
  EXPECT_EQ(NormalPattern::make(memory(), levels, 2)->size(), (3 * n - 3) * (5 * n - 6));
}

TEST(NormalPattern, GivesRowsOfAscendingColumns) {
  const Family a = family("quadratic-bspline-periodic", 2), b = family("m2", 2);
  const BasisLevel* levels[] = {&a.level(2), &b.level(2), &a.level(1)};
  const Ref<NormalPattern> pattern = NormalPattern::make(memory(), levels, 3);
  std::pmr::vector<BinnedSum> products(pattern->size());
  for (std::size_t i = 0; i < products.size(); ++i) products[i].add(double(i + 1), 0);
  NormalEquations equations(memory());
  equations.takeMatrix(*pattern, products, 1);
  ASSERT_EQ(equations.rowBegin.size(), pattern->shape().size() + 1);
  ASSERT_EQ(equations.rowBegin.back(), equations.values.size());
  const auto at = [&](std::size_t j, std::size_t k) {
    for (uint64_t i = equations.rowBegin[j]; i < equations.rowBegin[j + 1]; ++i) {
      if (equations.columns[i] == k) return equations.values[i];
    }
    return 0.0;
  };
  pattern->forEachPair([&](std::size_t entry, std::size_t j, std::size_t k, bool) {
    ASSERT_EQ(at(j, k), 0.5 * double(entry + 1));
  });
  for (std::size_t j = 0; j + 1 < equations.rowBegin.size(); ++j) {
    for (uint64_t i = equations.rowBegin[j] + 1; i < equations.rowBegin[j + 1]; ++i) {
      ASSERT_LT(equations.columns[i - 1], equations.columns[i]);
    }
  }
}

}  // namespace
}  // namespace awd
