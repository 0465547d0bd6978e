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

/// The order of all axes, if as many functions are alive on every cell and it is worth code of its
/// own; else 0.
inline uint32_t commonOrder(const BasisLevel* const* levels, uint32_t dimensions) {
  const uint32_t order = levels[0]->order;
  for (uint32_t a = 0; a < dimensions; ++a) {
    if (levels[a]->order != order || levels[a]->alive != order) return 0;
  }
  return order <= 3 ? order : 0;
}

/// Calls body(std::integral_constant<uint32_t, order>) for what commonOrder() may be.
template <class Body>
decltype(auto) withOrder(uint32_t order, Body&& body) {
  switch (order) {
    case 1:
      return body(std::integral_constant<uint32_t, 1>{});
    case 2:
      return body(std::integral_constant<uint32_t, 2>{});
    case 3:
      return body(std::integral_constant<uint32_t, 3>{});
    default:
      return body(std::integral_constant<uint32_t, 0>{});
  }
}

/// More rows than this are not worth unrolling.
constexpr std::size_t kMostUnrolledRows = 9;

/// Whether the rows of coefficients along the last of D axes, of functions of some order alive on
/// the others, are few enough.
constexpr bool unrolls(uint32_t dimensions, uint32_t order) {
  std::size_t rows = 1;
  for (uint32_t a = 1; a < dimensions; ++a) rows *= order;
  return order > 0 && rows <= kMostUnrolledRows;
}

/// N_j(x_a) for all j alive, on each axis a. order: commonOrder(), or 0 for any.
template <uint32_t D, uint32_t order = 0>
inline void evaluatePoint(const BasisLevel* const* levels, const double* x, AxisValues* at) {
  for (uint32_t a = 0; a < D; ++a) {
    if constexpr (order > 0) {
      const uint32_t cell = cellOf(*levels[a], x[a]);
      evaluateCell<order, order>(*levels[a], cell, x[a] * levels[a]->cells - cell, at[a]);
    } else {
      evaluateAxis(*levels[a], x[a], at[a]);
    }
  }
}

/// Adds to given[k] the coefficients of the functions k alive on the last axis, each row of them
/// times the product of the values of its functions on the other axes.
template <uint32_t D, uint32_t alive>
inline void blendLastAxis(const double* coefficients, const std::size_t* strides,
                          const AxisValues* at, double product, double* given) {
  const uint32_t count = alive > 0 ? alive : at->count;
  for (uint32_t i = 0; i < count; ++i) {
    const double* row = coefficients + at->function[i] * strides[0];
    if constexpr (D == 1) {
      given[i] += product * *row;
    } else {
      blendLastAxis<D - 1, alive>(row, strides + 1, at + 1, product * at->value[i], given);
    }
  }
}

/// sum_j c_j N_j at a point; strides are those of the coefficients. alive: functions alive on every
/// axis, or 0 to look it up. The last axis is summed last: what drawing along it has blended
/// already gives the same bits.
template <uint32_t D, uint32_t alive = 0>
inline double contract(const double* coefficients, const std::size_t* strides,
                       const AxisValues* at) {
  double given[alive > 0 ? alive : AWD_BASIS_MAX_ORDER] = {0.0};
  blendLastAxis<D, alive>(coefficients, strides, at, 1.0, given);
  const AxisValues& last = at[D - 1];
  double sum = last.value[0] * given[0];
  const uint32_t count = alive > 0 ? alive : last.count;
  for (uint32_t k = 1; k < count; ++k) sum += last.value[k] * given[k];
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
