// SPDX-License-Identifier: Apache-2.0
#include "density/inverse_cdf.h"

#include <algorithm>
#include <cmath>

namespace awd {

namespace {

/// int over each cell of N_j, for every function alive on it: masses[cell * alive + a].
Coefficients cellMasses(std::pmr::memory_resource* memory, const BasisLevel& level) {
  Coefficients masses(level.functions.size(), 0.0, memory);
  for (std::size_t row = 0; row < masses.size(); ++row) {
    const double* piece = &level.pieces[row * level.order];
    for (uint32_t k = 0; k < level.order; ++k) masses[row] += piece[k];
    masses[row] /= static_cast<double>(level.order) * level.cells;
  }
  return masses;
}

constexpr std::size_t power(std::size_t base, uint32_t exponent) {
  return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

}  // namespace

std::size_t InverseCdf::rowsOf(const BasisLevel* const* levels, uint32_t dimensions) {
  std::size_t rows = 1;
  for (uint32_t a = 0; a + 1 < dimensions; ++a) rows *= levels[a]->alive;
  return rows;
}

InverseCdf::InverseCdf(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                       const Shape& shape, const Coefficients& coefficients)
    : shape_(shape), marginals_(memory), prefixes_(memory) {
  const uint32_t d = shape.dimensions;
  std::copy(levels, levels + d, levels_);
  marginals_.resize(d - 1);
  prefixes_.resize(d);
  const Coefficients* marginal = &coefficients;
  for (uint32_t a = d; a-- > 0;) {
    const BasisLevel& level = *levels[a];
    const Coefficients masses = cellMasses(memory, level);
    const std::size_t rows = shape.product(0, a);
    Coefficients& prefix = prefixes_[a];
    prefix.resize(rows * level.cells);
    for (std::size_t row = 0; row < rows; ++row) {
      const double* c = &(*marginal)[row * level.count];
      double sum = 0.0;
      std::size_t i = 0;
      for (uint32_t cell = 0; cell < level.cells; ++cell) {
        for (uint32_t k = 0; k < level.alive; ++k, ++i) sum += c[level.functions[i]] * masses[i];
        prefix[row * level.cells + cell] = sum;
      }
    }
    if (a == 0) break;
    // The marginal of the axes before: its coefficients are the masses of the rows.
    marginals_[a - 1].resize(rows);
    for (std::size_t row = 0; row < rows; ++row) {
      marginals_[a - 1][row] = prefix[(row + 1) * level.cells - 1];
    }
    marginal = &marginals_[a - 1];
  }
}

double InverseCdf::draw(uint32_t axis, const double* marginal, const Row* rows,
                        std::size_t rowCount, double uniform) const {
  const BasisLevel& level = *levels_[axis];
  const double* prefix = prefixes_[axis].data();
  const auto massUpTo = [&](uint32_t cell) {
    double mass = 0.0;
    for (std::size_t r = 0; r < rowCount; ++r) {
      mass += rows[r].value * prefix[rows[r].index * level.cells + cell];
    }
    return mass;
  };
  const double total = massUpTo(level.cells - 1);
  const double target = uniform * total;
  // The first cell up to whose end there is more mass than the target.
  uint32_t cell = 0;
  double upTo = 0.0;
  for (uint32_t step = level.cells; step > 0;) {
    const uint32_t half = step / 2;
    const double mass = massUpTo(cell + half);
    if (mass > target) {
      upTo = mass;
      step = half;
    } else {
      cell += half + 1;
      step -= half + 1;
    }
  }
  if (cell == level.cells) {  // uniform * total was rounded up to total: the last cell of any mass
    do --cell;
    while (cell > 0 && massUpTo(cell - 1) >= total);
    upTo = total;
  }
  const double before = cell > 0 ? massUpTo(cell - 1) : 0.0;
  double t = std::clamp((target - before) / (upTo - before), 0.0, 1.0);
  if (level.order > 1) {
    double b[AWD_BASIS_MAX_ORDER] = {0.0};
    const std::size_t first = std::size_t{cell} * level.alive;
    for (uint32_t k = 0; k < level.alive; ++k) {
      double c = 0.0;
      for (std::size_t r = 0; r < rowCount; ++r) {
        c += rows[r].value * marginal[rows[r].index * level.count + level.functions[first + k]];
      }
      const double* piece = &level.pieces[(first + k) * level.order];
      for (uint32_t o = 0; o < level.order; ++o) b[o] += c * piece[o];
    }
    t = invertPolynomialCdf(b, level.order, t);
  }
  return clampIntoCell<double>(level, cell, (cell + t) / level.cells);
}

template <uint32_t D>
void InverseCdf::sample(const Coefficients& coefficients, const double* uniforms, double* x,
                        AxisValues* at) const {
  Row rows[2][std::min(power(AWD_BASIS_MAX_ORDER, D - 1), kMostRows)];
  std::size_t count = 1;
  rows[0][0] = {0, 1.0};
  for (uint32_t a = 0; a < D; ++a) {
    const Row* present = rows[a % 2];
    const Coefficients& marginal = a + 1 < D ? marginals_[a] : coefficients;
    x[a] = draw(a, marginal.data(), present, count, uniforms[a]);
    evaluateAxis(*levels_[a], x[a], at[a]);
    if (a + 1 == D) break;
    Row* next = rows[(a + 1) % 2];
    std::size_t filled = 0;
    for (std::size_t r = 0; r < count; ++r) {
      for (uint32_t k = 0; k < at[a].count; ++k) {
        if (at[a].value[k] <= 0.0) continue;
        next[filled++] = {present[r].index * levels_[a]->count + at[a].function[k],
                          present[r].value * at[a].value[k]};
      }
    }
    count = filled;
  }
}

template void InverseCdf::sample<1>(const Coefficients&, const double*, double*, AxisValues*) const;
template void InverseCdf::sample<2>(const Coefficients&, const double*, double*, AxisValues*) const;
template void InverseCdf::sample<3>(const Coefficients&, const double*, double*, AxisValues*) const;
template void InverseCdf::sample<4>(const Coefficients&, const double*, double*, AxisValues*) const;
template void InverseCdf::sample<5>(const Coefficients&, const double*, double*, AxisValues*) const;
template void InverseCdf::sample<6>(const Coefficients&, const double*, double*, AxisValues*) const;

std::size_t InverseCdf::bytes() const {
  std::size_t doubles = 0;
  for (const Coefficients& table : marginals_) doubles += table.capacity();
  for (const Coefficients& table : prefixes_) doubles += table.capacity();
  return doubles * sizeof(double);
}

}  // namespace awd
