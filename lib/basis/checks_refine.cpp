// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "basis/checks.h"

namespace awd {

namespace {

using Combination = Row<2 * kMaxOrder>;

/// Compares N_j with its combination of finer functions at x.
void compareAt(const TestedLevel& level, const TableLevel& finer, const Combination& h, uint32_t j,
               double x, Check& check) {
  const double got = evaluate(level, x).of(j);
  const Row<kMaxOrder> fine = evaluate(finer, x);
  double want = 0.0;
  for (uint32_t i = 0; i < fine.size; ++i) want += h.of(fine.functions[i]) * fine.values[i];
  if (check.fails(std::abs(got - want) / (1.0 + 1e-3 * finer.cells))) {
    check.say(
        "two-scale relation does not hold: level %u, function %u, x = %.17g: the function is "
        "%.12g, "
        "its combination of level %u is %.12g",
        level.level, j, x, got, finer.level, want);
  }
}

}  // namespace

void checkTwoScale(const TestedLevel& level, const TableLevel& finer, Check& check) {
  for (const uint32_t j : level.someFunctions) {
    const Combination h = refine(level, finer, j);
    for (uint32_t i = 0; i < h.size; ++i) {
      if (check.fails(std::isfinite(h.values[i]) ? -h.values[i] : NAN)) {
        check.say(
            "two-scale coefficient is negative or not finite: level %u, function %u, finer "
            "function %u: got %g",
            level.level, j, h.functions[i], h.values[i]);
      }
    }
    // Points inside every finer cell where either side may be alive, and a few elsewhere.
    const auto compare = [&](uint32_t fineCell) {
      for (uint32_t p = 0; p <= level.table->order; ++p) {
        const double t = (p + 0.41) / (level.table->order + 1);
        compareAt(level, finer, h, j, (fineCell + t) / finer.cells, check);
      }
    };
    for (uint32_t i = 0; i < h.size; ++i) {
      const CellRange range = supportCells(finer, h.functions[i]);
      for (const uint32_t c : spread(range.size, 16)) compare((range.first + c) % finer.cells);
    }
    for (const uint32_t c : spread(finer.cells, 16)) compare(c);
    const CellRange range = supportCells(level, j);
    for (const uint32_t i : spread(range.size, 16)) {
      const double x = ((range.first + i) % level.cells + 0.29) / level.cells;
      compareAt(level, finer, h, j, x, check);
    }
  }
}

void checkTwoScaleMass(const TestedLevel& level, const TableLevel& finer, Check& check) {
  for (const uint32_t j : level.someFunctions) {
    const Combination h = refine(level, finer, j);
    double want = 0.0;
    for (uint32_t i = 0; i < h.size; ++i) {
      want += h.values[i] * finer.table->weight(finer.level, h.functions[i]);
    }
    const double got = level.table->weight(level.level, j);
    if (check.fails(std::abs(got - want) * level.cells)) {
      check.say(
          "two-scale relation changes the mass: level %u, function %u: weight %.12g, but its "
          "combination of level %u weighs %.12g",
          level.level, j, got, finer.level, want);
    }
  }
}

}  // namespace awd
