// SPDX-License-Identifier: Apache-2.0
#include "density/axis.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "basis/bernstein.h"

namespace awd {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Newton's method for integral(t) = target, kept within a shrinking bracket. `total` is the
/// integral up to 1.
template <class Integral, class Density>
double newton(double t, double target, double total, Integral&& integral, Density&& density) {
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double miss = integral(t) - target;
    if (std::abs(miss) <= 4.0 * kEpsilon * total) break;
    (miss > 0.0 ? high : low) = t;
    double next = t - miss / density(t);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= kEpsilon * t) break;
    t = next;
  }
  return t;
}

}  // namespace

double invertQuadraticCdf(double b0, double b1, double b2, double u) {
  const double total = (b0 + b1 + b2) * (1.0 / 3.0);
  const double target = u * total;
  const double c1 = b1 - b0;
  const double c2 = (b2 - b1) - c1;
  const double third = c2 * (1.0 / 3.0);
  const auto integral = [=](double t) { return t * (b0 + t * (c1 + t * third)); };
  const auto density = [=](double t) { return b0 + t * (2.0 * c1 + t * c2); };
  // Two steps of Halley's method from the straight line between the ends, which leave rounding only
  // unless the density is much bent; then Newton's method takes over.
  const double start = b0 + b2 > 0.0 ? invertLinearCdf(b0, b2, u) : u;
  double t = start;
  for (int i = 0; i < 2; ++i) {
    const double miss = integral(t) - target;
    const double slope = density(t);
    t -= miss * slope / (slope * slope - miss * (c1 + t * c2));
  }
  if (!(t >= 0.0 && t <= 1.0)) t = start;
  return newton(t, target, total, integral, density);
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
