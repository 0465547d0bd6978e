// SPDX-License-Identifier: Apache-2.0
#include "density/leaf_sampler.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace awd {

namespace {

/// Draws from the density on [0,1] of the coefficients `marginal` of one level.
double drawAlong(const BasisLevel& level, const double* marginal, double uniform) {
  const auto pieceOf = [&](uint32_t cell, double* b) {
    std::fill(b, b + level.order, 0.0);
    for (uint32_t k = 0; k < level.alive; ++k) {
      const std::size_t row = std::size_t{cell} * level.alive + k;
      for (uint32_t o = 0; o < level.order; ++o) {
        b[o] += marginal[level.functions[row]] * level.pieces[row * level.order + o];
      }
    }
    return std::accumulate(b, b + level.order, 0.0);
  };
  double b[AWD_BASIS_MAX_ORDER];
  double total = 0.0;
  for (uint32_t cell = 0; cell < level.cells; ++cell) total += pieceOf(cell, b);
  const double target = uniform * total;
  double before = 0.0;
  uint32_t cell = 0;
  double mass = pieceOf(cell, b);
  while (cell + 1 < level.cells && !(before + mass > target)) {
    before += mass;
    mass = pieceOf(++cell, b);
  }
  const double t = std::clamp((target - before) / mass, 0.0, 1.0);
  return clampIntoCell<double>(level, cell,
                               (cell + invertPolynomialCdf(b, level.order, t)) / level.cells);
}

}  // namespace

LeafSampler::LeafSampler(const BasisLevel* const* levels, const Shape& shape)
    : levels_(levels), shape_(shape) {}

void LeafSampler::sample(const double* coefficients, const double* uniforms, double* t) const {
  const uint32_t d = shape_.dimensions;
  if (shape_.size() == 1 && levels_[0]->order == 1) {
    std::copy(uniforms, uniforms + d, t);
    return;
  }
  // The density of the axes still to be drawn, given the ones that have been.
  double given[kMostCoefficients];
  std::size_t size = shape_.size();
  std::copy(coefficients, coefficients + size, given);
  for (uint32_t a = 0; a < d; ++a) {
    const BasisLevel& level = *levels_[a];
    const std::size_t inner = size / level.count;
    // The marginal sums the inner axes by their weights.
    double marginal[kMostCoefficients];
    for (uint32_t j = 0; j < level.count; ++j) {
      double sum = 0.0;
      for (std::size_t i = 0; i < inner; ++i) {
        double weight = 1.0;
        std::size_t rest = i;
        for (uint32_t b = d; b-- > a + 1; rest /= shape_.count[b]) {
          weight *= levels_[b]->weights[rest % shape_.count[b]];
        }
        sum += given[j * inner + i] * weight;
      }
      marginal[j] = sum;
    }
    t[a] = drawAlong(level, marginal, uniforms[a]);
    AxisValues at;
    evaluateAxis(level, t[a], at);
    for (std::size_t i = 0; i < inner; ++i) {
      double sum = 0.0;
      for (uint32_t k = 0; k < at.count; ++k) {
        sum += at.value[k] * given[at.function[k] * inner + i];
      }
      marginal[i] = sum;
    }
    std::copy(marginal, marginal + inner, given);
    size = inner;
  }
}

}  // namespace awd
