// SPDX-License-Identifier: Apache-2.0
#include "density/projection.h"

#include <algorithm>
#include <cmath>

namespace awd {

std::pmr::vector<double> project(std::pmr::memory_resource* memory, const BasisLevel& level,
                                 const GramSolver& gram, const SquareStatistics& statistics) {
  const uint32_t n = level.count;
  std::pmr::vector<double> c(std::size_t{n} * n, 0.0, memory);
  double largest = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    const uint64_t count = statistics.count(i);
    if (count == 0) continue;
    c[i] = statistics.sum(i) / static_cast<double>(count);
    largest = std::max(largest, c[i]);
  }
  // Products of weights and tiny values would underflow; only the shape matters.
  const int exponent = largest > 0.0 ? std::ilogb(largest) : 0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = std::ldexp(c[i], -exponent) * level.weights[i / n] * level.weights[i % n];
  }
  gram.solve(c.data(), 1, n, n);
  gram.solve(c.data(), n, 1, n);
  return c;
}

bool clampCoefficients(const BasisLevel& level, double tau,
                       std::pmr::vector<double>& coefficients) {
  const uint32_t n = level.count;
  double mean = 0.0;  // of the density on the unit square, which is its integral
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    mean += std::max(coefficients[i], 0.0) * level.weights[i / n] * level.weights[i % n];
  }
  if (!(mean > 0.0) || !std::isfinite(mean)) return false;
  const double least = std::max(tau, 0.0) * mean;
  for (double& c : coefficients) c = std::max(c, least);
  return true;
}

}  // namespace awd
