// SPDX-License-Identifier: Apache-2.0
// The normal matrix of every node of a tree as if it were a leaf: by the two-scale relation
// N = P N' a node's is the sum of P^T A' P over its halves.
#pragma once

#include "density/bases.h"
#include "density/statistics.h"
#include "density/tree_density.h"

namespace awd {

class TreeMatrices {
 public:
  /// Keeps references. Entries come out times 2^-exponent.
  TreeMatrices(const DensityBases& bases, const TreeDensity& density, const NormalSums& normal,
               int exponent);

  /// The matrix of a node, leaf size squared, rows one after another.
  void of(uint32_t node, Coefficients& out) const;

 private:
  void takeLeaf(uint32_t leaf, Coefficients& out) const;
  /// out += P^T A P for the half of a box that was split along an axis.
  void addHalf(const Coefficients& half, uint32_t axis, uint32_t which, Coefficients& out) const;

  const DensityBases& bases_;
  const std::pmr::vector<TreeNode>& nodes_;
  const NormalSums& normal_;
  const Shape& shape_;
  const std::size_t size_;
  const int exponent_;
};

}  // namespace awd
