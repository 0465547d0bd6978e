// SPDX-License-Identifier: Apache-2.0
#include "density/gram.h"

#include <algorithm>
#include <cmath>

#include "basis/bernstein.h"
#include "util/error.h"

namespace awd {

namespace {

/// Calls visit(j, k, int over one cell of N_j N_k) for every cell and pair alive on it.
template <class Visit>
void forEachCellIntegral(const BasisLevel& level, Visit&& visit) {
  for (uint32_t cell = 0; cell < level.cells; ++cell) {
    const std::size_t first = std::size_t{cell} * level.alive;
    for (std::size_t a = first; a < first + level.alive; ++a) {
      for (std::size_t b = first; b < first + level.alive; ++b) {
        const double integral = bernsteinProductIntegral(
            &level.pieces[a * level.order], &level.pieces[b * level.order], level.order);
        if (integral != 0.0) {
          visit(level.functions[a], level.functions[b], integral / level.cells);
        }
      }
    }
  }
}

}  // namespace

GramSolver::GramSolver(std::pmr::memory_resource* memory, const BasisLevel& level)
    : n_(level.count), position_(level.count, memory), factor_(memory) {
  // In a periodic family the last functions overlap the first. Laying the indices out as
  // 0, n-1, 1, n-2, .. makes neighbours on the circle neighbours on the line, at twice the band.
  bool wraps = false;
  forEachCellIntegral(level, [&](uint32_t j, uint32_t k, double) {
    wraps = wraps || (j > k ? j - k : k - j) >= level.order;
  });
  for (uint32_t j = 0; j < n_; ++j) {
    const bool firstHalf = j < (n_ + 1) / 2;
    position_[j] = !wraps ? j : firstHalf ? 2 * j : 2 * (n_ - 1 - j) + 1;
  }
  forEachCellIntegral(level, [&](uint32_t j, uint32_t k, double) {
    if (position_[j] > position_[k]) band_ = std::max(band_, position_[j] - position_[k]);
  });

  const std::size_t width = band_ + 1;
  factor_.assign(n_ * width, 0.0);
  forEachCellIntegral(level, [&](uint32_t j, uint32_t k, double integral) {
    const uint32_t row = position_[j];
    const uint32_t column = position_[k];
    if (row >= column) factor_[row * width + (row - column)] += integral;
  });
  for (uint32_t i = 0; i < n_; ++i) {
    double* row = &factor_[i * width];
    for (uint32_t j = i - std::min(i, band_); j <= i; ++j) {
      const double* other = &factor_[j * width];
      double value = row[i - j];
      for (uint32_t k = i - std::min(i, band_); k < j; ++k) {
        if (j - k <= band_) value -= row[i - k] * other[j - k];
      }
      if (j < i) {
        row[i - j] = value / other[0];
      } else if (value > 0.0) {
        row[0] = std::sqrt(value);
      } else {
        fail(AWD_ERROR_PLUGIN_SELF_TEST,
             "Gram matrix is not positive definite: level %u, function %u", level.level, i);
      }
    }
  }
}

void GramSolver::solve(double* b, std::size_t stride, std::size_t vectorStride,
                       std::size_t count) const {
  const std::size_t width = band_ + 1;
  std::pmr::vector<double> x(n_, factor_.get_allocator());
  for (std::size_t v = 0; v < count; ++v, b += vectorStride) {
    for (uint32_t j = 0; j < n_; ++j) x[position_[j]] = b[j * stride];
    for (uint32_t i = 0; i < n_; ++i) {
      for (uint32_t d = 1; d <= std::min(i, band_); ++d) x[i] -= factor_[i * width + d] * x[i - d];
      x[i] /= factor_[i * width];
    }
    for (uint32_t i = n_; i-- > 0;) {
      x[i] /= factor_[i * width];
      for (uint32_t d = 1; d <= std::min(i, band_); ++d) x[i - d] -= factor_[i * width + d] * x[i];
    }
    for (uint32_t j = 0; j < n_; ++j) b[j * stride] = x[position_[j]];
  }
}

std::pmr::vector<double> gramMatrix(std::pmr::memory_resource* memory, const BasisLevel& level) {
  std::pmr::vector<double> matrix(std::size_t{level.count} * level.count, 0.0, memory);
  forEachCellIntegral(level, [&](uint32_t j, uint32_t k, double integral) {
    matrix[std::size_t{j} * level.count + k] += integral;
  });
  return matrix;
}

}  // namespace awd
