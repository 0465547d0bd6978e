// SPDX-License-Identifier: Apache-2.0
#include "density/tree_descent.h"

#include <limits>

namespace awd {

TreeDescent::TreeDescent(const Tree& tree, const Coefficients& masses)
    : dimensions_(tree.dimensions()),
      nodes_(tree.nodes().size(), Node{}, masses.get_allocator()),
      sides_(std::size_t{tree.leaves()} * dimensions_, LeafSide{}, masses.get_allocator()) {
  tree.walk([&](uint32_t i, const TreeBox& box) {
    if (!tree.nodes()[i].leaf()) return;
    LeafSide* sides = &sides_[std::size_t{tree.nodes()[i].child} * dimensions_];
    for (uint32_t a = 0; a < dimensions_; ++a) sides[a] = {box.lower[a], box.size(a)};
  });
  for (std::size_t i = 0; i < masses.size(); ++i) {
    Node& to = nodes_[i];
    to.node = tree.nodes()[i];
    if (to.node.leaf() || !(masses[i] > 0.0)) continue;
    double left = masses[to.node.child] / masses[i];
    if (left < std::numeric_limits<double>::min()) left = 0.0;  // 1 / left would be infinite
    to.halves[0] = {0.0, left > 0.0 ? 1.0 / left : 0.0};
    to.halves[1] = {left, left < 1.0 ? 1.0 / (1.0 - left) : 0.0};
  }
}

}  // namespace awd
