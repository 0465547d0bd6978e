// SPDX-License-Identifier: Apache-2.0
#include "density/tree_index.h"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

namespace awd {
namespace {

/// A tree of random splits, deeper towards the origin.
Tree randomTree(uint32_t dimensions, int splits, unsigned seed) {
  Tree tree(std::pmr::get_default_resource(), dimensions);
  std::mt19937 random(seed);
  const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  uint32_t node = 0;
  for (int i = 0; i < splits; ++i) {
    while (!tree.nodes()[node].leaf()) node = tree.nodes()[node].child + (below(4) == 0);
    tree.split(node, below(dimensions));
    node = below(3) == 0 ? 0 : tree.nodes()[node].child;
  }
  tree.finish();
  return tree;
}

template <uint32_t D>
void compareOn(const Tree& tree, unsigned seed) {
  const TreeIndex index(tree);
  std::mt19937_64 random(seed);
  for (int i = 0; i < 20000; ++i) {
    double x[D], stepped[D], direct[D];
    for (double& t : x) {
      // Ends, points on edges of boxes, and any others, near the origin too.
      const uint64_t kind = random() % 8;
      const double any = std::generate_canonical<double, 53>(random);
      t = kind == 0   ? 0.0
          : kind == 1 ? 1.0
          : kind == 2 ? std::floor(any * 64.0) / 64.0
          : kind == 3 ? std::ldexp(any, -static_cast<int>(random() % 40))
                      : any;
    }
    std::memcpy(stepped, x, sizeof x);
    std::memcpy(direct, x, sizeof x);
    const TreeNode& want = tree.descend(stepped);
    const TreeNode& got = index.descend<D>(tree, direct);
    ASSERT_EQ(&got, &want);
    ASSERT_EQ(std::memcmp(direct, stepped, sizeof x), 0);
  }
}

TEST(TreeIndex, FindsTheLeafAndThePlaceThatSteppingDownFinds) {
  for (const int splits : {0, 1, 2, 7, 60, 900}) {
    compareOn<1>(randomTree(1, std::min(splits, 60), 1), 1);
    compareOn<2>(randomTree(2, splits, 2), 2);
    compareOn<6>(randomTree(6, splits, 3), 3);
  }
}

TEST(TreeIndex, TakesNoMoreCellsThanThereAreLeaves) {
  for (const int splits : {0, 5, 300}) {
    const Tree tree = randomTree(3, splits, 4);
    EXPECT_LE(TreeIndex(tree).bytes(), 12u * tree.leaves());
  }
}

}  // namespace
}  // namespace awd
