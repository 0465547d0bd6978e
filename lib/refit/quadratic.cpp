// SPDX-License-Identifier: Apache-2.0
#include "refit/quadratic.h"

#include <algorithm>
#include <cmath>

namespace awd {

Quadratic::Quadratic(const AWDRefitProblem& problem)
    : problem_(problem), diagonalAt_(problem.unknowns) {
  for (uint32_t j = 0; j < size(); ++j) {
    const uint32_t* row = problem_.columns + problem_.rowBegin[j];
    const uint32_t* end = problem_.columns + problem_.rowBegin[j + 1];
    diagonalAt_[j] = std::lower_bound(row, end, j) - problem_.columns;
  }
}

double Quadratic::rangeTimes(uint64_t begin, uint64_t end, const double* x) const {
  // Four sums at a time: one would wait for each addition in turn.
  double sums[4] = {0.0, 0.0, 0.0, 0.0};
  uint64_t i = begin;
  for (; i + 4 <= end; i += 4) {
    for (uint64_t s = 0; s < 4; ++s) {
      sums[s] += problem_.values[i + s] * x[problem_.columns[i + s]];
    }
  }
  for (; i < end; ++i) sums[0] += problem_.values[i] * x[problem_.columns[i]];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

double Quadratic::change(const std::vector<double>& gradient,
                         const std::vector<double>& step) const {
  double change = 0.0;
  for (uint32_t j = 0; j < size(); ++j) {
    if (step[j] != 0.0) change += step[j] * (gradient[j] + 0.5 * rowTimes(j, step.data()));
  }
  return change;
}

double Quadratic::magnitude(uint32_t j, const double* c) const {
  double sum = std::abs(problem_.rhs[j]);
  forEachEntry(j, [&](uint32_t k, double value) { sum += std::abs(value * c[k]); });
  return sum;
}

Optimality Quadratic::optimality(const std::vector<double>& c) const {
  Optimality result;
  for (uint32_t j = 0; j < size(); ++j) {
    const double g = gradient(j, c.data());
    const double room = diagonal(j) * (c[j] - lower(j));
    if (c[j] <= lower(j) && g > 0.0) ++result.atBound;
    const double violation = g > 0.0 ? std::min(g, room) : -g;
    if (violation > 0.0) {
      result.violation = std::max(result.violation, violation / magnitude(j, c.data()));
    } else if (!(violation <= 0.0)) {
      result.violation = HUGE_VAL;  // not a number
    }
  }
  return result;
}

}  // namespace awd
