// SPDX-License-Identifier: Apache-2.0
// A tree of boxes: the unit cube, halved along one axis at a time. Leaves are numbered from 0 in
// the order in which the tree is walked, lower half first.
#pragma once

#include <memory_resource>
#include <vector>

#include "density/shape.h"

namespace awd {

struct TreeNode {
  static constexpr uint32_t kLeaf = 0xffffffffu;
  uint32_t axis = kLeaf;  ///< along which the box is halved
  uint32_t child = 0;     ///< its lower half, the upper one follows; of a leaf, its number
  bool leaf() const { return axis == kLeaf; }
};

/// A box: lower[a] to lower[a] + 2^-depth[a].
struct TreeBox {
  double lower[kMaxDimensions] = {};
  uint32_t depth[kMaxDimensions] = {};

  double size(uint32_t axis) const;
  double volume(uint32_t dimensions) const;
  /// The lower (0) or upper (1) half.
  TreeBox half(uint32_t axis, uint32_t which) const;
};

class Tree {
 public:
  /// One leaf.
  Tree(std::pmr::memory_resource* memory, uint32_t dimensions);
  /// Halves boxes round and round the axes until each has been halved depth[a] times.
  Tree(std::pmr::memory_resource* memory, uint32_t dimensions, const uint32_t* depth);

  /// Of nodes that make a tree, whose leaves it numbers.
  Tree(uint32_t dimensions, std::pmr::vector<TreeNode> nodes);
  /// In the same memory, where a vector copied by default would be in that of the process.
  Tree(const Tree& other)
      : dimensions_(other.dimensions_),
        leaves_(other.leaves_),
        nodes_(other.nodes_, other.nodes_.get_allocator()) {}
  Tree& operator=(const Tree& other) = default;
  Tree(Tree&& other) = default;
  Tree& operator=(Tree&& other) = default;
  ~Tree() = default;

  uint32_t dimensions() const { return dimensions_; }
  uint32_t leaves() const { return leaves_; }
  /// Children come after their parent.
  const std::pmr::vector<TreeNode>& nodes() const { return nodes_; }

  /// Halves a leaf; numbers of leaves are wrong until finish().
  void split(uint32_t node, uint32_t axis);
  /// Numbers the leaves.
  void finish();

  /// Calls visit(node, box) for every node, parents before children, lower halves first.
  template <class Visit>
  void walk(Visit&& visit) const {
    walkFrom(0, TreeBox{}, visit);
  }
  /// The leaf below a node that holds x, a place within that node's box in [0,1]^d; x becomes the
  /// place within the leaf's box. Every step is exact.
  const TreeNode& descend(double* x, uint32_t from = 0) const {
    const TreeNode* node = &nodes_[from];
    while (!node->leaf()) {
      const double twice = 2.0 * x[node->axis];
      const bool upper = twice >= 1.0;
      x[node->axis] = twice - (upper ? 1.0 : 0.0);
      node = &nodes_[node->child + upper];
    }
    return *node;
  }
  std::size_t bytes() const { return nodes_.capacity() * sizeof(TreeNode); }

 private:
  template <class Visit>
  void walkFrom(uint32_t node, const TreeBox& box, Visit& visit) const {
    visit(node, box);
    const TreeNode present = nodes_[node];
    if (present.leaf()) return;
    walkFrom(present.child, box.half(present.axis, 0), visit);
    walkFrom(present.child + 1, box.half(present.axis, 1), visit);
  }

  uint32_t dimensions_;
  uint32_t leaves_ = 1;
  std::pmr::vector<TreeNode> nodes_;
};

}  // namespace awd
