// SPDX-License-Identifier: Apache-2.0
#include "basis/family.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "basis/cell.h"
#include "util/error.h"
#include "util/small_matrix.h"

namespace awd {

namespace {

/// Far more than rounding, and far less than a mistake.
constexpr double kRounding = 1e-6;
/// Of a function that is at most 1 the Bernstein coefficients of order 8 stay below this.
constexpr double kLargest = 1e4;

/// Rounding that stands where a 0 should be, to either side of it, goes.
double cleaned(double value, double rounding) { return value <= rounding ? 0.0 : value; }

/// The self-test looks at some cells of a large level; this is what must be true of all.
void checkCell(const TableLevel& from, uint32_t c, const CellPieces& cell) {
  if (cell.size == 0) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "level %u has no function on cell %u", from.level, c);
  }
  for (uint32_t a = 0; a < cell.size; ++a) {
    for (uint32_t k = 0; k < from.table->order; ++k) {
      const double b = cell.b[a][k];
      if (b >= -kRounding && b <= kLargest) continue;
      fail(AWD_ERROR_PLUGIN_SELF_TEST,
           "level %u, function %u, cell %u: a Bernstein coefficient is %g", from.level,
           cell.functions[a], c, b);
    }
  }
}

/// Likewise of weights.
void checkWeights(const BasisLevel& level) {
  for (uint32_t j = 0; j < level.count; ++j) {
    double mass = 0.0;
    for (uint32_t i = level.componentBegin[j]; i < level.componentBegin[j + 1]; ++i) {
      const BasisLevel::Piece& piece = level.componentPieces[i];
      const double* b =
          &level.pieces[(std::size_t{piece.cell} * level.alive + piece.row) * level.order];
      mass += std::accumulate(b, b + level.order, 0.0) / level.order / level.cells;
    }
    if (std::abs(level.weights[j] - mass) <= kRounding * (mass + 1.0 / level.cells)) continue;
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "level %u, function %u: its weight is %g, its integral %g",
         level.level, j, level.weights[j], mass);
  }
}

/// Every cell's functions and polynomials. Cells are fitted twice, first to see how many functions
/// are alive: keeping them would take more memory than the tables.
void compilePieces(const TableLevel& from, BasisLevel& to) {
  const BernsteinFit fit(to.order);
  for (uint32_t c = 0; c < to.cells; ++c) {
    to.alive = std::max(to.alive, fitCell(from, c, fit).size);
  }
  const std::size_t rows = std::size_t{to.cells} * to.alive;
  to.functions.resize(rows);
  to.pieces.resize(rows * to.order);
  for (uint32_t c = 0; c < to.cells; ++c) {
    const CellPieces cell = fitCell(from, c, fit);
    checkCell(from, c, cell);
    for (uint32_t a = 0; a < to.alive; ++a) {
      const std::size_t row = std::size_t{c} * to.alive + a;
      const bool filled = a < cell.size;
      to.functions[row] = cell.functions[filled ? a : 0];
      for (uint32_t k = 0; filled && k < to.order; ++k) {
        to.pieces[row * to.order + k] = cleaned(cell.b[a][k], fit.rounding());
      }
    }
  }
}

/// The pieces of every function in the order of their cells, with the share of its mass up to
/// the end of each.
void compileComponents(BasisLevel& to) {
  const auto massOf = [&](std::size_t row) {
    const double* b = &to.pieces[row * to.order];
    return std::accumulate(b, b + to.order, 0.0);
  };
  to.componentBegin.assign(std::size_t{to.count} + 1, 0);
  const std::size_t rows = to.functions.size();
  for (std::size_t row = 0; row < rows; ++row) {
    if (massOf(row) > 0.0) ++to.componentBegin[to.functions[row] + 1];
  }
  std::partial_sum(to.componentBegin.begin(), to.componentBegin.end(), to.componentBegin.begin());
  to.componentPieces.resize(to.componentBegin.back());
  std::pmr::vector<uint32_t> next(to.componentBegin, to.componentBegin.get_allocator());
  for (std::size_t row = 0; row < rows; ++row) {
    const double mass = massOf(row);
    if (!(mass > 0.0)) continue;
    const uint32_t j = to.functions[row];
    const uint32_t at = next[j]++;
    const double before = at > to.componentBegin[j] ? to.componentPieces[at - 1].cumulative : 0.0;
    to.componentPieces[at] = {static_cast<uint32_t>(row / to.alive),
                              static_cast<uint32_t>(row % to.alive), before + mass};
  }
  for (uint32_t j = 0; j < to.count; ++j) {
    const uint32_t begin = to.componentBegin[j], end = to.componentBegin[j + 1];
    if (begin == end) continue;
    const double whole = to.componentPieces[end - 1].cumulative;
    for (uint32_t i = begin; i < end; ++i) to.componentPieces[i].cumulative /= whole;
  }
}

