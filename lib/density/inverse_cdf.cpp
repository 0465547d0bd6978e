// SPDX-License-Identifier: Apache-2.0
#include "density/inverse_cdf.h"

#include <algorithm>
#include <cmath>

#include "density/cell_search.h"

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

/// What is left of a uniform within the cell that was drawn: 0 to 1. A uniform of 0 stands for
/// those up to 2^-53, to which it is added if it matters.
inline double uniformWithin(uint32_t order, double target, double before, double upTo) {
  return (target - before) / (upTo - before) + (order == 1 ? 0.0 : kLeastUniform);
}

/// A coordinate along an axis from the blend of rows, those of the functions alive at the
/// coordinates before, and its cell. O: the order, if as many functions are alive on every cell, or
/// 0 to look both up. The block below does the same.
template <uint32_t O>
double draw(const BasisLevel& level, const double* prefix, const double* marginal,
            const BlendedRow* rows, std::size_t count, double uniform, uint32_t& cell) {
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
  double target = uniform * massUpTo(cells - 1);
  cell = findCell(cells, powerBelow(cells), target, massUpTo);
  const double before = cell > 0 ? massUpTo(cell - 1) : 0.0;
  double t = uniformWithin(order, target, before, massUpTo(cell));
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
    t = invertPolynomialCdf(b, order, t);
  }
  const double x = (cell + t) * (1.0 / cells);
  return insideCell(order, x * cells - cell) ? x : fitIntoCell(level, cell, x);
}

/// Draws the cells of a block, and what is left of the uniforms; those of samples are `stride`
/// apart.
template <uint32_t O, std::size_t R, std::size_t N>
void findCells(const BasisLevel& level, const double* prefix, std::size_t count,
               const double* uniforms, std::size_t stride, const BlockRows<R, N>& rows,
               BlockAxis<O, N>& axis) {
  const uint32_t cells = level.cells;
  const uint32_t power = powerBelow(cells);
  double target[N], before[N], upTo[N];
  forEachSample<N>(count, [&](std::size_t i) {
    const double* row[R];
    double value[R];
    for (std::size_t r = 0; r < R; ++r) {
      row[r] = prefix + std::size_t{rows.index[r][i]} * cells;
      value[r] = rows.value[r][i];
    }
    const auto massUpTo = [&](uint32_t end) {
      double mass = value[0] * row[0][end];
      for (std::size_t r = 1; r < R; ++r) mass += value[r] * row[r][end];
      return mass;
    };
    target[i] = uniforms[i * stride] * massUpTo(cells - 1);
    const uint32_t cell = findCell(cells, power, target[i], massUpTo);
    axis.cell[i] = cell;
    upTo[i] = massUpTo(cell);
    before[i] = cell > 0 ? massUpTo(cell - 1) : 0.0;
  });
  forEachSample<N>(
      count, [&](std::size_t i) { axis.u[i] = uniformWithin(O, target[i], before[i], upTo[i]); });
}

/// The coefficients of the functions alive on these cells.
template <uint32_t O, std::size_t R, std::size_t N>
void blendCoefficients(const BasisLevel& level, const double* marginal, std::size_t count,
                       const BlockRows<R, N>& rows, BlockAxis<O, N>& axis) {
  const uint32_t* alive = level.functions.data();
  forEachSample<N>(count, [&](std::size_t i) {
    const uint32_t* functions = alive + std::size_t{axis.cell[i]} * O;
    const double* row[R];
    for (std::size_t r = 0; r < R; ++r) {
      row[r] = marginal + std::size_t{rows.index[r][i]} * level.count;
    }
    for (uint32_t k = 0; k < O; ++k) {
      double c = rows.value[0][i] * row[0][functions[k]];
      for (std::size_t r = 1; r < R; ++r) c += rows.value[r][i] * row[r][functions[k]];
      axis.given[k][i] = c;
    }
  });
}

/// Coordinates from places in cells, and these places again as the coordinates have them.
template <uint32_t O, std::size_t N>
void placeInCells(const BasisLevel& level, std::size_t count, BlockAxis<O, N>& axis, double* x,
                  std::size_t stride) {
  const double size = 1.0 / level.cells;
  const double cells = level.cells;
  double drawn[N];
  double outside = 0.0;
  forEachSample<N>(count, [&](std::size_t i) {
    const auto cell = static_cast<double>(static_cast<int32_t>(axis.cell[i]));
    drawn[i] = (cell + axis.t[i]) * size;
    axis.t[i] = drawn[i] * cells - cell;
    outside += insideCell(O, axis.t[i]) ? 0.0 : 1.0;
  });
  if (outside > 0.0) {
    forEachSample<N>(count, [&](std::size_t i) {
      if (insideCell(O, axis.t[i])) return;
      drawn[i] = fitIntoCell(level, axis.cell[i], drawn[i]);
      axis.t[i] = drawn[i] * cells - axis.cell[i];
    });
  }
  forEachSample<N>(count, [&](std::size_t i) { x[i * stride] = drawn[i]; });
}

}  // namespace

