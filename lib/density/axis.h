// SPDX-License-Identifier: Apache-2.0
// One axis of a tensor product: evaluating the functions alive at x, and drawing x from one
// function, from the compiled tables of a level. No plugin is called.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "basis/family.h"
#include "density/parabola.h"

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

/// The Bernstein polynomials C(order-1, k) t^k (1-t)^(order-1-k) themselves.
template <uint32_t order>
inline void bernsteinPolynomials(double t, double* b) {
  const double s = 1.0 - t;
  b[0] = 1.0;
  for (uint32_t degree = 1; degree < order; ++degree) {
    double carried = 0.0;
    for (uint32_t k = 0; k < degree; ++k) {
      const double previous = b[k];
      b[k] = carried + s * previous;
      carried = t * previous;
    }
    b[degree] = carried;
  }
}

/// At the place t of a cell; alive: functions alive on every cell, or 0 to look it up.
template <uint32_t order, uint32_t alive = 0>
inline void evaluateCell(const BasisLevel& level, uint32_t cell, double t, AxisValues& values) {
  const uint32_t count = alive > 0 ? alive : level.alive;
  const std::size_t first = std::size_t{cell} * count;
  double b[order];
  bernsteinPolynomials<order>(t, b);
  const uint32_t* functions = &level.functions[first];
  const double* pieces = &level.pieces[first * order];
  values.count = count;
  for (uint32_t a = 0; a < count; ++a, pieces += order) {
    values.function[a] = functions[a];
    double value = pieces[0] * b[0];
    for (uint32_t k = 1; k < order; ++k) value += pieces[k] * b[k];
    values.value[a] = value;
  }
}

/// N_j(x) for all j alive at x in [0,1].
inline void evaluateAxis(const BasisLevel& level, double x, AxisValues& values) {
  const uint32_t cell = cellOf(level, x);
  const double t = x * level.cells - cell;
  switch (level.order) {
    case 1:
      return evaluateCell<1>(level, cell, t, values);
    case 2:
      return evaluateCell<2>(level, cell, t, values);
    case 3:
      return evaluateCell<3>(level, cell, t, values);
    case 4:
      return evaluateCell<4>(level, cell, t, values);
    case 5:
      return evaluateCell<5>(level, cell, t, values);
    case 6:
      return evaluateCell<6>(level, cell, t, values);
    case 7:
      return evaluateCell<7>(level, cell, t, values);
    default:
      return evaluateCell<8>(level, cell, t, values);
  }
}

/// Whether the functions alive on a cell, k = 0, 1, .., are its Bernstein polynomials k.
inline bool hasBernsteinPieces(const BasisLevel& level) {
  if (level.alive != level.order) return false;
  for (std::size_t row = 0; row < level.functions.size(); ++row) {
    for (uint32_t o = 0; o < level.order; ++o) {
      if (level.pieces[row * level.order + o] != (row % level.order == o ? 1.0 : 0.0)) return false;
    }
  }
  return true;
}

/// x as a float or double that lies in `cell`, which rounding may have made it leave, and below 1.
template <class Real>
inline Real clampIntoCell(const BasisLevel& level, uint32_t cell, double x) {
  auto rounded = static_cast<Real>(x);
  if (rounded >= Real{1}) rounded = std::nextafter(Real{1}, Real{0});
  while (cellOf(level, rounded) > cell) rounded = std::nextafter(rounded, Real{0});
  while (cellOf(level, rounded) < cell) rounded = std::nextafter(rounded, Real{1});
  return rounded;
}

/// Whether a place is one of a cell, not beyond it, nor, for polynomials that may be 0 there, at
/// its beginning. Without `&&`, which is a branch.
inline bool insideCell(uint32_t order, double t) {
  return (order > 1 ? t > 0.0 : t >= 0.0) & (t < 1.0);
}

/// x again if rounding has carried it out of a cell, so that its place there is insideCell().
double fitIntoCell(const BasisLevel& level, uint32_t cell, double x);

/// x ~ p_j = N_j / w_j from one uniform in [0,1), as a float or double that lies in the cell that
/// was drawn (eq. 3; the piece by its mass, then the inverse CDF of the polynomial in it).
template <class Real>
Real sampleComponent(const BasisLevel& level, uint32_t j, double uniform);

/// A uniform of 0 stands for those up to 2^-53; at t = 0 itself a polynomial may be 0.
constexpr double kLeastUniform = 0x1p-54;

/// The straight line through b0 at 0 and b1 at 1: u (b0 + b1) / (b0 + sqrt((1-u) b0^2 + u b1^2)),
/// without cancellation at any slope. Not both are 0. Of numbers whose squares are 0 as doubles it
/// may be 1, which is no zero of the density.
inline double invertLinearCdf(double b0, double b1, double u) {
  const double t = u * (b0 + b1) / (b0 + std::sqrt((1.0 - u) * b0 * b0 + u * b1 * b1));
  return t < 1.0 ? t : 1.0;
}

/// The parabola of these three Bernstein coefficients, not all 0.
inline double invertQuadraticCdf(double b0, double b1, double b2, double u) {
  const ParabolaCdf cdf(b0, b1, b2, u);
  const double guess = cdf.guess();
  return cdf.solvedBy(guess) ? guess : cdf.solve();
}

/// Solves F(t) = u F(1) for t in [0,1], F the integral of a non-negative polynomial with F(1) > 0
/// given by its Bernstein coefficients. Closed forms up to degree 1, then Newton's method kept
/// within a shrinking bracket: Cardano's formula gives NaN on flat cells.
double invertPolynomialCdf(const double* b, uint32_t order, double u);

}  // namespace awd
