// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "basis/checks.h"
#include "basis/quadrature.h"

namespace awd {

namespace {

/// Of so many functions, the first of a level, the Gram matrix is taken.
constexpr uint32_t kGram = 256;

/// int N_j N_k, scaled so that the diagonal is 1; row by row.
class Gram {
 public:
  explicit Gram(const TestedLevel& level)
      : size_(std::min(level.count, kGram)), values_(std::size_t{size_} * size_) {
    const GaussRule gauss;
    for (uint32_t c = 0; c < level.cells; ++c) {
      for (uint32_t g = 0; g < kMaxOrder; ++g) {
        const Row<kMaxOrder> row = evaluate(level, (c + gauss.points[g]) / level.cells);
        for (uint32_t a = 0; a < row.size; ++a) {
          for (uint32_t b = 0; b < row.size; ++b) {
            if (row.functions[a] >= size_ || row.functions[b] >= size_) continue;
            at(row.functions[a], row.functions[b]) +=
                gauss.weights[g] * row.values[a] * row.values[b];
          }
        }
      }
    }
    std::vector<double> scale(size_);
    for (uint32_t j = 0; j < size_; ++j) scale[j] = 1.0 / std::sqrt(at(j, j));
    for (uint32_t j = 0; j < size_; ++j) {
      for (uint32_t k = 0; k < size_; ++k) at(j, k) *= scale[j] * scale[k];
    }
  }

  uint32_t size() const { return size_; }
  double& at(uint32_t j, uint32_t k) { return values_[std::size_t{j} * size_ + k]; }

 private:
  uint32_t size_;
  std::vector<double> values_;
};

}  // namespace

void checkGram(const TestedLevel& level, Check& check) {
  Gram gram(level);
  // Cholesky in place. The pivots tell how far a function is from the span of those before it.
  for (uint32_t j = 0; j < gram.size(); ++j) {
    double pivot = gram.at(j, j);
    for (uint32_t k = 0; k < j; ++k) pivot -= gram.at(j, k) * gram.at(j, k);
    if (check.fails(pivot > 0.0 ? 1.0 / pivot : NAN)) {
      check.say(
          "Gram matrix can't be solved: level %u: function %u is a combination of others (squared "
          "distance %.3g)",
          level.level, j, pivot);
    }
    if (!check.ok()) return;
    for (uint32_t i = j + 1; i < gram.size(); ++i) {
      double sum = gram.at(i, j);
      for (uint32_t k = 0; k < j; ++k) sum -= gram.at(i, k) * gram.at(j, k);
      gram.at(i, j) = sum / std::sqrt(pivot);
    }
  }
}

void checkOrthogonal(const TestedLevel& level, Check& check) {
  Gram gram(level);
  for (uint32_t j = 0; j < gram.size(); ++j) {
    for (uint32_t k = 0; k < j; ++k) {
      if (check.fails(std::abs(gram.at(j, k)))) {
        check.say(
            "flag ORTHOGONAL is not true: level %u: functions %u and %u have a scalar product of "
            "%.3g (each scaled to 1)",
            level.level, k, j, gram.at(j, k));
      }
    }
  }
}

void checkNested(const TestedLevel& level, Check& check) {
  const double dyadic = std::ldexp(1.0, static_cast<int>(level.level));
  for (const uint32_t j : level.someFunctions) {
    const CellRange range = supportCells(level, j);
    const double begin = static_cast<double>(range.first) / level.cells * dyadic;
    const double end = (static_cast<double>(range.first) + range.size) / level.cells * dyadic;
    const double outside = end - (std::floor(begin + 1e-9) + 1.0);
    if (check.fails(outside)) {
      check.say(
          "flag NESTED is not true: level %u: the support of function %u, %g to %g, is in no cell "
          "of size 1/%g",
          level.level, j, begin / dyadic, end / dyadic, dyadic);
    }
  }
}

void checkPeriodic(const TestedLevel& level, Check& check) {
  const uint32_t shift = level.count / level.cells;
  if (shift * level.cells != level.count) {
    if (check.fails(NAN)) {
      check.say("flag PERIODIC is not true: level %u: %u functions can't repeat on %u cells",
                level.level, level.count, level.cells);
    }
    return;
  }
  for (const uint32_t c : level.someCells) {
    for (uint32_t p = 0; p <= level.table->order; ++p) {
      const double t = (p + 0.41) / (level.table->order + 1);
      const Row<kMaxOrder> here = evaluate(level, (c + t) / level.cells);
      const Row<kMaxOrder> next = evaluate(level, ((c + 1) % level.cells + t) / level.cells);
      for (uint32_t i = 0; i < here.size; ++i) {
        const double shifted = next.of((here.functions[i] + shift) % level.count);
        if (check.fails(std::abs(shifted - here.values[i]))) {
          check.say(
              "flag PERIODIC is not true: level %u: function %u on cell %u is not the one before "
              "it moved by a cell: got %.12g, want %.12g",
              level.level, (here.functions[i] + shift) % level.count, (c + 1) % level.cells,
              shifted, here.values[i]);
        }
      }
    }
  }
}

}  // namespace awd
