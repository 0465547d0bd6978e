// SPDX-License-Identifier: Apache-2.0
// What a family's table says, asked safely: indices in range, repeats of a periodic family added
// up. Whatever does not fit throws AWD_ERROR_PLUGIN_SELF_TEST.
#pragma once

#include <cstdint>

#include "awd/basis.h"
#include "basis/bernstein.h"

namespace awd {

/// A level of a table, with its sizes.
struct TableLevel {
  const AWDBasisFamily* table;
  uint32_t level;
  uint32_t count;
  uint32_t cells;

  TableLevel(const AWDBasisFamily& family, uint32_t l)
      : table(&family), level(l), count(family.count(l)), cells(family.cells(l)) {}
  bool periodic() const { return (table->flags & AWD_BASIS_PERIODIC) != 0; }
};

/// Functions with their values, each at most once.
template <uint32_t capacity>
struct Row {
  uint32_t size = 0;
  uint32_t functions[capacity];
  double values[capacity];

  void add(uint32_t function, double value) {
    for (uint32_t i = 0; i < size; ++i) {
      if (functions[i] == function) {
        values[i] += value;
        return;
      }
    }
    functions[size] = function;
    values[size++] = value;
  }
  double of(uint32_t function) const {
    for (uint32_t i = 0; i < size; ++i) {
      if (functions[i] == function) return values[i];
    }
    return 0.0;
  }
};

/// The functions alive at x.
Row<kMaxOrder> evaluate(const TableLevel& level, double x);

/// N_j as a combination of the functions of the next level.
Row<2 * kMaxOrder> refine(const TableLevel& level, const TableLevel& finer, uint32_t j);

/// Coefficients g of wavelet k in the functions of level 1: `size` of them. Throws unless finite.
void readWavelet(const AWDBasisFamily& table, uint32_t k, uint32_t size, double* g);

/// The polynomials of one cell.
struct CellPieces {
  uint32_t size = 0;
  uint32_t functions[kMaxOrder];
  double b[kMaxOrder][kMaxOrder];  ///< Bernstein coefficients of each

  /// Those of a function, or null if it is not alive here.
  const double* of(uint32_t function) const {
    for (uint32_t i = 0; i < size; ++i) {
      if (functions[i] == function) return b[i];
    }
    return nullptr;
  }
};

/// As the plugin gave them; a function of which only rounding is left is dropped.
CellPieces fitCell(const TableLevel& level, uint32_t cell, const BernsteinFit& fit);

}  // namespace awd
