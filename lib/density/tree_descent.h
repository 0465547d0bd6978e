// SPDX-License-Identifier: Apache-2.0
// Drawing a leaf of a tree: uniforms descend it by the masses of the halves, and what is left of
// them is uniform within the leaf.
#pragma once

#include <memory_resource>
#include <vector>

#include "density/block.h"
#include "density/tensor.h"
#include "density/tree.h"

namespace awd {

/// A block of points on their way into leaves.
template <std::size_t N>
struct BlockDescent {
  double u[kMaxDimensions][N];  ///< uniforms within the boxes
  uint32_t leaf[N];
};

/// A side of a leaf's box.
struct LeafSide {
  double lower, size;
};

class TreeDescent {
 public:
  /// masses: of the nodes of a tree.
  TreeDescent(const Tree& tree, const Coefficients& masses);

  /// The leaves for the uniforms of a block.
  template <std::size_t N>
  void descend(std::size_t count, BlockDescent<N>& block) const;

  /// The sides of a leaf's box, one for each axis.
  const LeafSide* sides(uint32_t leaf) const { return &sides_[std::size_t{leaf} * dimensions_]; }

  std::size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + sides_.capacity() * sizeof(LeafSide);
  }

 private:
  /// A half of a node's box: what uniforms of the upper half are above and those of the lower below
  /// is the lower one's share of the mass. Uniforms go on less `before`, times `scale`.
  struct Half {
    double before, scale;
  };
  /// All that a step needs in one place in memory, and without a branch for either half.
  struct Node {
    Half halves[2];
    TreeNode node;
  };
  /// The half that sample i goes into.
  template <std::size_t N>
  uint32_t step(uint32_t node, std::size_t i, BlockDescent<N>& block) const;

  uint32_t dimensions_;
  std::pmr::vector<Node> nodes_;
  std::pmr::vector<LeafSide> sides_;
};

template <std::size_t N>
uint32_t TreeDescent::step(uint32_t node, std::size_t i, BlockDescent<N>& block) const {
  constexpr double belowOne = 1.0 - 0x1p-53;
  const Node& from = nodes_[node];
  double& u = block.u[from.node.axis][i];
  const bool upper = u >= from.halves[1].before;
  const Half& half = from.halves[upper];
  u = std::min((u - half.before) * half.scale, belowOne);
  return from.node.child + upper;
}

template <std::size_t N>
void TreeDescent::descend(std::size_t count, BlockDescent<N>& block) const {
  uint32_t nodes[N] = {0};
  if constexpr (N == 1) {
    while (!nodes_[nodes[0]].node.leaf()) nodes[0] = step(nodes[0], 0, block);
  } else {
    // One step of all samples after the other. Those at a leaf drop out of the list, without a
    // branch that nobody could predict.
    uint32_t going[N];
    for (uint32_t i = 0; i < count; ++i) going[i] = i;
    std::size_t left = nodes_[0].node.leaf() ? 0 : count;
    while (left > 0) {
      std::size_t kept = 0;
      for (std::size_t j = 0; j < left; ++j) {
        const uint32_t i = going[j];
        nodes[i] = step(nodes[i], i, block);
        going[kept] = i;
        kept += !nodes_[nodes[i]].node.leaf();
      }
      left = kept;
    }
  }
  forEachSample<N>(count, [&](std::size_t i) { block.leaf[i] = nodes_[nodes[i]].node.child; });
}

}  // namespace awd
