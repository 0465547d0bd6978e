// SPDX-License-Identifier: Apache-2.0
#include "basis/bernstein.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace awd {

double bernsteinValue(const double* b, uint32_t order, double t) {
  double p[kMaxOrder + 1];
  std::copy(b, b + order, p);
  const double s = 1.0 - t;
  for (uint32_t left = order - 1; left > 0; --left) {
    for (uint32_t k = 0; k < left; ++k) p[k] = s * p[k] + t * p[k + 1];
  }
  return p[0];
}

double bernsteinIntegral(const double* b, uint32_t order, double t) {
  double sums[kMaxOrder + 1] = {0.0};
  for (uint32_t k = 0; k < order; ++k) sums[k + 1] = sums[k] + b[k] / order;
  return bernsteinValue(sums, order + 1, t);
}

double bernsteinProductIntegral(const double* a, const double* b, uint32_t order) {
  const auto binomial = [](uint32_t n, uint32_t k) {
    double value = 1.0;
    for (uint32_t i = 0; i < k; ++i) value = value * (n - i) / (i + 1);
    return value;
  };
  // int B_i^q B_k^q = C(q,i) C(q,k) / (C(2q,i+k) (2q+1))
  const uint32_t degree = order - 1;
  double sum = 0.0;
  for (uint32_t i = 0; i < order; ++i) {
    for (uint32_t k = 0; k < order; ++k) {
      sum += a[i] * b[k] * binomial(degree, i) * binomial(degree, k) / binomial(2 * degree, i + k);
    }
  }
  return sum / (2 * degree + 1);
}

BernsteinFit::BernsteinFit(uint32_t order) : order_(order) {
  const double pi = std::acos(-1.0);
  long double rows[kMaxOrder][2 * kMaxOrder] = {};  // the Vandermonde matrix beside the identity
  for (uint32_t i = 0; i < order; ++i) {
    const double chebyshev = 0.5 - 0.5 * std::cos(pi * (i + 0.5) / order);
    nodes_[i] = std::clamp(std::round(chebyshev * 64.0), 1.0, 63.0) / 64.0;
    for (uint32_t k = 0; k < order; ++k) {
      double unit[kMaxOrder] = {0.0};
      unit[k] = 1.0;
      rows[i][k] = bernsteinValue(unit, order, nodes_[i]);
    }
    rows[i][order + i] = 1.0L;
  }
  for (uint32_t column = 0; column < order; ++column) {
    uint32_t pivot = column;
    for (uint32_t i = column + 1; i < order; ++i) {
      if (std::abs(rows[i][column]) > std::abs(rows[pivot][column])) pivot = i;
    }
    std::swap(rows[column], rows[pivot]);
    const long double scale = 1.0L / rows[column][column];
    for (uint32_t k = column; k < 2 * order; ++k) rows[column][k] *= scale;
    for (uint32_t i = 0; i < order; ++i) {
      if (i == column) continue;
      const long double factor = rows[i][column];
      for (uint32_t k = column; k < 2 * order; ++k) rows[i][k] -= factor * rows[column][k];
    }
  }
  long double amplification = 0.0L;
  for (uint32_t i = 0; i < order; ++i) {
    long double sum = 0.0L;
    for (uint32_t k = 0; k < order; ++k) {
      inverse_[i][k] = rows[i][order + k];
      sum += std::abs(inverse_[i][k]);
    }
    amplification = std::max(amplification, sum);
  }
  rounding_ = std::max(1e-15, 4e-16 * static_cast<double>(amplification));
}

void BernsteinFit::solve(const double* values, double* b) const {
  for (uint32_t i = 0; i < order_; ++i) {
    long double sum = 0.0L;
    for (uint32_t k = 0; k < order_; ++k) sum += inverse_[i][k] * values[k];
    b[i] = static_cast<double>(sum);
  }
}

}  // namespace awd
