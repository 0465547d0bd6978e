// SPDX-License-Identifier: Apache-2.0
// Rows of a tensor product's coefficients, one for each combination of functions alive at the
// coordinates drawn so far, and what each counts for: the product of these functions' values.
#pragma once

#include <algorithm>
#include <cstddef>

#include "density/axis.h"

namespace awd {

struct BlendedRow {
  std::size_t index;
  double value;
};

/// More rows than this would be too many for one point: such a tensor product is refused.
constexpr std::size_t kMostRows = 1024;

/// Rows that the last of D axes may have.
constexpr std::size_t mostRows(uint32_t dimensions) {
  return dimensions <= 1
             ? 1
             : std::min(std::size_t{AWD_BASIS_MAX_ORDER} * mostRows(dimensions - 1), kMostRows);
}

/// The rows of the next axis, once a coordinate along one of `functions` functions is known.
inline std::size_t blend(const BlendedRow* present, std::size_t count, const AxisValues& at,
                         std::size_t functions, BlendedRow* next) {
  std::size_t filled = 0;
  for (std::size_t r = 0; r < count; ++r) {
    for (uint32_t k = 0; k < at.count; ++k) {
      next[filled++] = {present[r].index * functions + at.function[k],
                        present[r].value * at.value[k]};
    }
  }
  return filled;
}

}  // namespace awd
