// SPDX-License-Identifier: Apache-2.0
// Polynomials on one cell in Bernstein form: sum_k b_k C(order-1, k) t^k (1-t)^(order-1-k).
#pragma once

#include <cstdint>

#include "awd/basis.h"

namespace awd {

constexpr uint32_t kMaxOrder = AWD_BASIS_MAX_ORDER;

/// Value at t in [0,1], by de Casteljau: no cancellation, exact at both ends.
double bernsteinValue(const double* b, uint32_t order, double t);

/// Integral over [0,t].
double bernsteinIntegral(const double* b, uint32_t order, double t);

/// int_0^1 of the product of two polynomials of one order.
double bernsteinProductIntegral(const double* a, const double* b, uint32_t order);

/// Finds the coefficients of a polynomial from its values at `order` points inside the cell.
class BernsteinFit {
 public:
  explicit BernsteinFit(uint32_t order);

  /// Chebyshev's points rounded to multiples of 1/64: nearly as well conditioned, and with dyadic
  /// cells both the points and what a spline returns there are exact.
  double node(uint32_t i) const { return nodes_[i]; }
  void solve(const double* values, double* b) const;
  /// What the rounding of a value of magnitude 1 may do to a coefficient.
  double rounding() const { return rounding_; }

 private:
  uint32_t order_;
  double nodes_[kMaxOrder];
  long double inverse_[kMaxOrder][kMaxOrder];
  double rounding_;
};

}  // namespace awd
