// SPDX-License-Identifier: Apache-2.0
#include "density/leaf_sampler.h"

#include <algorithm>
#include <cmath>

#include "density/blended_row.h"

namespace awd {

namespace {

/// Whether function k is alive in row k alone: on its own cell, or of the only one.
bool isNumberedByRows(const BasisLevel& level) {
  for (std::size_t row = 0; row < level.functions.size(); ++row) {
    if (level.functions[row] != row) return false;
  }
  return true;
}

struct DrawnCell {
  uint32_t cell;
  double u;  ///< what is left of the uniform
};

/// Draws one of few cells.
template <class MassOf>
DrawnCell drawCell(uint32_t cells, double uniform, const MassOf& massOf) {
  if (cells == 1) return {0, uniform};
  double total = massOf(0);
  for (uint32_t i = 1; i < cells; ++i) total += massOf(i);
  const double target = uniform * total;
  uint32_t cell = 0;
  double before = 0.0;
  double upTo = 0.0;
  for (uint32_t i = 0; i + 1 < cells; ++i) {
    upTo += massOf(i);
    const bool beyond = upTo <= target;
    cell += beyond;
    before = beyond ? upTo : before;
  }
  double mass = massOf(cell);
  while (!(mass > 0.0) && cell > 0) {
    // uniform * total was rounded up to total: back to a cell of any mass.
    mass = massOf(--cell);
    before -= mass;
  }
  return {cell, std::min(std::max((target - before) / mass, 0.0), 1.0)};
}

/// x if it is in a cell of a leaf and not at the beginning of a polynomial; else the next one that
/// is.
double fitIntoLeaf(const BasisLevel& level, uint32_t cell, LeafSide side, double x) {
  const double end = side.lower + side.size;
  if (x >= end) x = std::nextafter(end, 0.0);
  while (cellOf(level, (x - side.lower) / side.size) > cell) x = std::nextafter(x, 0.0);
  while (cellOf(level, (x - side.lower) / side.size) < cell) x = std::nextafter(x, 1.0);
  const bool begins = level.order > 1 && !((x - side.lower) / side.size * level.cells - cell > 0.0);
  return begins ? std::nextafter(x, 1.0) : x;
}

/// Where a coordinate is in a cell of a leaf. The difference and the quotient are exact, as the
/// steps down the tree are, so that it is what pdf() sees.
inline double placeOf(const BasisLevel& level, uint32_t cell, LeafSide side, double x) {
  return (x - side.lower) / side.size * level.cells - cell;
}

struct Place {
  double x;
  double t;  ///< placeOf() it
};

/// The coordinate for a place in a cell of a leaf, and that place again as the coordinate has it.
inline Place placeInLeaf(const BasisLevel& level, uint32_t cell, LeafSide side, double t) {
  double x = side.lower + (cell + t) * (1.0 / level.cells) * side.size;
  if (!insideCell(level.order, placeOf(level, cell, side, x))) {
    x = fitIntoLeaf(level, cell, side, x);
  }
  return {x, placeOf(level, cell, side, x)};
}

}  // namespace

LeafSampler::LeafSampler(const BasisLevel* const* levels, const Shape& shape)
    : shape_(shape), leafSize_(shape.size()) {
  const uint32_t d = shape.dimensions;
  std::copy(levels, levels + d, levels_);
  bool bernstein = true;  // every axis
  for (uint32_t a = 0; a < d; ++a) {
    const bool plain = hasBernsteinPieces(*levels[a]) && isNumberedByRows(*levels[a]);
    bernstein_[a] = plain && levels[a]->cells == 1;
    bernstein = bernstein && bernstein_[a];
    boxes_ = boxes_ && plain && levels[a]->order == 1;
    marginalBegin_[a] = marginalSize_;
    if (a + 1 < d) marginalSize_ += shape.product(0, a + 1);
  }
  if (bernstein && unrolls(d, commonOrder(levels, d))) polynomials_ = commonOrder(levels, d);
}

void LeafSampler::marginals(const double* coefficients, double* out) const {
  // The last axis is summed out first.
  const double* from = coefficients;
  for (uint32_t a = shape_.dimensions; a-- > 1;) {
    const std::size_t rows = shape_.product(0, a);
    const uint32_t n = shape_.count[a];
    double* to = out + marginalBegin_[a - 1];
    for (std::size_t row = 0; row < rows; ++row) {
      double sum = 0.0;
      for (uint32_t j = 0; j < n; ++j) sum += from[row * n + j] * levels_[a]->weights[j];
      to[row] = sum;
    }
    from = to;
  }
}

template <uint32_t D>
void LeafSampler::sampleAny(const Leaves& leaves, uint32_t leaf, const double* uniforms,
                            double* x) const {
  BlendedRow rows[2][mostRows(D)];
  std::size_t count = 1;
  rows[0][0] = {0, 1.0};
  for (uint32_t a = 0; a < D; ++a) {
    const BasisLevel& level = *levels_[a];
    const LeafSide side = leaves.descent.sides(leaf)[a];
    // The density along this axis, given the coordinates before.
    double given[kMostLeafCoefficients];
    const double* from = along(leaves, leaf, a);
    for (uint32_t j = 0; j < level.count; ++j) {
      double sum = 0.0;
      for (std::size_t r = 0; r < count; ++r) {
        sum += rows[a % 2][r].value * from[rows[a % 2][r].index * level.count + j];
      }
      given[j] = sum;
    }
    double b[AWD_BASIS_MAX_ORDER];
    const auto massOf = [&](uint32_t cell) {
      std::fill(b, b + level.order, 0.0);
      for (uint32_t k = 0; k < level.alive; ++k) {
        const std::size_t row = std::size_t{cell} * level.alive + k;
        const double* piece = &level.pieces[row * level.order];
        for (uint32_t o = 0; o < level.order; ++o) b[o] += given[level.functions[row]] * piece[o];
      }
      double mass = b[0];
      for (uint32_t o = 1; o < level.order; ++o) mass += b[o];
      return mass;
    };
    const auto [cell, u] = drawCell(level.cells, uniforms[a], massOf);
    const double* polynomial = given;
    if (!bernstein_[a]) {
      massOf(cell);
      polynomial = b;
    }
    x[a] = placeInLeaf(level, cell, side, invertPolynomialCdf(polynomial, level.order, u)).x;
    if (a + 1 == D) break;
    AxisValues at;
    evaluateAxis(level, (x[a] - side.lower) / side.size, at);
    count = blend(rows[a % 2], count, at, level.count, rows[(a + 1) % 2]);
  }
}

template <std::size_t N>
void LeafSampler::sampleBoxes(const Leaves& leaves, std::size_t count, const BlockDescent<N>& block,
                              double* points, double* pdfs) const {
  const uint32_t d = shape_.dimensions;
  uint32_t box[N] = {0};  // of those along the axes so far
  for (uint32_t a = 0; a < d; ++a) {
    const BasisLevel& level = *levels_[a];
    const uint32_t cells = level.cells;
    forEachSample<N>(count, [&](std::size_t i) {
      const LeafSide side = leaves.descent.sides(block.leaf[i])[a];
      const double* masses = along(leaves, block.leaf[i], a) + box[i] * cells;
      const auto [cell, u] =
          drawCell(cells, block.u[a][i], [masses](uint32_t k) { return masses[k]; });
      points[i * d + a] = placeInLeaf(level, cell, side, u).x;
      box[i] = box[i] * cells + cell;
    });
  }
  if (!pdfs) return;
  forEachSample<N>(count, [&](std::size_t i) {
    pdfs[i] = leaves.coefficients[block.leaf[i] * leafSize_ + box[i]];
  });
}

template <uint32_t O, std::size_t R, std::size_t N>
void LeafSampler::samplePolynomials(uint32_t a, const Leaves& leaves, std::size_t count,
                                    const BlockDescent<N>& block, const BlockRows<R, N>& rows,
                                    double* points, double* pdfs) const {
  const uint32_t d = shape_.dimensions;
  const BasisLevel& level = *levels_[a];
  BlockAxis<O, N> axis;
  forEachSample<N>(count, [&](std::size_t i) {
    const double* from = along(leaves, block.leaf[i], a);
    for (uint32_t k = 0; k < O; ++k) {
      double c = rows.value[0][i] * from[k];
      for (std::size_t r = 1; r < R; ++r) c += rows.value[r][i] * from[r * O + k];
      axis.given[k][i] = c;
    }
    axis.cell[i] = 0;
    axis.u[i] = std::max(block.u[a][i], kLeastUniform);
  });
  invertBlock(count, axis.given, axis);
  forEachSample<N>(count, [&](std::size_t i) {
    const LeafSide side = leaves.descent.sides(block.leaf[i])[a];
    const Place place = placeInLeaf(level, 0, side, axis.t[i]);
    points[i * d + a] = place.x;
    axis.t[i] = place.t;
  });
  if (a + 1 == d) {
    if (!pdfs) return;
    evaluateBlock(level, true, count, axis);
    contractBlock(count, axis, pdfs);
  } else if constexpr (R * O <= kMostUnrolledRows) {
    evaluateBlock(level, true, count, axis);
    samplePolynomials<O>(a + 1, leaves, count, block, blendBlock(level, count, axis, rows), points,
                         pdfs);
  }
}

template <std::size_t N>
void LeafSampler::sample(const Leaves& leaves, std::size_t count, const BlockDescent<N>& block,
                         double* points, double* pdfs) const {
  if (boxes_) return sampleBoxes(leaves, count, block, points, pdfs);
  if (polynomials_ == 2) {
    return samplePolynomials<2>(0, leaves, count, block, oneRow<N>(), points, pdfs);
  }
  if (polynomials_ == 3) {
    return samplePolynomials<3>(0, leaves, count, block, oneRow<N>(), points, pdfs);
  }
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    forEachSample<N>(count, [&](std::size_t i) {
      double u[d];
      for (uint32_t a = 0; a < d; ++a) u[a] = block.u[a][i];
      sampleAny<d>(leaves, block.leaf[i], u, points + i * d);
    });
  });
}

template void LeafSampler::sample(const Leaves&, std::size_t, const BlockDescent<1>&, double*,
                                  double*) const;
template void LeafSampler::sample(const Leaves&, std::size_t, const BlockDescent<kBlock>&, double*,
                                  double*) const;

#define AWD_INSTANTIATE(D)                                                                         \
  template void LeafSampler::sampleAny<D>(const Leaves&, uint32_t, const double*, double*) const;
AWD_INSTANTIATE(1)
AWD_INSTANTIATE(2)
AWD_INSTANTIATE(3)
AWD_INSTANTIATE(4)
AWD_INSTANTIATE(5)
AWD_INSTANTIATE(6)
#undef AWD_INSTANTIATE

}  // namespace awd