void compileTwoScale(const TableLevel& from, BasisLevel& to) {
  const TableLevel finer(*from.table, from.level + 1);
  to.twoScaleBegin.push_back(0);
  for (uint32_t j = 0; j < to.count; ++j) {
    const Row<2 * kMaxOrder> row = refine(from, finer, j);
    for (uint32_t i = 0; i < row.size; ++i) {
      const double value = cleaned(row.values[i], 1e-15);
      if (value > 0.0) to.twoScale.push_back({row.functions[i], value});
    }
    to.twoScaleBegin.push_back(static_cast<uint32_t>(to.twoScale.size()));
  }
}

/// An orthonormal basis of what the halves of a cell have beyond the cell itself: the rest of
/// their functions, one after the other, beside the cell's functions and what was found before.
void completeWavelets(const BasisLevel& cell, BasisSplit& split) {
  const uint32_t n = split.size;
  SmallMatrix gram(2 * n, 2 * n);
  for (uint32_t c = 0; c < cell.cells; ++c) {
    for (uint32_t a = 0; a < cell.alive; ++a) {
      for (uint32_t b = 0; b < cell.alive; ++b) {
        const std::size_t i = std::size_t{c} * cell.alive + a, k = std::size_t{c} * cell.alive + b;
        const double product = bernsteinProductIntegral(&cell.pieces[i * cell.order],
                                                        &cell.pieces[k * cell.order], cell.order);
        for (uint32_t half = 0; half < 2; ++half) {
          gram.at(half * n + cell.functions[i], half * n + cell.functions[k]) +=
              product / (2.0 * cell.cells);
        }
      }
    }
  }
  SmallMatrix candidates(3 * n, 2 * n);
  for (uint32_t i = 0; i < 2 * n; ++i) {
    for (uint32_t j = 0; j < n; ++j) candidates.at(j, i) = split.functions[j * 2 * n + i];
    candidates.at(n + i, i) = 1.0L;
  }
  const SmallMatrix rows = orthonormalRows(candidates, gram, 1e-9L);
  if (rows.rows() != 2 * n) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "the functions of levels 0 and 1 are not independent");
  }
  for (uint32_t k = 0; k < n; ++k) {
    for (uint32_t i = 0; i < 2 * n; ++i) {
      split.wavelets[k * 2 * n + i] = static_cast<double>(rows.at(n + k, i));
    }
  }
}

void compileSplit(const AWDBasisFamily& table, const BasisLevel& cell, BasisSplit& to) {
  const uint32_t n = cell.count;
  if (n > kMaxOrder || table.minLevel != 0 || table.maxLevel < 1 || table.count(1) != 2 * n) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "flag NESTED is not true of %u functions at level %u", n,
         table.minLevel);
  }
  to.size = n;
  to.functions.assign(std::size_t{n} * 2 * n, 0.0);
  to.wavelets.assign(std::size_t{n} * 2 * n, 0.0);
  for (uint32_t j = 0; j < n; ++j) {
    const Row<2 * kMaxOrder> row = refine(TableLevel(table, 0), TableLevel(table, 1), j);
    for (uint32_t i = 0; i < row.size; ++i) {
      to.functions[j * 2 * n + row.functions[i]] = cleaned(row.values[i], 1e-15);
    }
  }
  if (table.wavelet) {
    for (uint32_t k = 0; k < n; ++k)
      readWavelet(table, k, 2 * n, &to.wavelets[std::size_t{k} * 2 * n]);
  } else {
    completeWavelets(cell, to);
  }
  // Orthogonal to the cell's functions, of which 1 is a sum.
  to.vanishingMoments = table.wavelet ? table.vanishingMoments : 1;
}

}  // namespace

BasisLevel::BasisLevel(std::pmr::memory_resource* memory)
    : functions(memory),
      pieces(memory),
      weights(memory),
      componentBegin(memory),
      componentPieces(memory),
      twoScaleBegin(memory),
      twoScale(memory) {}

Family::Family(std::pmr::memory_resource* memory, const AWDBasisFamily& table, uint32_t maxLevel)
    : name_(table.name, memory),
      flags_(table.flags),
      order_(table.order),
      minLevel_(table.minLevel),
      split_(memory),
      levels_(memory) {
  const uint32_t last = std::clamp(maxLevel, table.minLevel, table.maxLevel);
  levels_.reserve(last - minLevel_ + 1);
  for (uint32_t l = minLevel_; l <= last; ++l) {
    const TableLevel from(table, l);
    BasisLevel& to = levels_.emplace_back(memory);
    to.level = l;
    to.count = from.count;
    to.cells = from.cells;
    to.order = table.order;
    compilePieces(from, to);
    for (uint32_t j = 0; j < to.count; ++j) to.weights.push_back(table.weight(l, j));
    compileComponents(to);
    checkWeights(to);
    if (l < last) compileTwoScale(from, to);
  }
  if (nested()) compileSplit(table, levels_.front(), split_);
}

}  // namespace awd
