// SPDX-License-Identifier: Apache-2.0
#include "refit/envelope_cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "refit/cuthill_mckee.h"
#include "refit/solver.h"

namespace awd {

namespace {

constexpr uint32_t kNone = 0xffffffffu;

/// Pivots below this, relative to the diagonal, are nothing but rounding.
constexpr double kSmallestPivot = 0x1p-46;

/// Operations after which the host is asked again.
constexpr double kOperationsPerReport = 0x1p26;

/// Two doubles that compilers keep in one register, and add and multiply at once.
using Pair = double __attribute__((vector_size(16)));

Pair pairAt(const double* p) {
  Pair pair;
  std::memcpy(&pair, p, sizeof pair);
  return pair;
}

/// out[r][c] = sum over k of a[r * aStride + k] b[c * bStride + k] of two rows and four.
void products(const double* a, uint64_t aStride, const double* b, uint64_t bStride, uint32_t count,
              double out[2][4]) {
  Pair sums[2][4] = {};
  for (uint32_t k = 0; k < count; k += 2) {
    const Pair upper = pairAt(a + k), lower = pairAt(a + aStride + k);
    for (int c = 0; c < 4; ++c) {
      const Pair other = pairAt(b + c * bStride + k);
      sums[0][c] += upper * other;
      sums[1][c] += lower * other;
    }
  }
  for (int r = 0; r < 2; ++r) {
    for (int c = 0; c < 4; ++c) out[r][c] = sums[r][c][0] + sums[r][c][1];
  }
}

}  // namespace

EnvelopeCholesky::EnvelopeCholesky(const Quadratic& quadratic)
    : quadratic_(quadratic), order_(quadratic.size()), position_(quadratic.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  count();
  const double asItIs = operations_;
  std::vector<uint32_t> other = reverseCuthillMcKee(quadratic);
  order_.swap(other);
  count();
  if (operations_ < asItIs) return;
  order_.swap(other);
  count();
}

void EnvelopeCholesky::count() {
  findEnvelope(std::vector<uint8_t>(quadratic_.size(), 1));
  entries_ = 0;
  operations_ = 0.0;
  for (const Group& g : groups_) {
    entries_ += std::uint64_t{kGroup} * g.width;
    operations_ += 0.5 * kGroup * g.width * g.width;
  }
}

void EnvelopeCholesky::findEnvelope(const std::vector<uint8_t>& isFree) {
  free_.clear();
  std::fill(position_.begin(), position_.end(), kNone);
  for (const uint32_t j : order_) {
    if (!isFree[j]) continue;
    position_[j] = static_cast<uint32_t>(free_.size());
    free_.push_back(j);
  }
  groups_.resize((free_.size() + kGroup - 1) / kGroup);
  uint64_t begin = 0;
  for (uint32_t g = 0; g < groups(); ++g) {
    uint32_t first = g * kGroup;
    for (uint32_t i = g * kGroup; i < unpadded((g + 1) * kGroup); ++i) {
      quadratic_.forEachEntry(free_[i],
                              [&](uint32_t k, double) { first = std::min(first, position_[k]); });
    }
    first -= first % kGroup;
    groups_[g] = {first, (g + 1) * kGroup - first, begin};
    begin += std::uint64_t{kGroup} * groups_[g].width;
  }
}

void EnvelopeCholesky::fillIn(uint32_t group, const std::vector<double>& extra) {
  for (uint32_t i = group * kGroup; i < (group + 1) * kGroup; ++i) {
    double* row = rowOf(i);
    if (i >= free_.size()) {
      row[i] = 1.0;
      continue;
    }
    quadratic_.forEachEntry(free_[i], [&](uint32_t k, double value) {
      if (position_[k] <= i) row[position_[k]] = value;
    });
    row[i] += extra[free_[i]];
  }
}

/// The columns of an earlier group in the rows of this one.
void EnvelopeCholesky::eliminate(uint32_t group, uint32_t other) {
  const uint32_t column = other * kGroup;
  const uint32_t from = std::max(groups_[group].first, groups_[other].first);
  for (uint32_t half = 0; half < kGroup; half += 2) {
    double* rows = rowOf(group * kGroup + half);
    double sums[2][4];
    products(rows + from, groups_[group].width, rowOf(column) + from, groups_[other].width,
             column - from, sums);
    for (uint32_t r = 0; r < 2; ++r) {
      double* row = rows + std::uint64_t{r} * groups_[group].width + column;
      for (uint32_t c = 0; c < kGroup; ++c) {
        const double* pivotRow = rowOf(column + c) + column;
        double value = row[c] - sums[r][c];
        for (uint32_t k = 0; k < c; ++k) value -= row[k] * pivotRow[k];
        row[c] = value / pivotRow[c];
      }
    }
  }
}

void EnvelopeCholesky::factorDiagonal(uint32_t group, const std::vector<double>& extra) {
  const uint32_t begin = group * kGroup;
  for (uint32_t i = begin; i < unpadded(begin + kGroup); ++i) {
    double* row = rowOf(i);
    for (uint32_t j = begin; j <= i; ++j) {
      const double* other = rowOf(j);
      double sum = row[j];
      for (uint32_t k = groups_[group].first; k < j; ++k) sum -= row[k] * other[k];
      if (j < i) {
        row[j] = sum / other[j];
      } else {
        const double diagonal = quadratic_.diagonal(free_[i]) + extra[free_[i]];
        row[i] = std::sqrt(sum > kSmallestPivot * diagonal ? sum : diagonal);
      }
    }
  }
}

void EnvelopeCholesky::factor(const std::vector<uint8_t>& isFree, const std::vector<double>& extra,
                              double fraction) {
  findEnvelope(isFree);
  uint64_t size = 0;
  for (const Group& g : groups_) size += std::uint64_t{kGroup} * g.width;
  factor_.assign(size, 0.0);
  double unreported = 0.0;
  for (uint32_t g = 0; g < groups(); ++g) {
    fillIn(g, extra);
    for (uint32_t other = groups_[g].first / kGroup; other < g; ++other) eliminate(g, other);
    factorDiagonal(g, extra);
    unreported += 0.5 * kGroup * groups_[g].width * groups_[g].width;
    if (unreported > kOperationsPerReport) {
      reportProgress(quadratic_.problem(), fraction);
      unreported = 0.0;
    }
  }
}

void EnvelopeCholesky::solve(std::vector<double>& r) const {
  std::vector<double> x(free_.size());
  for (uint32_t i = 0; i < free_.size(); ++i) {
    const double* row = rowOf(i);
    double sums[2] = {0.0, 0.0};
    for (uint32_t k = groups_[i / kGroup].first; k < i; ++k) sums[k % 2] += row[k] * x[k];
    x[i] = (r[free_[i]] - (sums[0] + sums[1])) / row[i];
  }
  for (uint32_t i = static_cast<uint32_t>(free_.size()); i-- > 0;) {
    const double* row = rowOf(i);
    x[i] /= row[i];
    for (uint32_t k = groups_[i / kGroup].first; k < i; ++k) x[k] -= row[k] * x[i];
    r[free_[i]] = x[i];
  }
}

}  // namespace awd
