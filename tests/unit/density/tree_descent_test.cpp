// SPDX-License-Identifier: Apache-2.0
#include "density/tree_descent.h"

#include <gtest/gtest.h>

#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

/// A tree of 50 leaves of several depths, some of no mass.
struct Case {
  explicit Case(uint32_t dimensions, Uniforms& random) : tree(memory(), dimensions) {
    while (tree.nodes().size() < 99) {
      const auto node = static_cast<uint32_t>(random() * double(tree.nodes().size()));
      if (tree.nodes()[node].leaf()) tree.split(node, static_cast<uint32_t>(random() * dimensions));
    }
    tree.finish();
    masses.assign(tree.nodes().size(), 0.0);
    for (std::size_t i = masses.size(); i-- > 0;) {
      const TreeNode& node = tree.nodes()[i];
      masses[i] = !node.leaf()     ? masses[node.child] + masses[node.child + 1]
                  : random() < 0.2 ? 0.0
                                   : random();
    }
  }
  Tree tree;
  Coefficients masses;
};

TEST(TreeDescent, KnowsTheBoxes) {
  Uniforms random(1);
  const Case c(3, random);
  const TreeDescent descent(c.tree, c.masses);
  c.tree.walk([&](uint32_t i, const TreeBox& box) {
    if (!c.tree.nodes()[i].leaf()) return;
    const LeafSide* sides = descent.sides(c.tree.nodes()[i].child);
    for (uint32_t a = 0; a < 3; ++a) {
      EXPECT_EQ(sides[a].lower, box.lower[a]);
      EXPECT_EQ(sides[a].size, box.size(a));
    }
  });
}

/// Along one axis the uniforms below that of a leaf are the mass to the left of it.
TEST(TreeDescent, UniformsGoWhereTheMassIs) {
  Uniforms random(2);
  const Case c(1, random);
  const TreeDescent descent(c.tree, c.masses);
  std::vector<double> mass(c.tree.leaves());
  for (std::size_t i = 0; i < c.masses.size(); ++i) {
    if (c.tree.nodes()[i].leaf()) mass[c.tree.nodes()[i].child] = c.masses[i] / c.masses[0];
  }
  for (int i = 0; i < 2000; ++i) {
    BlockDescent<1> one;
    const double u = i == 0 ? 0.0 : i == 1 ? 1.0 - 0x1p-53 : random();
    one.u[0][0] = u;
    descent.descend(1, one);
    double before = 0.0;
    for (uint32_t leaf = 0; leaf < one.leaf[0]; ++leaf) before += mass[leaf];
    ASSERT_GT(mass[one.leaf[0]], 0.0);
    ASSERT_TRUE(one.u[0][0] >= 0.0 && one.u[0][0] < 1.0);
    ASSERT_NEAR(before + one.u[0][0] * mass[one.leaf[0]], u, 1e-13);
  }
}

TEST(TreeDescent, ABlockGetsTheBitsOfEachAlone) {
  Uniforms random(3);
  for (const uint32_t d : {1u, 2u, 6u}) {
    const Case c(d, random);
    const TreeDescent descent(c.tree, c.masses);
    for (const std::size_t count : {std::size_t{2}, std::size_t{31}, kBlock}) {
      BlockDescent<kBlock> block;
      std::vector<BlockDescent<1>> each(count);
      for (std::size_t i = 0; i < count; ++i) {
        for (uint32_t a = 0; a < d; ++a) block.u[a][i] = each[i].u[a][0] = random();
        descent.descend(1, each[i]);
      }
      descent.descend(count, block);
      for (std::size_t i = 0; i < count; ++i) {
        ASSERT_EQ(block.leaf[i], each[i].leaf[0]);
        for (uint32_t a = 0; a < d; ++a) ASSERT_EQ(block.u[a][i], each[i].u[a][0]);
      }
    }
  }
}

TEST(TreeDescent, OneLeafTakesAll) {
  const Tree tree(memory(), 2);
  const TreeDescent descent(tree, {1.0});
  BlockDescent<kBlock> block;
  block.u[0][0] = 0.25;
  block.u[1][0] = 0.75;
  descent.descend(1, block);
  EXPECT_EQ(block.leaf[0], 0u);
  EXPECT_EQ(block.u[0][0], 0.25);
  EXPECT_EQ(block.u[1][0], 0.75);
}

}  // namespace
}  // namespace awd
