// SPDX-License-Identifier: Apache-2.0
// Problems such as the library makes: normal equations of random samples in tensor products of
// clamped B-splines or of Bernstein polynomials on cells, pulled towards the quasi coefficients.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <vector>

#include "refit/refit_module.h"

namespace awd {

struct TestProblem {
  std::vector<uint64_t> rowBegin;
  std::vector<uint32_t> columns;
  std::vector<double> values, rhs, lower, start;

  std::size_t size() const { return rhs.size(); }

  AWDRefitProblem view() const {
    return {sizeof(AWDRefitProblem),
            rhs.size(),
            rowBegin.data(),
            columns.data(),
            values.data(),
            rhs.data(),
            lower.data(),
            start.data(),
            nullptr,
            nullptr};
  }

  double& at(uint32_t j, uint32_t k) {
    const auto begin = columns.begin() + rowBegin[j], end = columns.begin() + rowBegin[j + 1];
    return values[std::lower_bound(begin, end, k) - columns.begin()];
  }

  /// Q(c), summed in long double.
  long double objective(const std::vector<double>& c) const {
    long double sum = 0.0L;
    for (std::size_t j = 0; j < size(); ++j) {
      long double row = 0.0L;
      for (uint64_t i = rowBegin[j]; i < rowBegin[j + 1]; ++i) {
        row += static_cast<long double>(values[i]) * c[columns[i]];
      }
      sum += c[j] * (row / 2 - rhs[j]);
    }
    return sum;
  }

