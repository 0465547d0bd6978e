// SPDX-License-Identifier: Apache-2.0
#include "density/axis.h"

#include <algorithm>
#include <cmath>

#include "basis/bernstein.h"

namespace awd {

double fitIntoCell(const BasisLevel& level, uint32_t cell, double x) {
  const double inside = clampIntoCell<double>(level, cell, x);
  const bool begins = level.order > 1 && !(inside * level.cells - cell > 0.0);
  return begins ? std::nextafter(inside, 1.0) : inside;
}

double invertPolynomialCdf(const double* b, uint32_t order, double u) {
  if (order == 1) return u;
  u = std::max(u, kLeastUniform);
  if (order == 2) return invertLinearCdf(b[0], b[1], u);
  if (order == 3) return invertQuadraticCdf(b[0], b[1], b[2], u);
  // F in Bernstein form of one degree more: F_k = (b_0 + .. + b_{k-1}) / order.
  double integral[AWD_BASIS_MAX_ORDER + 1] = {0.0};
  for (uint32_t k = 0; k < order; ++k) integral[k + 1] = integral[k] + b[k] / order;
  const double total = integral[order];
  return newton(
      u, u * total, total, [&](double t) { return bernsteinValue(integral, order + 1, t); },
      [&](double t) { return bernsteinValue(b, order, t); });
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
