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

/// A coordinate along an axis from the blend of R rows, or of rowCount if R is 0. Rows are those of
/// the functions alive at the coordinates before.
template <std::size_t R>
double draw(const BasisLevel& level, const double* prefix, const double* marginal,
            const BlendedRow* rows, std::size_t rowCount, double uniform) {
  const std::size_t count = R == 0 ? rowCount : R;
  const auto massUpTo = [&](uint32_t cell) {
    double mass = 0.0;
    for (std::size_t r = 0; r < count; ++r) {
      mass += rows[r].value * prefix[rows[r].index * level.cells + cell];
    }
    return mass;
  };
  const double total = massUpTo(level.cells - 1);
  const double target = uniform * total;
  // The first cell up to whose end there is more mass than the target, without branches.
  uint32_t cell = 0;
  for (uint32_t span = level.cells; span > 1;) {
    const uint32_t half = span / 2;
    cell += massUpTo(cell + half - 1) <= target ? half : 0;
    span -= half;
  }
  double upTo = massUpTo(cell);
  double before = cell > 0 ? massUpTo(cell - 1) : 0.0;
  while (upTo <= before && cell > 0) {
    // uniform * total was rounded up to total: back to a cell of any mass.
    upTo = before;
    before = --cell > 0 ? massUpTo(cell - 1) : 0.0;
  }
  double t = std::clamp((target - before) / (upTo - before), 0.0, 1.0);
  if (level.order > 1) {
    double b[AWD_BASIS_MAX_ORDER] = {0.0};
    const std::size_t first = std::size_t{cell} * level.alive;
    for (uint32_t k = 0; k < level.alive; ++k) {
      double c = 0.0;
      for (std::size_t r = 0; r < count; ++r) {
        c += rows[r].value * marginal[rows[r].index * level.count + level.functions[first + k]];
      }
      const double* piece = &level.pieces[(first + k) * level.order];
      for (uint32_t o = 0; o < level.order; ++o) b[o] += c * piece[o];
    }
    t = invertPolynomialCdf(b, level.order, t);
  }
  return clampIntoCell<double>(level, cell, (cell + t) / level.cells);
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

template <uint32_t D>
void InverseCdf::sample(const Coefficients& coefficients, const double* uniforms, double* x,
                        AxisValues* at) const {
  BlendedRow rows[2][mostRows(D)];
  std::size_t count = 1;
  rows[0][0] = {0, 1.0};
  for (uint32_t a = 0; a < D; ++a) {
    const BasisLevel& level = *levels_[a];
    const BlendedRow* present = rows[a % 2];
    const double* marginal = a + 1 < D ? marginals_[a].data() : coefficients.data();
    const double* prefix = prefixes_[a].data();
    switch (count) {
      case 1:
        x[a] = draw<1>(level, prefix, marginal, present, count, uniforms[a]);
        break;
      case 2:
        x[a] = draw<2>(level, prefix, marginal, present, count, uniforms[a]);
        break;
      case 3:
        x[a] = draw<3>(level, prefix, marginal, present, count, uniforms[a]);
        break;
      default:
        x[a] = draw<0>(level, prefix, marginal, present, count, uniforms[a]);
        break;
    }
    evaluateAxis(level, x[a], at[a]);
    if (a + 1 < D) count = blend(present, count, at[a], level.count, rows[(a + 1) % 2]);
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