  /// The same problem in the unknowns c_j / factor_j.
  void rescale(const std::vector<double>& factor) {
    for (std::size_t j = 0; j < size(); ++j) {
      for (uint64_t i = rowBegin[j]; i < rowBegin[j + 1]; ++i) {
        values[i] *= factor[j] * factor[columns[i]];
      }
      rhs[j] *= factor[j];
      lower[j] /= factor[j];
      start[j] /= factor[j];
    }
  }
};

/// From the entries of A, both halves.
inline TestProblem testProblem(uint32_t n, const std::map<std::pair<uint32_t, uint32_t>, double>& a,
                               std::vector<double> rhs, std::vector<double> lower) {
  TestProblem p;
  p.rowBegin.assign(n + 1, 0);
  for (const auto& [at, value] : a) {
    ++p.rowBegin[at.first + 1];
    p.columns.push_back(at.second);
    p.values.push_back(value);
  }
  for (uint32_t j = 0; j < n; ++j) p.rowBegin[j + 1] += p.rowBegin[j];
  p.rhs = std::move(rhs);
  p.lower = std::move(lower);
  p.start = p.lower;
  return p;
}

struct Recipe {
  bool spline = true;  ///< clamped B-splines; else Bernstein polynomials on each cell
  uint32_t order = 2;
  uint32_t cells = 8;  ///< per axis
  uint32_t dimensions = 1;
  uint32_t samples = 1000;
  double lambda = 0x1p-10;
  double floor = 0.01;    ///< of the bounds, relative to the mean
  double occupied = 1.0;  ///< samples fall in [0, occupied]^d only
  double noise = 0.5;     ///< of f, relative
  double decades = 0.0;   ///< that the samples' weights span
  uint64_t seed = 1;
};

/// First function alive at x, and the values of `order` of them.
inline uint32_t valuesAt(const Recipe& r, double x, double* v) {
  const uint32_t cell = std::min(static_cast<uint32_t>(x * r.cells), r.cells - 1);
  std::fill_n(v, r.order, 0.0);
  v[0] = 1.0;
  const double t = x * r.cells - cell;
  const auto knot = [&](int i) { return std::clamp<double>(i, 0, r.cells); };
  for (uint32_t q = 1; q < r.order; ++q) {  // Cox and de Boor; de Casteljau
    double left = 0.0;
    for (uint32_t i = 0; i < q; ++i) {
      const int c = static_cast<int>(cell + i) - static_cast<int>(q) + 1;
      const double a =
          r.spline ? (x * r.cells - knot(c)) / (knot(c + static_cast<int>(q)) - knot(c)) : t;
      const double value = v[i];
      v[i] = left + (1.0 - a) * value;
      left = a * value;
    }
    v[q] = left;
  }
  return r.spline ? cell : cell * r.order;
}

inline TestProblem gramProblem(const Recipe& r) {
  const uint32_t perAxis = r.spline ? r.cells + r.order - 1 : r.cells * r.order;
  uint32_t n = 1;
  for (uint32_t a = 0; a < r.dimensions; ++a) n *= perAxis;
  std::vector<double> s0(n, 0.0), s1(n, 0.0);
  std::vector<uint32_t> alive;
  std::vector<double> value;
  std::vector<std::vector<double>> rows(n);  // dense over the window of a row's neighbours
  const uint32_t reach = 2 * r.order - 1;    // columns per axis from perAxis index - order + 1 on
  uint32_t window = 1;
  for (uint32_t a = 0; a < r.dimensions; ++a) window *= reach;
  std::mt19937_64 random(r.seed);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  double total = 0.0, mean = 0.0;

  // Offsets of k from j, per axis, as an index into the window.
  std::vector<std::vector<uint32_t>> digits;
  for (uint32_t i = 0; i < r.samples; ++i) {
    double f = 1.0;
    alive.assign(1, 0);
    value.assign(1, 1.0);
    digits.assign(1, {});
    for (uint32_t a = 0; a < r.dimensions; ++a) {
      const double x = uniform() * r.occupied;
      f *= std::exp(-(30.0 / r.dimensions) * (x - 0.4) * (x - 0.4));
      double v[8];
      const uint32_t first = valuesAt(r, x, v);
      std::vector<uint32_t> nextAlive;
      std::vector<double> nextValue;
      std::vector<std::vector<uint32_t>> nextDigits;
      for (std::size_t s = 0; s < alive.size(); ++s) {
        for (uint32_t e = 0; e < r.order; ++e) {
          nextAlive.push_back(alive[s] * perAxis + first + e);
          nextValue.push_back(value[s] * v[e]);
          nextDigits.push_back(digits[s]);
          nextDigits.back().push_back(e);
        }
      }
      alive = nextAlive;
      value = nextValue;
      digits = nextDigits;
    }
    f *= 1.0 + r.noise * (2.0 * uniform() - 1.0);
    const double weight = std::pow(10.0, r.decades * (uniform() - 0.5));
    total += weight;
    mean += weight * f;
    for (std::size_t s = 0; s < alive.size(); ++s) {
      s0[alive[s]] += weight * value[s];
      s1[alive[s]] += weight * f * value[s];
      std::vector<double>& row = rows[alive[s]];
      if (row.empty()) row.assign(window, 0.0);
      for (std::size_t u = 0; u < alive.size(); ++u) {
        uint32_t at = 0;
        for (uint32_t a = 0; a < r.dimensions; ++a) {
          at = at * reach + digits[u][a] + r.order - 1 - digits[s][a];
        }
        row[at] += weight * (value[s] * value[u]);
      }
    }
  }

  TestProblem p;
  p.rowBegin.push_back(0);
  std::vector<uint32_t> index(r.dimensions);
  for (uint32_t j = 0; j < n; ++j) {
    double w = 1.0;
    for (uint32_t a = r.dimensions, rest = j; a-- > 0; rest /= perAxis) {
      index[a] = rest % perAxis;
      const double i = index[a];
      w *= (r.spline ? (std::min(i + 1.0, static_cast<double>(r.cells)) -
                        std::max(i + 1.0 - r.order, 0.0)) /
                           r.order
                     : 1.0 / r.order) /
           r.cells;
    }
    const double pull = r.lambda * total * w;
    const double quasi = s0[j] > 0.0 ? s1[j] / s0[j] : mean / total;
    for (uint32_t at = 0; at < window; ++at) {
      uint32_t k = 0, rest = at, scale = window;
      bool inside = true;
      for (uint32_t a = 0; a < r.dimensions; ++a) {
        scale /= reach;
        const int i = static_cast<int>(index[a] + rest / scale) - static_cast<int>(r.order) + 1;
        rest %= scale;
        inside = inside && i >= 0 && i < static_cast<int>(perAxis);
        k = k * perAxis + static_cast<uint32_t>(i);
      }
      if (!inside) continue;
      const double entry = (rows[j].empty() ? 0.0 : rows[j][at]) + (k == j ? pull : 0.0);
      if (!r.spline && entry == 0.0) continue;  // of another cell
      p.columns.push_back(k);
      p.values.push_back(entry);
    }
    p.rowBegin.push_back(p.columns.size());
    p.rhs.push_back(s1[j] + pull * quasi);
    p.lower.push_back(r.floor * mean / total);
    p.start.push_back(std::max(quasi, p.lower.back()));
  }
  return p;
}

}  // namespace awd
