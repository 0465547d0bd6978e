// SPDX-License-Identifier: Apache-2.0
// The sums of a pass at every node of a tree: those of the leaves, and their unions upwards.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <vector>

#include "density/bases.h"
#include "density/statistics.h"
#include "density/tree_density.h"

namespace awd {

/// Plain sums over the samples in a box; all boxes of a tree in the same units.
struct BoxSums {
  double weight = 0.0, value = 0.0, square = 0.0;

  double mean() const { return weight > 0.0 ? value / weight : 0.0; }
  double meanSquare() const { return weight > 0.0 ? square / weight : 0.0; }
  double rms() const { return std::sqrt(meanSquare()); }
  /// rms - mean
  double spread() const { return std::max(rms() - mean(), 0.0); }
};

class TreeSums {
 public:
  TreeSums(const DensityBases& bases, const TreeDensity& density,
           const DensityStatistics& statistics);

  /// Samples in a node, by the density's tree.
  double count(uint32_t node) const { return count_[node]; }
  BoxSums whole(uint32_t node) const { return box(node, dimensions_); }
  /// Its lower half along an axis.
  BoxSums lower(uint32_t node, uint32_t axis) const { return box(node, axis); }
  /// S1, S0 and n of the functions of the node as if it were a leaf: arrays of leaf size.
  const double* values(uint32_t node) const { return &values_[node * size_]; }
  const double* weights(uint32_t node) const { return &weights_[node * size_]; }
  const double* counts(uint32_t node) const { return &counts_[node * size_]; }
  /// Powers of two that were taken out of values and weights.
  int valueExponent() const { return valueExponent_; }
  int weightExponent() const { return weightExponent_; }

 private:
  BoxSums box(uint32_t node, uint32_t which) const {
    return boxes_[std::size_t{node} * (dimensions_ + 1) + which];
  }
  void takeLeaf(uint32_t node, uint32_t leaf, const DensityStatistics& statistics);
  void uniteChildren(const DensityBases& bases, uint32_t node, const TreeNode& shape,
                     const Shape& leafShape);

  uint32_t dimensions_;
  std::size_t size_;
  int valueExponent_, weightExponent_;  ///< powers of two taken out
  std::pmr::vector<double> values_, weights_, counts_;
  std::pmr::vector<double> count_;
  std::pmr::vector<BoxSums> boxes_;
};

}  // namespace awd
