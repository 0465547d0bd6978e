// SPDX-License-Identifier: Apache-2.0
#include "density/tree_matrices.h"

#include "density/refit.h"

namespace awd {

TreeMatrices::TreeMatrices(const DensityBases& bases, const TreeDensity& density,
                           const NormalSums& normal, int exponent)
    : bases_(bases),
      nodes_(density.tree().nodes()),
      normal_(normal),
      shape_(density.leafShape()),
      size_(shape_.size()),
      exponent_(exponent) {}

void TreeMatrices::of(uint32_t node, Coefficients& out) const {
  out.assign(size_ * size_, 0.0);
  if (nodes_[node].leaf()) {
    takeLeaf(nodes_[node].child, out);
    return;
  }
  Coefficients half(out.get_allocator());
  for (uint32_t which = 0; which < 2; ++which) {
    of(nodes_[node].child + which, half);
    addHalf(half, nodes_[node].axis, which, out);
  }
}

void TreeMatrices::takeLeaf(uint32_t leaf, Coefficients& out) const {
  const std::size_t first = leaf * normal_.pattern->size();
  normal_.pattern->forEachPair([&](std::size_t entry, std::size_t j, std::size_t k, bool both) {
    const double value = normal_.products[first + entry].plain(exponent_);
    out[j * size_ + k] = value;
    if (both) out[k * size_ + j] = value;
  });
}

void TreeMatrices::addHalf(const Coefficients& half, uint32_t axis, uint32_t which,
                           Coefficients& out) const {
  const BasisLevel& level = bases_.family(axis).level(0);
  const uint32_t n = level.count;
  const std::size_t stride = shape_.stride(axis);
  /// Calls visit(j, i, value): N_j of the box has that share of N'_i of the half.
  const auto forEachShare = [&](auto&& visit) {
    shape_.forEachFibre(axis, [&](std::size_t outer, std::size_t inner) {
      const std::size_t fibre = outer * n * stride + inner;
      for (uint32_t j = 0; j < n; ++j) {
        for (uint32_t i = level.twoScaleBegin[j]; i < level.twoScaleBegin[j + 1]; ++i) {
          const BasisLevel::TwoScale& h = level.twoScale[i];
          if (h.fine / n != which) continue;
          visit(fibre + j * stride, fibre + h.fine % n * stride, h.value);
        }
      }
    });
  };
  Coefficients rows(size_ * size_, 0.0, out.get_allocator());  // P^T A'
  forEachShare([&](std::size_t j, std::size_t i, double share) {
    for (std::size_t k = 0; k < size_; ++k) rows[j * size_ + k] += share * half[i * size_ + k];
  });
  forEachShare([&](std::size_t k, std::size_t i, double share) {
    for (std::size_t j = 0; j < size_; ++j) out[j * size_ + k] += share * rows[j * size_ + i];
  });
}

}  // namespace awd
