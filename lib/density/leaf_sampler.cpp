// SPDX-License-Identifier: Apache-2.0
#include "density/leaf_sampler.h"

#include <algorithm>

#include "density/blended_row.h"

namespace awd {

namespace {

/// Whether coefficients are Bernstein coefficients of one polynomial.
bool isBernstein(const BasisLevel& level) {
  if (level.cells != 1 || level.alive != level.order) return false;
  for (uint32_t k = 0; k < level.alive; ++k) {
    if (level.functions[k] != k) return false;
    for (uint32_t o = 0; o < level.order; ++o) {
      if (level.pieces[k * level.order + o] != (k == o ? 1.0 : 0.0)) return false;
    }
  }
  return true;
}

/// Draws from the density on [0,1] of coefficients c, none negative, of a level of few cells.
double drawAlong(const BasisLevel& level, const double* c, double uniform) {
  double b[AWD_BASIS_MAX_ORDER];
  const auto massOf = [&](uint32_t cell) {
    std::fill(b, b + level.order, 0.0);
    double mass = 0.0;
    for (uint32_t k = 0; k < level.alive; ++k) {
      const std::size_t row = std::size_t{cell} * level.alive + k;
      const double* piece = &level.pieces[row * level.order];
      for (uint32_t o = 0; o < level.order; ++o) b[o] += c[level.functions[row]] * piece[o];
    }
    for (uint32_t o = 0; o < level.order; ++o) mass += b[o];
    return mass;
  };
  uint32_t cell = 0;
  double before = 0.0;
  double mass = massOf(0);
  double target = uniform * mass;
  if (level.cells > 1) {
    double total = mass;
    for (uint32_t i = 1; i < level.cells; ++i) total += massOf(i);
    target = uniform * total;
    mass = massOf(0);
    while (cell + 1 < level.cells && !(before + mass > target)) {
      before += mass;
      mass = massOf(++cell);
    }
    // uniform * total was rounded up to total: back to a cell of any mass.
    while (!(mass > 0.0) && cell > 0) {
      mass = massOf(--cell);
      before -= mass;
    }
  }
  const double t = mass > 0.0 ? std::clamp((target - before) / mass, 0.0, 1.0) : 0.5;
  return clampIntoCell<double>(level, cell,
                               (cell + invertPolynomialCdf(b, level.order, t)) / level.cells);
}

}  // namespace

LeafSampler::LeafSampler(const BasisLevel* const* levels, const Shape& shape) : shape_(shape) {
  std::copy(levels, levels + shape.dimensions, levels_);
  for (uint32_t a = 0; a < shape.dimensions; ++a) bernstein_[a] = isBernstein(*levels[a]);
  for (uint32_t a = 0; a + 1 < shape.dimensions; ++a) marginalSize_ += shape.product(0, a + 1);
}

void LeafSampler::marginals(const double* coefficients, double* out) const {
  // The last axis is summed out first: its marginal is the last of `out`.
  const double* from = coefficients;
  double* end = out + marginalSize_;
  for (uint32_t a = shape_.dimensions; a-- > 1;) {
    const std::size_t rows = shape_.product(0, a);
    const uint32_t n = shape_.count[a];
    double* to = end - rows;
    for (std::size_t row = 0; row < rows; ++row) {
      double sum = 0.0;
      for (uint32_t j = 0; j < n; ++j) sum += from[row * n + j] * levels_[a]->weights[j];
      to[row] = sum;
    }
    from = end = to;
  }
}

template <uint32_t D>
void LeafSampler::sample(const double* coefficients, const double* marginals,
                         const double* uniforms, double* t) const {
  BlendedRow rows[2][mostRows(D)];
  std::size_t count = 1;
  rows[0][0] = {0, 1.0};
  for (uint32_t a = 0; a < D; ++a) {
    const BasisLevel& level = *levels_[a];
    const double* from = a + 1 < D ? marginals : coefficients;
    // The density along this axis, given the coordinates before.
    double given[kMostLeafCoefficients];
    for (uint32_t j = 0; j < level.count; ++j) {
      double sum = 0.0;
      for (std::size_t r = 0; r < count; ++r) {
        sum += rows[a % 2][r].value * from[rows[a % 2][r].index * level.count + j];
      }
      given[j] = sum;
    }
    t[a] = bernstein_[a]
               ? std::min(invertPolynomialCdf(given, level.order, uniforms[a]), 1.0 - 0x1p-53)
               : drawAlong(level, given, uniforms[a]);
    if (a + 1 == D) break;
    AxisValues at;
    evaluateAxis(level, t[a], at);
    count = blend(rows[a % 2], count, at, level.count, rows[(a + 1) % 2]);
    marginals += shape_.product(0, a + 1);
  }
}

template void LeafSampler::sample<1>(const double*, const double*, const double*, double*) const;
template void LeafSampler::sample<2>(const double*, const double*, const double*, double*) const;
template void LeafSampler::sample<3>(const double*, const double*, const double*, double*) const;
template void LeafSampler::sample<4>(const double*, const double*, const double*, double*) const;
template void LeafSampler::sample<5>(const double*, const double*, const double*, double*) const;
template void LeafSampler::sample<6>(const double*, const double*, const double*, double*) const;

}  // namespace awd
