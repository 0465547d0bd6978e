// SPDX-License-Identifier: Apache-2.0
#include "density/tree_matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

/// Four leaves of different sizes: matrices of all nodes against sums over the samples in each, of
/// that node's own functions.
void compareOn(const char* first, const char* second) {
  const AWDBasisFamily& a = table(first);
  const AWDBasisFamily& b = table(second);
  const DensityBases::Axis axes[] = {{&a, 1}, {&b, 1}};
  const Ref<DensityBases> bases = DensityBases::make(memory(), axes, 2);
  const BasisLevel* levels[2];
  bases->tables({}, levels);
  Tree tree(memory(), 2);
  tree.split(0, 1);
  tree.split(tree.nodes()[0].child, 0);
  tree.split(tree.nodes()[0].child + 1, 1);
  tree.finish();
  const std::size_t size = bases->shape({}).size();
  const Ref<TreeDensity> density = TreeDensity::make(
      memory(), levels, tree, Coefficients(4 * size, 1.0, memory()), Scale::toIntegral);
  DensityStatistics statistics(memory(), 4 * size, 4 * 3, 0,
                               NormalPattern::make(memory(), levels, 2), 4);
  constexpr int kSamples = 500;
  Uniforms random(3);
  std::vector<double> points(2 * kSamples), pdfs(kSamples), values(kSamples, 1.0);
  for (double& x : points) x = random();
  for (double& p : pdfs) p = 0.5 + random();
  density->record(kSamples, points.data(), pdfs.data(), values.data(), AWD_TARGET_MEAN, statistics);

  const TreeMatrices matrices(*bases, *density, statistics.normal, 3);
  const std::size_t strides[] = {bases->shape({}).stride(0), 1};
  Coefficients matrix(memory());
  tree.walk([&](uint32_t node, const TreeBox& box) {
    std::vector<double> expected(size * size, 0.0);
    for (int i = 0; i < kSamples; ++i) {
      double t[2];
      bool inside = true;
      for (uint32_t k = 0; k < 2; ++k) {
        t[k] = (points[2 * i + k] - box.lower[k]) / box.size(k);
        inside = inside && t[k] >= 0.0 && t[k] < 1.0;
      }
      if (!inside) continue;
      AxisValues at[2];
      evaluatePoint<2>(levels, t, at);
      std::vector<double> n(size, 0.0);
      forEachAlive<2>(strides, at, [&](std::size_t j, double value) { n[j] += value; });
      for (std::size_t j = 0; j < size * size; ++j) {
        expected[j] += n[j / size] * n[j % size] / pdfs[i] / 8.0;
      }
    }
    matrices.of(node, matrix);
    for (std::size_t j = 0; j < size * size; ++j) {
      ASSERT_NEAR(matrix[j], expected[j], 1e-11) << first << " node " << node << " entry " << j;
    }
  });
}

TEST(TreeMatrices, AreTheSumsOfEveryNodesOwnFunctions) {
  for (const char* name : kNested) compareOn(name, name);
  compareOn("m3", "f2");
}

}  // namespace
}  // namespace awd
