// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "basis/checks.h"
#include "basis/quadrature.h"

namespace awd {

namespace {

/// The functions of level 0 and the wavelets at the quadrature points of level 1, times the roots
/// of the weights: scalar products of such rows are integrals of products.
class Sampled {
 public:
  explicit Sampled(const AWDBasisFamily& family)
      : cell_(family, 0), halves_(family, 1), size_(std::size_t{halves_.cells} * kMaxOrder) {
    const GaussRule gauss;
    for (uint32_t c = 0; c < halves_.cells; ++c) {
      for (uint32_t g = 0; g < kMaxOrder; ++g) {
        points_.push_back((c + gauss.points[g]) / halves_.cells);
        roots_.push_back(std::sqrt(gauss.weights[g] / halves_.cells));
      }
    }
  }

  std::vector<double> function(uint32_t j) const {
    return row([&](double x) { return evaluate(cell_, x).of(j); });
  }
  std::vector<double> wavelet(uint32_t k) const {
    double g[2 * kMaxOrder];
    readWavelet(*cell_.table, k, halves_.count, g);
    return row([&](double x) {
      const Row<kMaxOrder> alive = evaluate(halves_, x);
      double sum = 0.0;
      for (uint32_t i = 0; i < alive.size; ++i) sum += g[alive.functions[i]] * alive.values[i];
      return sum;
    });
  }
  std::vector<double> power(uint32_t i) const {
    return row([&](double x) { return std::pow(x, i); });
  }

 private:
  template <class Function>
  std::vector<double> row(const Function& function) const {
    std::vector<double> values(size_);
    for (std::size_t p = 0; p < size_; ++p) values[p] = roots_[p] * function(points_[p]);
    return values;
  }

  TableLevel cell_, halves_;
  std::size_t size_;
  std::vector<double> points_, roots_;
};

double product(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Scales a row to 1; false if there is nothing to scale.
bool normalise(std::vector<double>& row) {
  const double norm = std::sqrt(product(row, row));
  if (!(norm > 0.0)) return false;
  for (double& value : row) value /= norm;
  return true;
}

}  // namespace

void checkTreeSizes(const AWDBasisFamily& family, Check& check) {
  if ((family.minLevel != 0 || family.maxLevel < 1) && check.fails(1.0)) {
    check.say("flag NESTED: levels %u to %u: they must be 0 to at least 1", family.minLevel,
              family.maxLevel);
  }
  if (!check.ok()) return;
  const TableLevel zero(family, 0);
  if (zero.count > kMaxOrder && check.fails(1.0)) {
    check.say("flag NESTED: level 0 has %u functions: it may have 1 to %u", zero.count, kMaxOrder);
  }
  for (uint32_t l = 1; l <= family.maxLevel; ++l) {
    const TableLevel level(family, l);
    const unsigned long long copies = 1ull << l, count = zero.count * copies,
                             cells = zero.cells * copies;
    if (level.count != count && check.fails(1.0)) {
      check.say(
          "flag NESTED is not true: level %u has %u functions, want those of %llu copies of level "
          "0, %llu",
          l, level.count, copies, count);
    }
    if (level.cells != cells && check.fails(1.0)) {
      check.say(
          "flag NESTED is not true: level %u has %u cells, want those of %llu copies of level 0, "
          "%llu",
          l, level.cells, copies, cells);
    }
  }
}

void checkCopies(const TestedLevel& level, Check& check) {
  const TableLevel zero(*level.table, 0);
  const uint32_t copies = level.count / zero.count;
  for (const uint32_t copy : spread(copies, 64)) {
    for (uint32_t p = 0; p < 3 * zero.cells; ++p) {
      const double t = (p + 0.41) / (3 * zero.cells), x = (copy + t) / copies;
      const Row<kMaxOrder> here = evaluate(level, x), there = evaluate(zero, t);
      for (uint32_t k = 0; k < zero.count; ++k) {
        const double got = here.of(copy * zero.count + k), want = there.of(k);
        if (check.fails(std::abs(got - want) / (1.0 + 1e-3 * level.cells))) {
          check.say(
              "flag NESTED is not true: level %u, function %u, x = %.17g: got %.12g, but function "
              "%u of level 0 is %.12g there",
              level.level, copy * zero.count + k, x, got, k, want);
        }
      }
    }
  }
}

void checkVanishingMoments(const AWDBasisFamily& family, Check& check) {
  const Sampled sampled(family);
  for (uint32_t k = 0; k < family.count(0); ++k) {
    std::vector<double> wavelet = sampled.wavelet(k);
    if (!normalise(wavelet)) continue;  // the next check says so
    for (uint32_t i = 0; i < family.vanishingMoments; ++i) {
      const double moment = product(wavelet, sampled.power(i));
      if (check.fails(std::abs(moment))) {
        if (i == 0) {
          check.say("wavelet %u carries mass: its integral is %.6g of its norm, want 0", k, moment);
        } else {
          check.say(
              "wavelet %u has not the %u vanishing moments claimed: int x^%u psi is %.6g of its "
              "norm, want 0",
              k, family.vanishingMoments, i, moment);
        }
      }
    }
  }
}

void checkWavelets(const AWDBasisFamily& family, Check& check) {
  // Gram and Schmidt: what is left of a wavelet beside level 0 and the wavelets before it?
  const Sampled sampled(family);
  const uint32_t n = family.count(0);
  std::vector<std::vector<double>> before;
  for (uint32_t i = 0; i < 2 * n; ++i) {
    std::vector<double> row = i < n ? sampled.function(i) : sampled.wavelet(i - n);
    double rest = 0.0;
    if (normalise(row)) {
      for (int pass = 0; pass < 2; ++pass) {
        for (const std::vector<double>& other : before) {
          const double along = product(row, other);
          for (std::size_t p = 0; p < row.size(); ++p) row[p] -= along * other[p];
        }
      }
      rest = product(row, row);
    }
    if (i >= n && check.fails(rest > 0.0 ? 1.0 / rest : INFINITY)) {
      check.say(
          "wavelets do not determine level 1: wavelet %u is a combination of level 0 and the "
          "wavelets before it (squared distance %.3g of 1)",
          i - n, rest);
    }
    if (normalise(row)) before.push_back(std::move(row));
  }
}

}  // namespace awd
