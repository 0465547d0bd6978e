// SPDX-License-Identifier: Apache-2.0
// Thresholds of statistical tests with a stated false-alarm rate.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace awdtest {

struct Estimate {
  double mean = 0.0;
  double error = 0.0;  ///< standard error
};

inline double zScore(Estimate a, Estimate b) {
  const double error = std::hypot(a.error, b.error);
  if (error > 0.0) return (a.mean - b.mean) / error;
  return a.mean == b.mean ? 0.0 : HUGE_VAL;
}

inline double largest(const std::vector<double>& scores) {
  double result = 0.0;
  for (const double z : scores) result = std::max(result, std::isnan(z) ? HUGE_VAL : std::fabs(z));
  return result;
}

/// The z that |z| of any of `tests` normal variables exceeds with probability alpha at most
/// (Bonferroni: holds whatever their correlation).
inline double familyThreshold(double alpha, size_t tests) {
  const double tail = alpha / static_cast<double>(tests);
  double low = 0.0, high = 40.0;
  for (int i = 0; i < 100; ++i) {
    const double z = 0.5 * (low + high);
    (std::erfc(z / std::sqrt(2.0)) > tail ? low : high) = z;
  }
  return high;
}

/// P(X > x) of a chi-square variable: the regularised incomplete gamma function Q(k/2, x/2).
inline double chiSquareTail(double x, double degrees) {
  const double a = 0.5 * degrees, y = 0.5 * x;
  if (y <= 0.0) return 1.0;
  const double front = std::exp(a * std::log(y) - y - std::lgamma(a));
  if (y < a + 1.0) {  // the series of P
    double term = 1.0 / a, sum = term;
    for (double n = a + 1.0; term > 1e-15 * sum; n += 1.0) sum += term *= y / n;
    return 1.0 - front * sum;
  }
  double b = y + 1.0 - a, c = 1e300, d = 1.0 / b, fraction = d;  // the continued fraction of Q
  for (int i = 1; i < 10000; ++i) {
    const double an = -i * (i - a);
    b += 2.0;
    d = 1.0 / (an * d + b);
    c = b + an / c;
    fraction *= d * c;
    if (std::fabs(d * c - 1.0) < 1e-14) break;
  }
  return front * fraction;
}

}  // namespace awdtest
