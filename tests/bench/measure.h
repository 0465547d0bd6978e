// SPDX-License-Identifier: Apache-2.0
// True and reported errors of a method over repetitions.
#pragma once

#include <string>
#include <vector>

#include "methods.h"

namespace bench {

/// What is to be measured.
struct Cell {
  const Integrand* integrand;
  const Method* method;
  uint64_t evaluations;
  int repetitions;
};

struct Figures {
  double rms = 0.0, mean = 0.0, median = 0.0;  ///< of |value - integral|
  double reported = 0.0;                       ///< root of the mean of the squares
  double ratio = 0.0;                          ///< reported / rms; NaN if both are 0
  double low = 0.0, high = 0.0;                ///< 95 % interval of the ratio, by bootstrap
};

/// Repetition r has seed r + 1. Cells are spread over `threads`; results don't depend on how.
std::vector<Figures> measure(const std::vector<Cell>& cells, unsigned threads);

}  // namespace bench
