// SPDX-License-Identifier: Apache-2.0
// The topology of a tree, and the sums of samples at all of its nodes, also those above the leaves.
#include "density/tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "density/levels.h"
#include "density/tree_sums.h"

namespace awd {
namespace {

/// Random leaves are halved along random axes.
Tree someTree(uint32_t dimensions, std::size_t leaves, Uniforms& random) {
  Tree tree(memory(), dimensions);
  while (tree.nodes().size() < 2 * leaves - 1) {
    const auto node = static_cast<uint32_t>(random() * double(tree.nodes().size()));
    if (tree.nodes()[node].leaf()) tree.split(node, static_cast<uint32_t>(random() * dimensions));
  }
  tree.finish();
  return tree;
}

bool holds(const TreeBox& box, uint32_t dimensions, const double* x) {
  for (uint32_t a = 0; a < dimensions; ++a) {
    const double upper = box.lower[a] + box.size(a);
    if (!(box.lower[a] <= x[a] && (x[a] < upper || (x[a] == 1.0 && upper == 1.0)))) return false;
  }
  return true;
}

TEST(Tree, BoxesAreHalved) {
  TreeBox box;
  EXPECT_EQ(box.volume(3), 1.0);
  box = box.half(1, 1).half(1, 0).half(0, 1);
  EXPECT_EQ(box.lower[0], 0.5);
  EXPECT_EQ(box.lower[1], 0.5);
  EXPECT_EQ(box.lower[2], 0.0);
  EXPECT_EQ(box.size(0), 0.5);
  EXPECT_EQ(box.size(1), 0.25);
  EXPECT_EQ(box.size(2), 1.0);
  EXPECT_EQ(box.volume(3), 0.125);
}

TEST(Tree, StartsWithEqualBoxes) {
  const uint32_t depth[] = {3, 0, 1};
  const Tree tree(memory(), 3, depth);
  EXPECT_EQ(tree.leaves(), 16u);
  std::size_t leaves = 0;
  tree.walk([&](uint32_t node, const TreeBox& box) {
    if (!tree.nodes()[node].leaf()) return;
    EXPECT_EQ(tree.nodes()[node].child, leaves++) << "numbered as they are walked";
    for (uint32_t a = 0; a < 3; ++a) EXPECT_EQ(box.depth[a], depth[a]);
  });
  EXPECT_EQ(leaves, 16u);
}

TEST(Tree, LeavesTileTheCube) {
  Uniforms random(1);
  for (const uint32_t d : {1u, 2u, 6u}) {
    const Tree tree = someTree(d, 60, random);
    EXPECT_EQ(tree.leaves(), 60u);
    EXPECT_EQ(tree.nodes().size(), 119u);
    double volume = 0.0;
    std::vector<TreeBox> boxes(60);
    tree.walk([&](uint32_t node, const TreeBox& box) {
      const TreeNode& here = tree.nodes()[node];
      if (here.leaf()) {
        volume += box.volume(d);
        boxes[here.child] = box;
      } else {
        EXPECT_GT(here.child, node) << "children come after their parent";
      }
    });
    EXPECT_EQ(volume, 1.0);
    for (int i = 0; i < 500; ++i) {
      double x[kMaxDimensions], t[kMaxDimensions];
      for (uint32_t a = 0; a < d; ++a) {
        const double u = random();
        x[a] = u < 0.1 ? 1.0 : u < 0.3 ? std::floor(16.0 * u) / 16.0 : u;
      }
      std::copy(x, x + d, t);
      const TreeNode& leaf = tree.descend(t);
      ASSERT_TRUE(leaf.leaf());
      const TreeBox& box = boxes[leaf.child];
      EXPECT_TRUE(holds(box, d, x));
      EXPECT_EQ(std::count_if(boxes.begin(), boxes.end(),
                              [&](const TreeBox& b) { return holds(b, d, x); }),
                1);
      for (uint32_t a = 0; a < d; ++a) EXPECT_EQ(box.lower[a] + t[a] * box.size(a), x[a]);
    }
  }
}

/// A tree rebuilt from its nodes is the same.
TEST(Tree, FromItsNodes) {
  Uniforms random(2);
  const Tree tree = someTree(3, 40, random);
  std::pmr::vector<TreeNode> nodes = tree.nodes();
  for (TreeNode& node : nodes) {
    if (node.leaf()) node.child = 12345;  // numbered anew
  }
  const Tree again(3, std::move(nodes));
  EXPECT_EQ(again.leaves(), 40u);
  for (std::size_t i = 0; i < tree.nodes().size(); ++i) {
    EXPECT_EQ(again.nodes()[i].axis, tree.nodes()[i].axis);
    EXPECT_EQ(again.nodes()[i].child, tree.nodes()[i].child);
  }
}

/// The sums of every node by looking at every sample; all in the same unknown unit each.
TEST(Tree, SumsOfEveryNode) {
  Uniforms random(3);
  for (const AWDTarget target : {AWD_TARGET_MEAN, AWD_TARGET_RMS}) {
    const AWDBasisFamily* tables[] = {&table("m3"), &table("f2")};
    const DensityBases::Axis axes[] = {{tables[0], 1}, {tables[1], 1}};
    const Ref<DensityBases> bases = DensityBases::make(memory(), axes, 2);
    const BasisLevel* levels[kMaxDimensions];
    bases->tables({}, levels);
    const std::size_t size = bases->shape({}).size();
    Tree tree = someTree(2, 20, random);
    Coefficients c(20 * size, 0.0);
    for (double& value : c) value = 0.5 + random();
    const Ref<TreeDensity> density =
        TreeDensity::make(memory(), levels, std::move(tree), std::move(c), Scale::toIntegral);

    constexpr std::size_t kSamples = 400;
    std::vector<double> points(2 * kSamples), p(kSamples), f(kSamples);
    for (double& x : points) x = random();
    for (double& value : f) value = 4.0 * random() - 2.0;
    density->pdf(kSamples, points.data(), p.data());
    DensityStatistics statistics(memory(), 20 * size, 20 * 3, 0);
    density->record(kSamples, points.data(), p.data(), f.data(), target, statistics);
    const TreeSums sums(*bases, *density, statistics);

    double valueUnit = 0.0, weightUnit = 0.0;
    density->tree().walk([&](uint32_t node, const TreeBox& box) {
      Coefficients values(size, 0.0), weights(size, 0.0), counts(size, 0.0);
      BoxSums whole, lower[2];
      double count = 0.0;
      for (std::size_t i = 0; i < kSamples; ++i) {
        if (!holds(box, 2, &points[2 * i])) continue;
        count += 1.0;
        const double aim = target == AWD_TARGET_RMS ? f[i] * f[i] : std::fabs(f[i]);
        AxisValues at[2];
        for (uint32_t a = 0; a < 2; ++a) {
          const double t = (points[2 * i + a] - box.lower[a]) / box.size(a);
          evaluateAxis(*levels[a], t, at[a]);
          if (t >= 0.5) continue;
          lower[a].weight += 1.0 / p[i];
          lower[a].value += aim / p[i];
          lower[a].square += aim * aim / p[i];
        }
        whole.weight += 1.0 / p[i];
        whole.value += aim / p[i];
        whole.square += aim * aim / p[i];
        for (uint32_t j = 0; j < at[0].count; ++j) {
          for (uint32_t k = 0; k < at[1].count; ++k) {
            const std::size_t to = at[0].function[j] * levels[1]->count + at[1].function[k];
            const double n = at[0].value[j] * at[1].value[k];
            values[to] += aim * n / p[i];
            weights[to] += n / p[i];
            counts[to] += n;
          }
        }
      }
      if (node == 0) {
        valueUnit = sums.whole(0).value / whole.value;
        weightUnit = sums.whole(0).weight / whole.weight;
      }
      const double squareUnit = valueUnit * valueUnit / weightUnit;
      const auto expectSums = [&](const BoxSums& seen, const BoxSums& expected) {
        EXPECT_NEAR(seen.weight / weightUnit, expected.weight, 1e-10);
        EXPECT_NEAR(seen.value / valueUnit, expected.value, 1e-10);
        EXPECT_NEAR(seen.square / squareUnit, expected.square, 1e-10);
      };
      SCOPED_TRACE(node);
      EXPECT_NEAR(sums.count(node), count, 1e-6);
      expectSums(sums.whole(node), whole);
      for (uint32_t a = 0; a < 2; ++a) expectSums(sums.lower(node, a), lower[a]);
      for (std::size_t j = 0; j < size; ++j) {
        EXPECT_NEAR(sums.values(node)[j] / valueUnit, values[j], 1e-10);
        EXPECT_NEAR(sums.weights(node)[j] / weightUnit, weights[j], 1e-10);
        EXPECT_NEAR(sums.counts(node)[j], counts[j], 1e-6);
      }
    });
  }
}

}  // namespace
}  // namespace awd
