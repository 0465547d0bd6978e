// SPDX-License-Identifier: Apache-2.0
// A point of the unit cube as a tensor product sees it: the functions alive at it on every axis.
// The number of axes is a template parameter, so that loops over them unroll.
#pragma once

#include <type_traits>

#include "density/axis.h"
#include "density/shape.h"

namespace awd {

/// Calls body(std::integral_constant<uint32_t, dimensions>) for 1 to kMaxDimensions.
template <class Body>
decltype(auto) withDimensions(uint32_t dimensions, Body&& body) {
  switch (dimensions) {
    case 1:
      return body(std::integral_constant<uint32_t, 1>{});
    case 2:
      return body(std::integral_constant<uint32_t, 2>{});
    case 3:
      return body(std::integral_constant<uint32_t, 3>{});
    case 4:
      return body(std::integral_constant<uint32_t, 4>{});
    case 5:
      return body(std::integral_constant<uint32_t, 5>{});
    default:
      return body(std::integral_constant<uint32_t, 6>{});
  }
}

/// N_j(x_a) for all j alive, on each axis a.
template <uint32_t D>
inline void evaluatePoint(const BasisLevel* const* levels, const double* x, AxisValues* at) {
  for (uint32_t a = 0; a < D; ++a) evaluateAxis(*levels[a], x[a], at[a]);
}

/// sum_j c_j N_j at a point; strides are those of the coefficients. alive: functions alive on every
/// axis, or 0 to look it up.
template <uint32_t D, uint32_t alive = 0>
inline double contract(const double* coefficients, const std::size_t* strides,
                       const AxisValues* at) {
  double sum = 0.0;
  const uint32_t count = alive > 0 ? alive : at->count;
  for (uint32_t i = 0; i < count; ++i) {
    const double* row = coefficients + at->function[i] * strides[0];
    if constexpr (D == 1) {
      sum += at->value[i] * *row;
    } else {
      sum += at->value[i] * contract<D - 1, alive>(row, strides + 1, at + 1);
    }
  }
  return sum;
}

/// Calls visit(j, N_j) for every function alive at a point, j its index in the coefficients.
template <uint32_t D, class Visit>
inline void forEachAlive(const std::size_t* strides, const AxisValues* at, Visit&& visit,
                         std::size_t index = 0, double product = 1.0) {
  for (uint32_t i = 0; i < at->count; ++i) {
    const std::size_t next = index + at->function[i] * strides[0];
    const double value = product * at->value[i];
    if constexpr (D == 1) {
      if (value > 0.0) visit(next, value);
    } else {
      forEachAlive<D - 1>(strides + 1, at + 1, visit, next, value);
    }
  }
}

}  // namespace awd
