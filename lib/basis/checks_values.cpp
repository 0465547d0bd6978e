// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "basis/checks.h"
#include "basis/quadrature.h"
#include "util/error.h"

namespace awd {

namespace {

/// Where every level is evaluated: 257 points with both ends, and every knot from both sides.
template <class Body>
void forEachPoint(const TestedLevel& level, Body&& body) {
  for (int i = 0; i <= 256; ++i) body(i / 256.0);
  for (const uint32_t c : level.someCells) {
    body(static_cast<double>(c) / level.cells);
    body((c + 0.5) / level.cells);
    body(std::nextafter((c + 1.0) / level.cells, 0.0));
  }
}

/// On small cells a plugin's and our own place within one lie apart by rounding: errors count for
/// less there.
double relative(const TableLevel& level, double error) {
  return error / (1.0 + 1e-3 * level.cells);
}

/// Whether c / cells is a number that the machine has.
bool exactKnot(const TableLevel& level, uint32_t c) {
  return std::fma(static_cast<double>(c) / level.cells, level.cells, -static_cast<double>(c)) == 0;
}

}  // namespace

void checkValues(const TestedLevel& level, Check& check) {
  forEachPoint(level, [&](double x) {
    const Row<kMaxOrder> row = evaluate(level, x);
    for (uint32_t i = 0; i < row.size; ++i) {
      const double value = row.values[i];
      if (check.fails(std::isfinite(value) ? -value : NAN)) {
        check.say("value is negative or not finite: level %u, function %u, x = %.17g: got %g",
                  level.level, row.functions[i], x, value);
      }
    }
  });
}

void checkUnity(const TestedLevel& level, Check& check) {
  forEachPoint(level, [&](double x) {
    const Row<kMaxOrder> row = evaluate(level, x);
    double sum = 0.0;
    for (uint32_t i = 0; i < row.size; ++i) sum += row.values[i];
    if (check.fails(std::abs(sum - 1.0))) {
      check.say("functions do not sum to 1: level %u, x = %.17g: got %.12g, want 1", level.level, x,
                sum);
    }
  });
}

void checkPolynomial(const TestedLevel& level, Check& check) {
  const uint32_t order = level.table->order;
  const BernsteinFit fit(order);
  for (const uint32_t c : level.someCells) {
    const CellPieces cell = fitCell(level, c, fit);
    const auto compare = [&](double x) {
      const double t = std::clamp(std::fma(x, level.cells, -static_cast<double>(c)), 0.0, 1.0);
      const Row<kMaxOrder> row = evaluate(level, x);
      const auto one = [&](uint32_t j, double got, double want) {
        if (check.fails(relative(level, std::abs(got - want)))) {
          check.say(
              "not a polynomial of degree %u: level %u, cell %u, function %u, x = %.17g: got "
              "%.12g, "
              "but the other values in the cell want %.12g",
              order - 1, level.level, c, j, x, got, want);
        }
      };
      for (uint32_t i = 0; i < row.size; ++i) {
        const double* b = cell.of(row.functions[i]);
        one(row.functions[i], row.values[i], b ? bernsteinValue(b, order, t) : 0.0);
      }
      for (uint32_t i = 0; i < cell.size; ++i) {
        one(cell.functions[i], row.of(cell.functions[i]), bernsteinValue(cell.b[i], order, t));
      }
    };
    const uint32_t points = order + 3;
    for (uint32_t i = 0; i < points; ++i) compare((c + (i + 0.37) / points) / level.cells);
    if (exactKnot(level, c)) compare(static_cast<double>(c) / level.cells);
    if (exactKnot(level, c + 1)) compare(std::nextafter((c + 1.0) / level.cells, 0.0));
    if (c + 1 == level.cells) compare(1.0);
  }
}

void checkCoefficients(const TestedLevel& level, Check& check) {
  const BernsteinFit fit(level.table->order);
  for (const uint32_t c : level.someCells) {
    const CellPieces cell = fitCell(level, c, fit);
    for (uint32_t i = 0; i < cell.size; ++i) {
      for (uint32_t k = 0; k < level.table->order; ++k) {
        if (check.fails(-cell.b[i][k])) {
          check.say(
              "a Bernstein coefficient is negative: level %u, cell %u, function %u, coefficient "
              "%u: got %g; the library samples by them",
              level.level, c, cell.functions[i], k, cell.b[i][k]);
        }
      }
    }
  }
}

CellRange supportCells(const TableLevel& level, uint32_t j) {
  double ab[2] = {NAN, NAN};
  level.table->support(level.level, j, ab);
  const double farthest = level.periodic() ? ab[0] + 1.0 : 1.0;
  if (!(ab[0] >= 0.0 && ab[0] < 1.0 && ab[1] > ab[0] && ab[1] <= farthest)) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST, "support is no interval: level %u, function %u: got %g to %g",
         level.level, j, ab[0], ab[1]);
  }
  const double begin = std::round(ab[0] * level.cells), end = std::round(ab[1] * level.cells);
  if (!(std::abs(ab[0] * level.cells - begin) <= 1e-9 &&
        std::abs(ab[1] * level.cells - end) <= 1e-9 && begin < end)) {
    fail(AWD_ERROR_PLUGIN_SELF_TEST,
         "support does not end where cells do: level %u, function %u: got %.17g to %.17g",
         level.level, j, ab[0], ab[1]);
  }
  return {static_cast<uint32_t>(begin), static_cast<uint32_t>(end - begin)};
}

