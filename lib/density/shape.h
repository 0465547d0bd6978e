// SPDX-License-Identifier: Apache-2.0
// The shape of a d-dimensional array, last axis fastest, and walking along one of its axes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "awd/density.h"

namespace awd {

constexpr uint32_t kMaxDimensions = AWD_MAX_DIMENSIONS;

struct Shape {
  uint32_t dimensions = 0;
  std::array<uint32_t, kMaxDimensions> count{};

  /// Elements of all axes from `first` to before `last`.
  std::size_t product(uint32_t first, uint32_t last) const {
    std::size_t size = 1;
    for (uint32_t a = first; a < std::min(last, kMaxDimensions); ++a) size *= count[a];
    return size;
  }
  std::size_t size() const { return product(0, dimensions); }
  /// Distance between neighbours along an axis.
  std::size_t stride(uint32_t axis) const { return product(axis + 1, dimensions); }
  bool operator==(const Shape& other) const {
    return dimensions == other.dimensions && count == other.count;
  }

  /// Calls visit(outer, inner) for each fibre along `axis`: its element i is at
  /// (outer * count[axis] + i) * stride(axis) + inner.
  template <class Visit>
  void forEachFibre(uint32_t axis, Visit&& visit) const {
    const std::size_t outers = product(0, axis);
    const std::size_t inners = stride(axis);
    for (std::size_t outer = 0; outer < outers; ++outer) {
      for (std::size_t inner = 0; inner < inners; ++inner) visit(outer, inner);
    }
  }
};

}  // namespace awd
