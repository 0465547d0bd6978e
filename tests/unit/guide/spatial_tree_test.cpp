// SPDX-License-Identifier: Apache-2.0
#include "guide/spatial_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "density/levels.h"

namespace awd {
namespace {

constexpr uint32_t kEighths = SpatialTree::kEighths;

SpatialTree makeTree() {
  return SpatialTree(std::pmr::get_default_resource(), {-1, -2, -3}, {4, 5, 6});
}

Vec3f somewhere(Uniforms& random) {
  return {static_cast<float>(-1 + 5 * random()), static_cast<float>(-2 + 7 * random()),
          static_cast<float>(-3 + 9 * random())};
}

TEST(SpatialTree, HasALeafForEachDirectionOfNormals) {
  const SpatialTree tree = makeTree();
  std::set<uint32_t> leaves;
  for (const Vec3f n : {Vec3f{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
    leaves.insert(tree.find({1, 1, 1}, n) / kEighths);
  }
  EXPECT_EQ(leaves.size(), 6u);
  EXPECT_EQ(tree.leaves(), 6u);
  EXPECT_EQ(tree.find({1, 1, 1}, normalized(Vec3f{0.1f, 0.2f, -0.9f})) / kEighths,
            tree.find({1, 1, 1}, {0, 0, -1}) / kEighths);
}

TEST(SpatialTree, OfManyLeavesStillFindsEachPointWhereItWas) {
  // Far beyond where the table of the first levels grows: a split moves points of its leaf alone.
  SpatialTree tree = makeTree();
  Uniforms random(52);
  std::vector<std::pair<Vec3f, uint32_t>> points;
  for (int i = 0; i < 400; ++i) {
    const Vec3f p = somewhere(random);
    points.emplace_back(p, tree.find(p, {0, 0, 1}));
  }
  while (tree.leaves() < 600) {
    const uint32_t leaf = points[tree.leaves() % points.size()].second / kEighths;
    const uint32_t other = tree.split(leaf, tree.leaves() % 2);
    tree.finish();
    for (auto& [p, number] : points) {
      const uint32_t now = tree.find(p, {0, 0, 1});
      if (number / kEighths == leaf) {
        ASSERT_TRUE(now / kEighths == leaf || now / kEighths == other);
      } else {
        ASSERT_EQ(now, number) << tree.leaves() << " leaves";
      }
      number = now;
    }
  }
}

TEST(SpatialTree, HalvesAsTheEighthsForetell) {
  for (const uint32_t keeper : {0u, 1u}) {
    SpatialTree tree = makeTree();
    Uniforms random(50);
    for (int depth = 1; depth <= 40; ++depth) {
      // The leaf of a point is halved; all points of it go where their eighth says.
      const Vec3f around = {0.7f, 1.3f, 2.1f};
      const uint32_t leaf = tree.find(around, {0, 0, 1}) / kEighths;
      std::vector<std::pair<Vec3f, uint32_t>> before;
      for (int i = 0; i < 200; ++i) {
        const Vec3f p = somewhere(random) * 0.02f + around;
        before.emplace_back(p, tree.find(p, {0, 0, 1}));
      }
      ASSERT_TRUE(tree.canSplit(leaf));
      const uint32_t other = tree.split(leaf, keeper);
      tree.finish();
      EXPECT_EQ(other, tree.leaves() - 1);
      EXPECT_EQ(tree.origin(other), leaf);
      EXPECT_EQ(tree.depth(leaf), static_cast<uint32_t>(depth));
      EXPECT_EQ(tree.depth(other), static_cast<uint32_t>(depth));
      for (const auto& [p, number] : before) {
        const uint32_t now = tree.find(p, {0, 0, 1});
        if (number / kEighths != leaf) {
          EXPECT_EQ(now, number);
          continue;
        }
        const uint32_t half = number % kEighths / (kEighths / 2);
        EXPECT_EQ(now / kEighths, half == keeper ? leaf : other);
        // What was the second bit of the eighth is its first now.
        EXPECT_EQ(now % kEighths / 2, number % kEighths % 4) << depth;
      }
    }
  }
}

TEST(SpatialTree, TakesPointsOutsideAndNone) {
  SpatialTree tree = makeTree();
  for (int i = 0; i < 30; ++i)
    tree.split(tree.find({9, 9, 9}, {0, 0, 1}) / kEighths, 0), tree.finish();
  for (const float x : {-1e30f, 1e30f, 0.0f}) {
    EXPECT_LT(tree.find({x, -x, x}, {0, 0, 1}) / kEighths, tree.leaves());
  }
  // A box without volume, and one of a single point.
  for (const float size : {1.0f, 0.0f}) {
    const SpatialTree flat(std::pmr::get_default_resource(), {0, 0, 0}, {size, 0, 0});
    EXPECT_LT(flat.find({0, 0, 0}, {0, 1, 0}) / kEighths, flat.leaves());
  }
}

}  // namespace
}  // namespace awd
