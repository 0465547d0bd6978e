// SPDX-License-Identifier: Apache-2.0
#include "density/estimators.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace awd {

namespace {

constexpr double kPaperTau = 0.1;
constexpr double kLeastTau = 0.01;
constexpr double kMostTau = 0.3;
/// The cascade has filled the empty cells already: a higher floor costs more than it insures.
constexpr double kMostTauOfCascade = 0.1;

/// Exponent of the power of two above the largest of the sums.
template <class Pick>
int largestExponent(const std::pmr::vector<Tally>& tallies, Pick&& pick) {
  int largest = std::numeric_limits<int>::min();
  for (const Tally& tally : tallies) {
    const Scaled sum = pick(tally).scaled();
    if (sum.value > 0.0) largest = std::max(largest, sum.exponent);
  }
  return largest == std::numeric_limits<int>::min() ? 0 : largest;
}

/// Numbers of the sums times 2^-exponent.
template <class Pick>
Coefficients plain(std::pmr::memory_resource* memory, const std::pmr::vector<Tally>& tallies,
                   int exponent, Pick&& pick) {
  Coefficients out(tallies.size(), 0.0, memory);
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    const Scaled sum = pick(tallies[i]).scaled();
    if (sum.value > 0.0) out[i] = std::ldexp(sum.value, sum.exponent - exponent);
  }
  return out;
}

const BinnedSum& valueOf(const Tally& tally) { return tally.value; }
const BinnedSum& weightOf(const Tally& tally) { return tally.weight; }

}  // namespace

LevelSums::LevelSums(std::pmr::memory_resource* memory, const Shape& levelShape,
                     const std::pmr::vector<Tally>& tallies)
    : shape(levelShape),
      valueExponent(largestExponent(tallies, valueOf)),
      weightExponent(largestExponent(tallies, weightOf)),
      value(plain(memory, tallies, valueExponent, valueOf)),
      weight(plain(memory, tallies, weightExponent, weightOf)),
      count(tallies.size(), 0.0, memory) {
  for (std::size_t i = 0; i < tallies.size(); ++i) count[i] = tallies[i].count();
}

LevelSums::LevelSums(const LevelSums& other)
    : shape(other.shape),
      valueExponent(other.valueExponent),
      weightExponent(other.weightExponent),
      value(other.value, other.value.get_allocator()),
      weight(other.weight, other.weight.get_allocator()),
      count(other.count, other.count.get_allocator()) {}

void LevelSums::restrict(const BasisLevel& coarse, uint32_t axis) {
  for (Coefficients* sums : {&value, &weight, &count}) {
    Shape from = shape;
    *sums = restrictAlong(coarse, axis, from, *sums);
  }
  shape.count[axis] = coarse.count;
}

Coefficients localMeans(const BasisLevel* const* levels, const LevelSums& sums,
                        AWDEstimator estimator, AWDTarget target) {
  Coefficients means(sums.value, sums.value.get_allocator());
  if (estimator == AWD_ESTIMATOR_MIXTURE) {
    overWeights(levels, sums.shape, means);
  } else {
    const Coefficients& divisors = estimator == AWD_ESTIMATOR_PAPER ? sums.count : sums.weight;
    for (std::size_t i = 0; i < means.size(); ++i) {
      means[i] = divisors[i] > 0.0 ? means[i] / divisors[i] : 0.0;
    }
  }
  if (target == AWD_TARGET_RMS) {
    for (double& mean : means) mean = std::sqrt(mean);
  }
  return means;
}

void project(const DensityBases& bases, const Levels& levels, const Shape& shape,
             Coefficients& means) {
  const BasisLevel* tables[kMaxDimensions];
  bases.tables(levels, tables);
  timesWeights(tables, shape, means);
  for (uint32_t a = 0; a < shape.dimensions; ++a) {
    solveAlong(bases.axis(a).gram(levels[a]), a, shape, means);
  }
}

double settleTau(double asked, AWDEstimator estimator, bool smooth, bool cascade, double samples,
                 double coefficients) {
  if (asked != 0.0) return std::max(asked, 0.0);
  if (estimator == AWD_ESTIMATOR_PAPER) return kPaperTau;
  if (smooth) return kLeastTau;
  return std::clamp(1.0 / (1.0 + samples / coefficients), kLeastTau,
                    cascade ? kMostTauOfCascade : kMostTau);
}

uint64_t clampCoefficients(double tau, double mean, Coefficients& coefficients) {
  const double least = tau * mean;
  uint64_t negative = 0;
  for (double& c : coefficients) {
    negative += c < 0.0;
    c = std::max(c, least);
  }
  return negative;
}

}  // namespace awd
