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

/// A coordinate along an axis from the blend of rows, those of the functions alive at the
/// coordinates before, and its cell. R: how many rows, or 0 to take rowCount. O: the order, if as
/// many functions are alive on every cell, or 0 to look both up.
template <std::size_t R, uint32_t O>
double draw(const BasisLevel& level, const double* prefix, const double* marginal,
            const BlendedRow* rows, std::size_t rowCount, double uniform, uint32_t& cell) {
  const std::size_t count = R > 0 ? R : rowCount;
  const uint32_t order = O > 0 ? O : level.order;
  const uint32_t alive = O > 0 ? O : level.alive;
  const uint32_t cells = level.cells;
  const auto massUpTo = [=](uint32_t end) {
    double mass = rows[0].value * prefix[rows[0].index * cells + end];
    for (std::size_t r = 1; r < count; ++r) {
      mass += rows[r].value * prefix[rows[r].index * cells + end];
    }
    return mass;
  };
  const double target = uniform * massUpTo(cells - 1);
  // The first cell up to whose end there is more mass than the target, without branches.
  cell = 0;
  for (uint32_t span = cells; span > 1;) {
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
  double t = std::min(std::max((target - before) / (upTo - before), 0.0), 1.0);
  if (order > 1) {
    double b[O > 0 ? O : AWD_BASIS_MAX_ORDER] = {0.0};
    const std::size_t first = std::size_t{cell} * alive;
    for (uint32_t k = 0; k < alive; ++k) {
      double c = 0.0;
      for (std::size_t r = 0; r < count; ++r) {
        c += rows[r].value * marginal[rows[r].index * level.count + level.functions[first + k]];
      }
      const double* piece = &level.pieces[(first + k) * order];
      for (uint32_t o = 0; o < order; ++o) b[o] += c * piece[o];
    }
    const double u = std::max(t, kLeastUniform);
    if constexpr (O == 2) {
      t = invertLinearCdf(b[0], b[1], u);
    } else if constexpr (O == 3) {
      t = invertQuadraticCdf(b[0], b[1], b[2], u);
    } else {
      t = invertPolynomialCdf(b, order, u);
    }
  }
  return clampIntoCell<double>(level, cell, (cell + t) / cells);
}

/// Rows of the last of D axes, if that many are worth unrolling; else 0.
constexpr std::size_t unrolledRows(uint32_t axis, uint32_t alive) {
  std::size_t rows = 1;
  for (uint32_t a = 0; a < axis; ++a) rows *= alive;
  return alive > 0 && rows <= 9 ? rows : 0;
}

}  // namespace

InverseCdf::InverseCdf(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                       const Shape& shape, const Coefficients& coefficients)
    : shape_(shape), marginals_(memory), prefixes_(memory) {
  const uint32_t d = shape.dimensions;
  std::copy(levels, levels + d, levels_);
  order_ = levels[0]->order;
  for (uint32_t a = 0; a < d; ++a) {
    if (levels[a]->order != order_ || levels[a]->alive != order_) order_ = 0;
  }
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

template <uint32_t D, uint32_t O, uint32_t A>
void InverseCdf::sampleFrom(const Coefficients& coefficients, const double* uniforms,
                            const BlendedRow* rows, std::size_t count, double* x,
                            AxisValues* at) const {
  const BasisLevel& level = *levels_[A];
  const double* marginal = A + 1 < D ? marginals_[A].data() : coefficients.data();
  const double* prefix = prefixes_[A].data();
  uint32_t cell;
  x[A] = draw<unrolledRows(A, O), O>(level, prefix, marginal, rows, count, uniforms[A], cell);
  if constexpr (O > 0) {
    evaluateCell<O, O>(level, cell, x[A] * level.cells - cell, at[A]);
  } else {
    evaluateAxis(level, x[A], at[A]);
  }
  if constexpr (A + 1 < D) {
    BlendedRow next[mostRows(A + 2)];
    next[0] = {0, 0.0};  // or the compiler fears that no function is alive
    const std::size_t filled = blend(rows, count, at[A], level.count, next);
    sampleFrom<D, O, A + 1>(coefficients, uniforms, next, filled, x, at);
  }
}

template <uint32_t D>
void InverseCdf::sampleAny(const Coefficients& coefficients, const double* uniforms, double* x,
                           AxisValues* at) const {
  const BlendedRow row = {0, 1.0};
  sampleFrom<D, 0, 0>(coefficients, uniforms, &row, 1, x, at);
}

template <uint32_t D>
void InverseCdf::sample(const Coefficients& coefficients, const double* uniforms, double* x,
                        AxisValues* at) const {
  const BlendedRow row = {0, 1.0};
  switch (order_) {
    case 1:
      return sampleFrom<D, 1, 0>(coefficients, uniforms, &row, 1, x, at);
    case 2:
      return sampleFrom<D, 2, 0>(coefficients, uniforms, &row, 1, x, at);
    case 3:
      return sampleFrom<D, 3, 0>(coefficients, uniforms, &row, 1, x, at);
    default:
      return sampleFrom<D, 0, 0>(coefficients, uniforms, &row, 1, x, at);
  }
}

#define AWD_INSTANTIATE(D)                                                                         \
  template void InverseCdf::sample<D>(const Coefficients&, const double*, double*, AxisValues*)    \
      const;                                                                                       \
  template void InverseCdf::sampleAny<D>(const Coefficients&, const double*, double*, AxisValues*) \
      const;
AWD_INSTANTIATE(1)
AWD_INSTANTIATE(2)
AWD_INSTANTIATE(3)
AWD_INSTANTIATE(4)
AWD_INSTANTIATE(5)
AWD_INSTANTIATE(6)
#undef AWD_INSTANTIATE

std::size_t InverseCdf::bytes() const {
  std::size_t doubles = 0;
  for (const Coefficients& table : marginals_) doubles += table.capacity();
  for (const Coefficients& table : prefixes_) doubles += table.capacity();
  return doubles * sizeof(double);
}

}  // namespace awd
