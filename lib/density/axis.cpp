// SPDX-License-Identifier: Apache-2.0
#include "density/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace awd {

double bernstein(const double* coefficients, uint32_t order, double t) {
  double row[AWD_BASIS_MAX_ORDER + 1];
  std::copy(coefficients, coefficients + order, row);
  for (uint32_t remaining = order; remaining > 1; --remaining) {
    for (uint32_t k = 0; k + 1 < remaining; ++k) row[k] += t * (row[k + 1] - row[k]);
  }
  return row[0];
}

template <class Real>
Real clampIntoCell(const BasisLevel& level, uint32_t cell, double x) {
  auto rounded = static_cast<Real>(x);
  if (rounded >= Real{1}) rounded = std::nextafter(Real{1}, Real{0});
  while (cellOf(level, rounded) > cell) rounded = std::nextafter(rounded, Real{0});
  while (cellOf(level, rounded) < cell) rounded = std::nextafter(rounded, Real{1});
  return rounded;
}
template float clampIntoCell<float>(const BasisLevel&, uint32_t, double);
template double clampIntoCell<double>(const BasisLevel&, uint32_t, double);

void evaluateAxis(const BasisLevel& level, double x, AxisValues& values) {
  const uint32_t cell = cellOf(level, x);
  const double t = x * level.cells - cell;
  const uint32_t* functions = &level.functions[std::size_t{cell} * level.alive];
  const double* pieces = &level.pieces[std::size_t{cell} * level.alive * level.order];
  values.count = level.alive;
  for (uint32_t a = 0; a < level.alive; ++a, pieces += level.order) {
    values.function[a] = functions[a];
    values.value[a] = level.order == 1 ? pieces[0] : bernstein(pieces, level.order, t);
  }
}

double invertPolynomialCdf(const double* coefficients, uint32_t order, double u) {
  if (order == 1) return u;
  const double b0 = coefficients[0];
  const double b1 = coefficients[1];
  if (order == 2) {
    const double divisor = b0 + std::sqrt((1.0 - u) * b0 * b0 + u * b1 * b1);
    return divisor > 0.0 ? std::min(u * (b0 + b1) / divisor, 1.0) : 0.0;
  }

  // F in Bernstein form of one degree more: F_k = (b_0 + .. + b_{k-1}) / order.
  double integral[AWD_BASIS_MAX_ORDER + 1] = {0.0};
  for (uint32_t k = 0; k < order; ++k) integral[k + 1] = integral[k] + coefficients[k] / order;
  const double total = integral[order];
  const double target = u * total;
  double low = 0.0;
  double high = 1.0;
  double t = u;
  constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 100; ++i) {
    const double miss = bernstein(integral, order + 1, t) - target;
    if (std::abs(miss) <= 4.0 * kEpsilon * total) break;
    (miss > 0.0 ? high : low) = t;
    const double slope = bernstein(coefficients, order, t);
    double next = t - miss / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= kEpsilon * t) break;
    t = next;
  }
  return t;
}

template <class Real>
Real sampleComponent(const BasisLevel& level, uint32_t j, double uniform) {
  const BasisLevel::Piece* begin = &level.componentPieces[level.componentBegin[j]];
  const BasisLevel::Piece* end = level.componentPieces.data() + level.componentBegin[j + 1];
  const BasisLevel::Piece* piece = begin;
  while (piece + 1 < end && uniform >= piece->cumulative) ++piece;
  const double before = piece == begin ? 0.0 : piece[-1].cumulative;
  const double within = std::clamp((uniform - before) / (piece->cumulative - before), 0.0, 1.0);
  const std::size_t row = std::size_t{piece->cell} * level.alive + piece->row;
  const double t = invertPolynomialCdf(&level.pieces[row * level.order], level.order, within);
  return clampIntoCell<Real>(level, piece->cell, (piece->cell + t) / level.cells);
}

template float sampleComponent<float>(const BasisLevel&, uint32_t, double);
template double sampleComponent<double>(const BasisLevel&, uint32_t, double);

}  // namespace awd
