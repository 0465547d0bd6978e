// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "basis/checks.h"

namespace awd {

namespace {

constexpr double kLastUniform = 1.0 - 0x1p-53;
/// Kolmogorov-Smirnov: how many samples of how many functions of a level.
constexpr uint32_t kEvenSamples = 512, kRandomSamples = 4096;
constexpr uint32_t kSampledFunctions = 8;

/// Fixed points: evenly spaced for samplers of one uniform, else pseudo-random.
uint32_t samplesOf(const TableLevel& level) {
  return level.table->sampleDims == 1 ? kEvenSamples : kRandomSamples;
}

/// The distance allowed. Random: sqrt(ln(2 / 1e-9) / (2 n)), which an honest sampler exceeds with
/// probability below 1e-9 (Dvoretzky, Kiefer, Wolfowitz; Massart). Evenly spaced: an honest sampler
/// stays below (m + 1) / n if it is monotone in m pieces; 20 are allowed.
double allowedOf(const TableLevel& level) {
  return level.table->sampleDims == 1 ? 21.0 / kEvenSamples
                                      : std::sqrt(std::log(2.0 / 1e-9) / (2.0 * kRandomSamples));
}

using Uniforms = std::array<double, kMaxOrder>;

class Points {
 public:
  explicit Points(uint32_t dimensions) : dimensions_(dimensions) {}

  Uniforms next() {
    Uniforms u{};
    if (dimensions_ == 1) {
      u[0] = (index_++ + 0.5) / kEvenSamples;
    } else {
      for (uint32_t i = 0; i < dimensions_; ++i) u[i] = random();
    }
    return u;
  }

 private:
  double random() {  // splitmix64
    uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
  }

  uint32_t dimensions_;
  uint32_t index_ = 0;
  uint64_t state_ = 19990621;
};

/// Place of x in the support of a function, from its begin on, in cells.
double placeIn(const TableLevel& level, const CellRange& range, double x) {
  double place = x * level.cells - range.first;
  if (level.periodic() && place < -1e-6) place += level.cells;
  return place;
}

/// The exact distribution function of N_j / w_j.
class Distribution {
 public:
  Distribution(const TableLevel& level, uint32_t j, const CellRange& range)
      : order_(level.table->order) {
    const BernsteinFit fit(order_);
    double mass = 0.0;
    for (uint32_t i = 0; i < range.size; ++i) {
      const CellPieces cell = fitCell(level, (range.first + i) % level.cells, fit);
      Piece piece = {mass, {}};
      if (const double* b = cell.of(j)) std::copy(b, b + order_, piece.b);
      mass += bernsteinIntegral(piece.b, order_, 1.0);
      pieces_.push_back(piece);
    }
    whole_ = mass;
  }

  double operator()(double place) const {
    if (!(place >= 0.0)) place = 0.0;  // NaN too
    const auto last = static_cast<double>(pieces_.size() - 1);
    const double cell = std::clamp(std::floor(place), 0.0, last);
    const Piece& piece = pieces_[static_cast<std::size_t>(cell)];
    const double t = std::clamp(place - cell, 0.0, 1.0);
    return (piece.before + bernsteinIntegral(piece.b, order_, t)) / whole_;
  }

 private:
  struct Piece {
    double before;
    double b[kMaxOrder];
  };
  uint32_t order_;
  std::vector<Piece> pieces_;
  double whole_;
};

}  // namespace

void checkSamples(const TestedLevel& level, Check& check) {
  const uint32_t dimensions = level.table->sampleDims;
  for (const uint32_t j : level.someFunctions) {
    const CellRange range = supportCells(level, j);
    const auto take = [&](const Uniforms& u) {
      const double x = level.table->sample(level.level, j, u.data());
      const double again = level.table->sample(level.level, j, u.data());
      const bool same = x == again || (std::isnan(x) && std::isnan(again));
      if (!same && check.fails(NAN)) {
        check.say("sampler is not repeatable: level %u, function %u: got %.17g, then %.17g",
                  level.level, j, x, again);
      }
      // How far outside, in cells.
      const double place = placeIn(level, range, x);
      const double outside = x >= 0.0 && x <= 1.0 ? std::max(-place, place - range.size) : NAN;
      if (check.fails(outside)) {
        check.say(
            "sample lies outside the support: level %u, function %u, u[0] = %g: got %.12g, want "
            "%.12g to %.12g",
            level.level, j, u[0], x, static_cast<double>(range.first) / level.cells,
            (static_cast<double>(range.first) + range.size) / level.cells);
      }
    };
    Uniforms u{};
    for (uint32_t corner = 0; corner < 1u << dimensions; ++corner) {
      for (uint32_t i = 0; i < dimensions; ++i) u[i] = corner >> i & 1u ? kLastUniform : 0.0;
      take(u);
    }
    Points points(dimensions);
    for (uint32_t i = 0; i < 64; ++i) take(points.next());
  }
}

void checkDistribution(const TestedLevel& level, Check& check) {
  for (const uint32_t i :
       spread(static_cast<uint32_t>(level.someFunctions.size()), kSampledFunctions)) {
    const uint32_t j = level.someFunctions[i];
    const CellRange range = supportCells(level, j);
    if (range.size > kWhole) continue;
    const Distribution distribution(level, j, range);
    // The distribution function of the samples on a grid of equal probabilities.
    constexpr uint32_t kBins = 512;
    const uint32_t samples = samplesOf(level);
    std::array<uint32_t, kBins> bins{};
    Points points(level.table->sampleDims);
    for (uint32_t s = 0; s < samples; ++s) {
      const double x = level.table->sample(level.level, j, points.next().data());
      const double f = std::min(distribution(placeIn(level, range, x)), 1.0);
      ++bins[f >= 0.0 ? std::min<uint32_t>(static_cast<uint32_t>(f * kBins), kBins - 1) : 0];
    }
    uint32_t sum = 0;
    for (uint32_t b = 0; b + 1 < kBins; ++b) {
      sum += bins[b];
      const double got = static_cast<double>(sum) / samples, want = (b + 1.0) / kBins;
      if (check.fails(std::abs(got - want) / allowedOf(level))) {
        check.say(
            "sampler does not follow the function: level %u, function %u: a share of %.4g of the "
            "samples lies where %.4g of the mass does",
            level.level, j, got, want);
      }
    }
  }
}

}  // namespace awd
