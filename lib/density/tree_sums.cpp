// SPDX-License-Identifier: Apache-2.0
#include "density/tree_sums.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace awd {

namespace {

/// The exponent of the largest of some sums.
class LargestExponent {
 public:
  void look(const BinnedSum& sum) {
    if (!sum.zero()) exponent_ = std::max(exponent_, sum.scaled().exponent);
  }
  int get() const { return exponent_ == std::numeric_limits<int>::min() ? 0 : exponent_; }

 private:
  int exponent_ = std::numeric_limits<int>::min();
};

}  // namespace

TreeSums::TreeSums(const DensityBases& bases, const TreeDensity& density,
                   const DensityStatistics& statistics)
    : dimensions_(density.leafShape().dimensions),
      size_(density.leafShape().size()),
      values_(statistics.tallies.get_allocator()),
      weights_(values_.get_allocator()),
      counts_(values_.get_allocator()),
      count_(values_.get_allocator()),
      boxes_(values_.get_allocator()) {
  LargestExponent value, weight;
  for (const BoxTally& tally : statistics.boxes) {
    value.look(tally.value);
    weight.look(tally.weight);
  }
  valueExponent_ = value.get();
  weightExponent_ = weight.get();

  const auto& nodes = density.tree().nodes();
  values_.resize(nodes.size() * size_);
  weights_.resize(nodes.size() * size_);
  counts_.resize(nodes.size() * size_);
  count_.resize(nodes.size());
  boxes_.resize(nodes.size() * (dimensions_ + 1));
  for (auto node = static_cast<uint32_t>(nodes.size()); node-- > 0;) {
    if (nodes[node].leaf()) {
      takeLeaf(node, nodes[node].child, statistics);
    } else {
      uniteChildren(bases, node, nodes[node], density.leafShape());
    }
  }
}

void TreeSums::takeLeaf(uint32_t node, uint32_t leaf, const DensityStatistics& statistics) {
  for (std::size_t j = 0; j < size_; ++j) {
    const Tally& tally = statistics.tallies[leaf * size_ + j];
    values_[node * size_ + j] = tally.value.plain(valueExponent_);
    weights_[node * size_ + j] = tally.weight.plain(weightExponent_);
    counts_[node * size_ + j] = tally.count();
    count_[node] += tally.count();
  }
  for (uint32_t i = 0; i <= dimensions_; ++i) {
    const BoxTally& tally = statistics.boxes[leaf * (dimensions_ + 1) + i];
    BoxSums& sums = boxes_[std::size_t{node} * (dimensions_ + 1) + i];
    sums.weight = tally.weight.plain(weightExponent_);
    sums.value = tally.value.plain(valueExponent_);
    // So that meanSquare has the units of mean^2.
    sums.square = tally.square.plain(2 * valueExponent_ - weightExponent_);
  }
}

void TreeSums::uniteChildren(const DensityBases& bases, uint32_t node, const TreeNode& shape,
                             const Shape& leafShape) {
  // A function of the node is, by the two-scale relation along the axis of the split, a combination
  // of those of its halves, and so are sums over it.
  const BasisLevel& level = bases.family(shape.axis).level(0);
  const uint32_t n = level.count;
  const std::size_t stride = leafShape.stride(shape.axis);
  leafShape.forEachFibre(shape.axis, [&](std::size_t outer, std::size_t inner) {
    const std::size_t fibre = outer * n * stride + inner;
    for (uint32_t j = 0; j < n; ++j) {
      const std::size_t to = node * size_ + fibre + j * stride;
      for (uint32_t i = level.twoScaleBegin[j]; i < level.twoScaleBegin[j + 1]; ++i) {
        const BasisLevel::TwoScale& h = level.twoScale[i];
        const std::size_t from = (shape.child + h.fine / n) * size_ + fibre + h.fine % n * stride;
        values_[to] += h.value * values_[from];
        weights_[to] += h.value * weights_[from];
        counts_[to] += h.value * counts_[from];
      }
    }
  });
  count_[node] = count_[shape.child] + count_[shape.child + 1];
  for (uint32_t i = 0; i <= dimensions_; ++i) {
    BoxSums& to = boxes_[std::size_t{node} * (dimensions_ + 1) + i];
    for (uint32_t half = 0; half < 2; ++half) {
      // The lower half along the axis of the split is the lower child.
      if (i == shape.axis && half == 1) continue;
      const BoxSums from = box(shape.child + half, i == shape.axis ? dimensions_ : i);
      to.weight += from.weight;
      to.value += from.value;
      to.square += from.square;
    }
  }
}

}  // namespace awd
