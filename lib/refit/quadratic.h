// SPDX-License-Identifier: Apache-2.0
// Q(c) = c' A c / 2 - b' c over c >= lower, and how far a point is from its optimum.
#pragma once

#include <cstdint>
#include <vector>

#include "refit/refit_module.h"

namespace awd {

struct Optimality {
  /// Largest of |min(g_j, A_jj (c_j - lower_j))| (|g_j| where g_j < 0), g = A c - b, in units of
  /// (|A| |c| + |b|)_j: nothing but rounding at the optimum, whatever the units of A, b and c.
  double violation = 0.0;
  uint64_t atBound = 0;  ///< unknowns at their bounds that would like to go below
};

/// A problem that problemFault has nothing against, which must outlive this.
class Quadratic {
 public:
  explicit Quadratic(const AWDRefitProblem& problem);

  const AWDRefitProblem& problem() const { return problem_; }
  uint32_t size() const { return static_cast<uint32_t>(diagonalAt_.size()); }
  double diagonal(uint32_t j) const { return problem_.values[diagonalAt_[j]]; }
  double lower(uint32_t j) const { return problem_.lower[j]; }

  /// Calls visit(k, A_jk) for the entries of a row that are not zero.
  template <class Visit>
  void forEachEntry(uint32_t j, Visit&& visit) const {
    for (uint64_t i = problem_.rowBegin[j]; i < problem_.rowBegin[j + 1]; ++i) {
      if (problem_.values[i] != 0.0) visit(problem_.columns[i], problem_.values[i]);
    }
  }

  /// (A x)_j, in an order of its own for speed, always the same.
  double rowTimes(uint32_t j, const double* x) const {
    return rangeTimes(problem_.rowBegin[j], problem_.rowBegin[j + 1], x);
  }
  /// The same left and right of the diagonal alone.
  double rowTimesBelow(uint32_t j, const double* x) const {
    return rangeTimes(problem_.rowBegin[j], diagonalAt_[j], x);
  }
  double rowTimesAbove(uint32_t j, const double* x) const {
    return rangeTimes(diagonalAt_[j] + 1, problem_.rowBegin[j + 1], x);
  }

  /// dQ/dc_j.
  double gradient(uint32_t j, const double* c) const { return rowTimes(j, c) - problem_.rhs[j]; }

  /// (|A| |c| + |b|)_j, of which rounding takes a part in the gradient.
  double magnitude(uint32_t j, const double* c) const;

  /// Q(c + step) - Q(c), without the cancellation of that difference. gradient is that at c.
  double change(const std::vector<double>& gradient, const std::vector<double>& step) const;

  Optimality optimality(const std::vector<double>& c) const;

 private:
  double rangeTimes(uint64_t begin, uint64_t end, const double* x) const;

  const AWDRefitProblem& problem_;
  std::vector<uint64_t> diagonalAt_;  ///< where in columns and values
};

}  // namespace awd