InverseCdf::InverseCdf(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                       const Shape& shape, const Coefficients& coefficients)
    : shape_(shape), order_(commonOrder(levels, shape.dimensions)), tables_(memory) {
  const uint32_t d = shape.dimensions;
  std::copy(levels, levels + d, levels_);
  std::size_t size = 0;
  for (uint32_t a = 0; a < d; ++a) {
    strides_[a] = shape.stride(a);
    bernstein_[a] = hasBernsteinPieces(*levels[a]);
    prefixBegin_[a] = size;
    size += shape.product(0, a) * levels[a]->cells;
    marginalBegin_[a] = size;
    if (a + 1 < d) size += shape.product(0, a + 1);
  }
  tables_.resize(size);
  const double* given = coefficients.data();
  for (uint32_t a = d; a-- > 0;) {
    const BasisLevel& level = *levels[a];
    const Coefficients masses = cellMasses(memory, level);
    const std::size_t rows = shape.product(0, a);
    double* prefixes = tables_.data() + prefixBegin_[a];
    for (std::size_t row = 0; row < rows; ++row) {
      const double* c = given + row * level.count;
      double sum = 0.0;
      std::size_t i = 0;
      for (uint32_t cell = 0; cell < level.cells; ++cell) {
        for (uint32_t k = 0; k < level.alive; ++k, ++i) sum += c[level.functions[i]] * masses[i];
        prefixes[row * level.cells + cell] = sum;
      }
    }
    if (a == 0) break;
    // The marginal of the axes before: its coefficients are the masses of the rows.
    double* marginals = tables_.data() + marginalBegin_[a - 1];
    for (std::size_t row = 0; row < rows; ++row) {
      marginals[row] = prefixes[(row + 1) * level.cells - 1];
    }
    given = marginals;
  }
}

template <uint32_t D, uint32_t O, uint32_t A>
void InverseCdf::sampleFrom(const Coefficients& coefficients, const double* uniforms,
                            const BlendedRow* rows, std::size_t count, double* x,
                            AxisValues* at) const {
  const BasisLevel& level = *levels_[A];
  const double* marginal = A + 1 < D ? marginalOf(A) : coefficients.data();
  uint32_t cell;
  x[A] = draw<O>(level, prefixOf(A), marginal, rows, count, uniforms[A], cell);
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

template <uint32_t O, std::size_t R, std::size_t N>
void InverseCdf::sampleBlock(uint32_t a, const Coefficients& coefficients, std::size_t count,
                             const double* uniforms, const BlockRows<R, N>& rows, double* points,
                             double* pdfs) const {
  const uint32_t d = shape_.dimensions;
  const BasisLevel& level = *levels_[a];
  const double* marginal = a + 1 < d ? marginalOf(a) : coefficients.data();
  BlockAxis<O, N> axis;
  findCells(level, prefixOf(a), count, uniforms + a, d, rows, axis);
  blendCoefficients(level, marginal, count, rows, axis);
  if (!bernstein_[a]) sumPieces(level, count, axis);
  invertBlock(count, bernstein_[a] ? axis.given : axis.bernstein, axis);
  placeInCells(level, count, axis, points + a, d);
  if (a + 1 == d) {
    if (!pdfs) return;
    evaluateBlock(level, bernstein_[a], count, axis);
    contractBlock(count, axis, pdfs);
  } else if constexpr (R * O <= kMostUnrolledRows) {
    evaluateBlock(level, bernstein_[a], count, axis);
    sampleBlock<O>(a + 1, coefficients, count, uniforms, blendBlock(level, count, axis, rows),
                   points, pdfs);
  }
}

template <uint32_t D>
void InverseCdf::sampleAny(const Coefficients& coefficients, const double* uniforms, double* x,
                           AxisValues* at) const {
  const BlendedRow row = {0, 1.0};
  sampleFrom<D, 0, 0>(coefficients, uniforms, &row, 1, x, at);
}

template <uint32_t D, uint32_t O>
void InverseCdf::sampleOfOrder(const Coefficients& coefficients, std::size_t count,
                               const double* uniforms, double* points, double* pdfs) const {
  if constexpr (unrolls(D, O)) {
    if (count == 1) {
      return sampleBlock<O>(0, coefficients, 1, uniforms, oneRow<1>(), points, pdfs);
    }
    const BlockRows<1, kBlock> rows = oneRow<kBlock>();
    for (std::size_t done = 0; done < count; done += kBlock) {
      sampleBlock<O>(0, coefficients, std::min(count - done, kBlock), uniforms + done * D, rows,
                     points + done * D, pdfs ? pdfs + done : nullptr);
    }
  } else {
    const BlendedRow row = {0, 1.0};
    AxisValues at[D];
    for (std::size_t i = 0; i < count; ++i) {
      sampleFrom<D, O, 0>(coefficients, uniforms + i * D, &row, 1, points + i * D, at);
      if (pdfs) pdfs[i] = contract<D, O>(coefficients.data(), strides_, at);
    }
  }
}

template <uint32_t D>
void InverseCdf::sample(const Coefficients& coefficients, std::size_t count, const double* uniforms,
                        double* points, double* pdfs) const {
  withOrder(order_, [&](auto order) {
    sampleOfOrder<D, order>(coefficients, count, uniforms, points, pdfs);
  });
}

#define AWD_INSTANTIATE(D)                                                                         \
  template void InverseCdf::sample<D>(const Coefficients&, std::size_t, const double*, double*,    \
                                      double*) const;                                              \
  template void InverseCdf::sampleAny<D>(const Coefficients&, const double*, double*, AxisValues*) \
      const;
AWD_INSTANTIATE(1)
AWD_INSTANTIATE(2)
AWD_INSTANTIATE(3)
AWD_INSTANTIATE(4)
AWD_INSTANTIATE(5)
AWD_INSTANTIATE(6)
#undef AWD_INSTANTIATE

std::size_t InverseCdf::bytes() const { return tables_.capacity() * sizeof(double); }

}  // namespace awd
