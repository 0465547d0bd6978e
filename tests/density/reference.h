// SPDX-License-Identifier: Apache-2.0
// The families that we ship by textbook formulas that the library does not use: B-splines by Cox
// and de Boor's recursion, Bernstein polynomials by binomial coefficients.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace awdtest {

/// B-spline i of degree q at x over ascending knots, 0/0 = 0; the last interval is closed.
inline double coxDeBoor(const std::vector<double>& knots, size_t i, uint32_t q, double x) {
  if (q == 0) {
    const bool last = x == knots.back() && knots[i + 1] == knots.back();
    return knots[i] < knots[i + 1] && x >= knots[i] && (x < knots[i + 1] || last) ? 1.0 : 0.0;
  }
  const double rising = knots[i + q] - knots[i], falling = knots[i + q + 1] - knots[i + 1];
  double sum = 0.0;
  if (rising > 0.0) sum += (x - knots[i]) / rising * coxDeBoor(knots, i, q - 1, x);
  if (falling > 0.0) {
    sum += (knots[i + q + 1] - x) / falling * coxDeBoor(knots, i + 1, q - 1, x);
  }
  return sum;
}

/// All functions of a level at x in [0,1].
inline std::vector<double> referenceValues(const std::string& basis, uint32_t level, double x) {
  const uint32_t cells = (basis == "f2" ? 2u : 1u) << level;
  const double s = x * cells;  // exact
  const uint32_t cell = std::min(static_cast<uint32_t>(s), cells - 1);
  if (basis.find("bspline") == std::string::npos) {
    const uint32_t n = basis == "m2" ? 2 : basis == "m3" ? 3 : 1;
    const double t = s - cell;
    std::vector<double> values(n * cells, 0.0);
    double binomial = 1.0;
    for (uint32_t k = 0; k < n; ++k) {
      values[n * cell + k] = binomial * std::pow(t, k) * std::pow(1.0 - t, n - 1 - k);
      binomial = binomial * (n - 1 - k) / (k + 1);
    }
    return values;
  }
  const uint32_t q = basis[0] == 'l' ? 1 : 2;
  std::vector<double> knots;
  if (basis.find("periodic") == std::string::npos) {
    for (uint32_t i = 0; i <= cells + 2 * q; ++i) {
      knots.push_back(std::clamp(double(i) - q, 0.0, double(cells)));
    }
    std::vector<double> values(cells + q);
    for (uint32_t j = 0; j < values.size(); ++j) values[j] = coxDeBoor(knots, j, q, s);
    return values;
  }
  // Function j begins q cells before cell j; its copies all around add up.
  for (uint32_t i = 0; i <= q + 1; ++i) knots.push_back(i);
  std::vector<double> values(cells, 0.0);
  for (uint32_t j = 0; j < cells; ++j) {
    for (int turn = -3; turn <= 3; ++turn) {
      const double place = s - j + q + turn * double(cells);
      if (place >= 0.0 && place < q + 1.0) values[j] += coxDeBoor(knots, 0, q, place);
    }
  }
  return values;
}

/// sum_j c_j prod_a N_ja(x_a): the last axis runs fastest.
inline double tensorSum(const double* c, const std::vector<std::vector<double>>& values,
                        size_t axis = 0) {
  if (axis == values.size()) return *c;
  size_t stride = 1;
  for (size_t a = axis + 1; a < values.size(); ++a) stride *= values[a].size();
  double sum = 0.0;
  for (size_t j = 0; j < values[axis].size(); ++j) {
    if (values[axis][j] == 0.0) continue;
    sum += values[axis][j] * tensorSum(c + j * stride, values, axis + 1);
  }
  return sum;
}

}  // namespace awdtest
