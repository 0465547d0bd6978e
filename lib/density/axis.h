// SPDX-License-Identifier: Apache-2.0
// One axis of a tensor product: evaluating the functions alive at x, and drawing x from one
// function, from the compiled tables of a level. No plugin is called.
#pragma once

#include <cstdint>

#include "basis/family.h"

namespace awd {

/// The functions alive at one x: function[a] has the value value[a] there.
struct AxisValues {
  uint32_t count;
  uint32_t function[AWD_BASIS_MAX_ORDER];
  double value[AWD_BASIS_MAX_ORDER];
};

/// The cell that x in [0,1] lies in; x = 1 belongs to the last.
inline uint32_t cellOf(const BasisLevel& level, double x) {
  const auto cell = static_cast<uint32_t>(x * level.cells);
  return cell < level.cells ? cell : level.cells - 1;
}

/// Value at t in [0,1] of the polynomial with `order` Bernstein coefficients (de Casteljau).
double bernstein(const double* coefficients, uint32_t order, double t);

/// N_j(x) for all j alive at x in [0,1].
void evaluateAxis(const BasisLevel& level, double x, AxisValues& values);

/// x as a float or double that lies in `cell`, which rounding may have made it leave, and below 1.
template <class Real>
Real clampIntoCell(const BasisLevel& level, uint32_t cell, double x);

/// x ~ p_j = N_j / w_j from one uniform in [0,1), as a float or double that lies in the cell that
/// was drawn (eq. 3; the piece by its mass, then the inverse CDF of the polynomial in it).
template <class Real>
Real sampleComponent(const BasisLevel& level, uint32_t j, double uniform);

/// Solves F(t) = u F(1) for t in [0,1], F the integral of a non-negative polynomial with F(1) > 0
/// given by its Bernstein coefficients. Closed forms up to degree 1, then Newton's method kept
/// within a shrinking bracket: Cardano's formula gives NaN on flat cells.
double invertPolynomialCdf(const double* coefficients, uint32_t order, double u);

}  // namespace awd