void checkSupport(const TestedLevel& level, Check& check) {
  const BernsteinFit fit(level.table->order);
  const auto within = [&](const CellRange& range, uint32_t c) {
    return (c + level.cells - range.first % level.cells) % level.cells < range.size;
  };
  for (const uint32_t c : level.someCells) {
    const CellPieces cell = fitCell(level, c, fit);
    for (uint32_t i = 0; i < cell.size; ++i) {
      const double* b = cell.b[i];
      const double largest = *std::max_element(b, b + level.table->order);
      const bool inside = within(supportCells(level, cell.functions[i]), c);
      if (!inside && check.fails(largest)) {
        check.say("function is not 0 outside its support: level %u, function %u, cell %u: got %g",
                  level.level, cell.functions[i], c, largest);
      }
    }
  }
  for (const uint32_t j : level.someFunctions) {
    const CellRange range = supportCells(level, j);
    if (range.size >= level.cells && level.periodic()) continue;  // it may begin anywhere
    for (const uint32_t c : {range.first, range.first + range.size - 1}) {
      const double* b = fitCell(level, c % level.cells, fit).of(j);
      if (!b && check.fails(NAN)) {
        check.say("support is too large: level %u, function %u is 0 on cell %u", level.level, j,
                  c % level.cells);
      }
    }
  }
}

void checkWeights(const TestedLevel& level, Check& check) {
  const GaussRule gauss;
  for (const uint32_t j : level.someFunctions) {
    const CellRange range = supportCells(level, j);
    if (range.size > kWhole) continue;
    long double sum = 0.0L;
    for (uint32_t i = 0; i < range.size; ++i) {
      const uint32_t c = (range.first + i) % level.cells;
      for (uint32_t g = 0; g < kMaxOrder; ++g) {
        const double x = (c + gauss.points[g]) / level.cells;
        sum += gauss.weights[g] * evaluate(level, x).of(j);
      }
    }
    const auto want = static_cast<double>(sum / level.cells);
    const double got = level.table->weight(level.level, j);
    // Values are rounded, and so is the weight itself, by parts of the whole.
    const double rounding = 8.0 * std::numeric_limits<double>::epsilon() * want;
    const double error = std::max(std::abs(got - want) - rounding, 0.0) * level.cells;
    if (check.fails(got > 0.0 ? relative(level, error) : NAN)) {
      check.say("weight is not the integral: level %u, function %u: got %.12g, want %.12g",
                level.level, j, got, want);
    }
  }
}

}  // namespace awd
