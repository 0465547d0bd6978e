// SPDX-License-Identifier: Apache-2.0
#include "density/tree.h"

#include <algorithm>
#include <cmath>

namespace awd {

double TreeBox::size(uint32_t axis) const {
  return std::ldexp(1.0, -static_cast<int>(depth[axis]));
}

double TreeBox::volume(uint32_t dimensions) const {
  int halvings = 0;
  for (uint32_t a = 0; a < dimensions; ++a) halvings += static_cast<int>(depth[a]);
  return std::ldexp(1.0, -halvings);
}

TreeBox TreeBox::half(uint32_t axis, uint32_t which) const {
  TreeBox out = *this;
  ++out.depth[axis];
  if (which) out.lower[axis] += out.size(axis);
  return out;
}

Tree::Tree(std::pmr::memory_resource* memory, uint32_t dimensions)
    : dimensions_(dimensions), nodes_(1, TreeNode{}, memory) {}

Tree::Tree(std::pmr::memory_resource* memory, uint32_t dimensions, const uint32_t* depth)
    : Tree(memory, dimensions) {
  const uint32_t most = *std::max_element(depth, depth + dimensions);
  for (uint32_t round = 0; round < most; ++round) {
    for (uint32_t a = 0; a < dimensions; ++a) {
      if (depth[a] <= round) continue;
      const auto size = static_cast<uint32_t>(nodes_.size());
      for (uint32_t node = 0; node < size; ++node) {
        if (nodes_[node].leaf()) split(node, a);
      }
    }
  }
  finish();
}

Tree::Tree(uint32_t dimensions, std::pmr::vector<TreeNode> nodes)
    : dimensions_(dimensions), nodes_(std::move(nodes)) {
  finish();
}

void Tree::split(uint32_t node, uint32_t axis) {
  const auto child = static_cast<uint32_t>(nodes_.size());
  nodes_.resize(nodes_.size() + 2);
  nodes_[node] = {axis, child};
}

void Tree::finish() {
  leaves_ = 0;
  walk([this](uint32_t node, const TreeBox&) {
    if (nodes_[node].leaf()) nodes_[node].child = leaves_++;
  });
}

}  // namespace awd
