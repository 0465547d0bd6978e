// SPDX-License-Identifier: Apache-2.0
#include "basis/cell.h"

#include <algorithm>
#include <cmath>

#include "util/error.h"

namespace awd {

namespace {

/// Room behind the array that a plugin fills, to see that it stays within.
constexpr uint32_t kSlack = 48;
constexpr double kUntouched = -0x1.5a5a5a5a5a5a5p+777;

void checkIndices(const TableLevel& level, const char* what, uint32_t first, uint32_t size) {
  if (first >= level.count) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "%s: first index %u, but level %u has %u functions", what,
         first, level.level, level.count);
  }
  if (!level.periodic() && size > level.count - first) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "%s: functions %u to %u, but level %u has %u", what, first,
         first + size - 1, level.level, level.count);
  }
}

}  // namespace

Row<kMaxOrder> evaluate(const TableLevel& level, double x) {
  double values[kMaxOrder + kSlack];
  std::fill(std::begin(values), std::end(values), kUntouched);
  uint32_t first = 0;
  const uint32_t size = level.table->eval(level.level, x, &first, values);
  if (size < 1 || size > kMaxOrder || values[kMaxOrder] != kUntouched) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST,
         "eval: level %u, x = %.17g: gives %u values, but 1 to %u can be alive", level.level, x,
         size, kMaxOrder);
  }
  checkIndices(level, "eval", first, size);
  Row<kMaxOrder> row;
  for (uint32_t i = 0; i < size; ++i) row.add((first + i) % level.count, values[i]);
  return row;
}

Row<2 * kMaxOrder> refine(const TableLevel& level, const TableLevel& finer, uint32_t j) {
  constexpr uint32_t most = 2 * kMaxOrder;
  double h[most + kSlack];
  std::fill(std::begin(h), std::end(h), kUntouched);
  uint32_t first = 0;
  const uint32_t size = level.table->twoScale(level.level, j, &first, h);
  if (size < 1 || size > most || h[most] != kUntouched) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST,
         "twoScale: level %u, function %u: gives %u values, but it may be 1 to %u", level.level, j,
         size, most);
  }
  checkIndices(finer, "twoScale", first, size);
  Row<most> row;
  for (uint32_t i = 0; i < size; ++i) row.add((first + i) % finer.count, h[i]);
  return row;
}

void readWavelet(const AWDBasisFamily& table, uint32_t k, uint32_t size, double* g) {
  double values[2 * kMaxOrder + kSlack];
  std::fill(std::begin(values), std::end(values), kUntouched);
  table.wavelet(k, values);
  if (values[size] != kUntouched) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "wavelet %u: writes more than the %u coefficients of level 1",
         k, size);
  }
  for (uint32_t i = 0; i < size; ++i) {
    if (!std::isfinite(values[i]) || values[i] == kUntouched) {
      fail(AWD_ERROR_PLUGIN_SELF_TEST, "wavelet %u: coefficient %u is not finite: got %g", k, i,
           values[i]);
    }
    g[i] = values[i];
  }
}

CellPieces fitCell(const TableLevel& level, uint32_t cell, const BernsteinFit& fit) {
  const uint32_t order = level.table->order;
  CellPieces pieces;
  double values[kMaxOrder][kMaxOrder] = {};
  for (uint32_t i = 0; i < order; ++i) {
    const double x = (cell + fit.node(i)) / level.cells;
    const Row<kMaxOrder> row = evaluate(level, x);
    for (uint32_t r = 0; r < row.size; ++r) {
      if (std::abs(row.values[r]) <= fit.rounding()) continue;
      uint32_t at = 0;
      while (at < pieces.size && pieces.functions[at] != row.functions[r]) ++at;
      if (at == kMaxOrder) {
        fail(AWD_ERROR_PLUGIN_SELF_TEST,
             "eval: level %u, cell %u: more than %u functions are alive on one cell", level.level,
             cell, kMaxOrder);
      }
      if (at == pieces.size) pieces.functions[pieces.size++] = row.functions[r];
      values[at][i] = row.values[r];
    }
  }
  for (uint32_t a = 0; a < pieces.size; ++a) fit.solve(values[a], pieces.b[a]);
  return pieces;
}

}  // namespace awd
