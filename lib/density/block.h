// SPDX-License-Identifier: Apache-2.0
// Samples are drawn in blocks, each step for all of a block before the next one: the long chain of
// operations that a sample is overlaps with those of its neighbours, and loops of nothing but
// arithmetic become vector code. Every sample gets the bits that it would get alone.
#pragma once

#include <algorithm>

#include "density/point.h"

namespace awd {

/// The most samples of a block. There are blocks for one sample too, which the compiler keeps in
/// registers: below N is how many samples a block has room for, and `count` how many it has.
constexpr std::size_t kBlock = 32;

/// Calls visit(i) for the samples of a block.
template <std::size_t N, class Visit>
inline void forEachSample(std::size_t count, Visit&& visit) {
  if constexpr (N == 1) {
    visit(std::size_t{0});
  } else {
    for (std::size_t i = 0; i < count; ++i) visit(i);
  }
}

/// As BlendedRow: R rows of each sample.
template <std::size_t R, std::size_t N>
struct BlockRows {
  uint32_t index[R][N];
  double value[R][N];
};

/// The only row of a first axis.
template <std::size_t N>
inline BlockRows<1, N> oneRow() {
  BlockRows<1, N> rows;
  std::fill_n(rows.index[0], N, 0u);
  std::fill_n(rows.value[0], N, 1.0);
  return rows;
}

/// A block at one axis of bases with O functions of order O alive on every cell.
template <uint32_t O, std::size_t N>
struct BlockAxis {
  uint32_t cell[N];
  double u[N];             ///< uniforms within the cells
  double given[O][N];      ///< coefficients of the functions alive, given the coordinates before
  double bernstein[O][N];  ///< of the polynomials that they make on the cells
  double t[N];             ///< places in the cells
  double value[O][N];      ///< of the functions alive, there
};

/// The functions' polynomials, summed.
template <uint32_t O, std::size_t N>
inline void sumPieces(const BasisLevel& level, std::size_t count, BlockAxis<O, N>& axis) {
  const double* pieces = level.pieces.data();
  forEachSample<N>(count, [&](std::size_t i) {
    const double* piece = pieces + std::size_t{axis.cell[i]} * O * O;
    for (uint32_t o = 0; o < O; ++o) {
      double b = axis.given[0][i] * piece[o];
      for (uint32_t k = 1; k < O; ++k) b += axis.given[k][i] * piece[k * O + o];
      axis.bernstein[o][i] = b;
    }
  });
}

/// Places of the uniforms, by the inverse CDF of the polynomials b: as invertPolynomialCdf().
template <uint32_t O, std::size_t N>
inline void invertBlock(std::size_t count, const double (*b)[N], BlockAxis<O, N>& axis) {
  static_assert(O <= 3);
  if constexpr (O == 1) {
    forEachSample<N>(count, [&](std::size_t i) { axis.t[i] = axis.u[i]; });
  } else if constexpr (O == 2) {
    forEachSample<N>(
        count, [&](std::size_t i) { axis.t[i] = invertLinearCdf(b[0][i], b[1][i], axis.u[i]); });
  } else {
    const auto cdf = [&](std::size_t i) {
      return ParabolaCdf(b[0][i], b[1][i], b[2][i], axis.u[i]);
    };
    forEachSample<N>(count, [&](std::size_t i) { axis.t[i] = cdf(i).guess(); });
    double unsolved = 0.0;
    forEachSample<N>(count,
                     [&](std::size_t i) { unsolved += cdf(i).solvedBy(axis.t[i]) ? 0.0 : 1.0; });
    if (unsolved == 0.0) return;
    forEachSample<N>(count, [&](std::size_t i) {
      if (!cdf(i).solvedBy(axis.t[i])) axis.t[i] = cdf(i).solve();
    });
  }
}

/// Values of the functions alive at the places. bernstein: as hasBernsteinPieces().
template <uint32_t O, std::size_t N>
inline void evaluateBlock(const BasisLevel& level, bool bernstein, std::size_t count,
                          BlockAxis<O, N>& axis) {
  forEachSample<N>(count, [&](std::size_t i) {
    double b[O];
    bernsteinPolynomials<O>(axis.t[i], b);
    for (uint32_t k = 0; k < O; ++k) axis.value[k][i] = b[k];
  });
  if (bernstein) return;
  const double* pieces = level.pieces.data();
  forEachSample<N>(count, [&](std::size_t i) {
    const double* piece = pieces + std::size_t{axis.cell[i]} * O * O;
    double b[O];
    for (uint32_t k = 0; k < O; ++k) b[k] = axis.value[k][i];
    for (uint32_t k = 0; k < O; ++k, piece += O) {
      double value = piece[0] * b[0];
      for (uint32_t o = 1; o < O; ++o) value += piece[o] * b[o];
      axis.value[k][i] = value;
    }
  });
}

/// The density at the places along the last axis, given those along the others: as contract().
template <uint32_t O, std::size_t N>
inline void contractBlock(std::size_t count, const BlockAxis<O, N>& axis, double* pdfs) {
  forEachSample<N>(count, [&](std::size_t i) {
    double sum = axis.value[0][i] * axis.given[0][i];
    for (uint32_t k = 1; k < O; ++k) sum += axis.value[k][i] * axis.given[k][i];
    pdfs[i] = sum;
  });
}

/// The rows of the next axis: as blend().
template <uint32_t O, std::size_t R, std::size_t N>
inline BlockRows<R * O, N> blendBlock(const BasisLevel& level, std::size_t count,
                                      const BlockAxis<O, N>& axis, const BlockRows<R, N>& present) {
  BlockRows<R * O, N> next;
  const uint32_t* alive = level.functions.data();
  forEachSample<N>(count, [&](std::size_t i) {
    const uint32_t* functions = alive + std::size_t{axis.cell[i]} * O;
    for (std::size_t r = 0; r < R; ++r) {
      for (uint32_t k = 0; k < O; ++k) {
        next.index[r * O + k][i] = present.index[r][i] * level.count + functions[k];
        next.value[r * O + k][i] = present.value[r][i] * axis.value[k][i];
      }
    }
  });
  return next;
}

}  // namespace awd
