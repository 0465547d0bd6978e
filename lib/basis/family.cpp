// SPDX-License-Identifier: Apache-2.0
#include "basis/family.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "basis/cell.h"

namespace awd {

namespace {

/// Rounding that stands where a 0 should be, to either side of it, goes.
double cleaned(double value, double rounding) { return value <= rounding ? 0.0 : value; }

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
  std::pmr::vector<uint32_t> next(to.componentBegin);
  for (std::size_t row = 0; row < rows; ++row) {
    const double mass = massOf(row);
    if (mass <= 0.0) continue;
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
    : name_(table.name, memory), minLevel_(table.minLevel), levels_(memory) {
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
    if (l < last) compileTwoScale(from, to);
  }
}

}  // namespace awd
