// SPDX-License-Identifier: Apache-2.0
#include "refit/pivoting.h"

#include <algorithm>

namespace awd {

namespace {

/// Turns without a new least number of wrong unknowns before it is given up.
constexpr uint32_t kPatience = 3;

}  // namespace

bool pivot(const Quadratic& quadratic, FreeSolver& solver, double fraction, FreeSet& set,
           std::vector<double>& x) {
  const uint32_t n = quadratic.size();
  std::vector<double> step(n);
  std::vector<uint32_t> wrong;
  std::fill(set.extra.begin(), set.extra.end(), 0.0);
  std::size_t fewest = n + std::size_t{1};
  for (uint32_t patience = kPatience; patience > 0;) {
    for (uint32_t j = 0; j < n; ++j) {
      if (!set.isFree[j]) x[j] = quadratic.lower(j);
    }
    for (uint32_t j = 0; j < n; ++j) {
      step[j] = set.isFree[j] ? -quadratic.gradient(j, x.data()) : 0.0;
    }
    solver.prepare(set, fraction);
    solver.solve(step);
    for (uint32_t j = 0; j < n; ++j) x[j] += step[j];

    wrong.clear();
    for (uint32_t j = 0; j < n; ++j) {
      const bool isWrong =
          set.isFree[j] ? x[j] < quadratic.lower(j) : quadratic.gradient(j, x.data()) < 0.0;
      if (isWrong) wrong.push_back(j);
    }
    if (wrong.empty()) return true;
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      patience = kPatience;
    } else {
      --patience;
    }
    for (const uint32_t j : wrong) set.isFree[j] = !set.isFree[j];
  }
  return false;
}

}  // namespace awd
