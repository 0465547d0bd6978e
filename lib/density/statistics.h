// SPDX-License-Identifier: Apache-2.0
// What a density learns during a pass: sums over its samples, the same in whatever order they come
// and however they are split among threads and machines.
#pragma once

#include <cmath>
#include <memory_resource>
#include <vector>

#include "awd/density.h"
#include "density/normal_pattern.h"
#include "density/tally.h"

namespace awd {

/// A sample as it goes into the sums: |f| or f^2, and 1/p, each with an exponent of its own so that
/// no product leaves the range of a double.
struct WeighedSample {
  Scaled target;   ///< |f|, or f^2 if the target is RMS; 0 if f was rejected
  Scaled inverse;  ///< 1/p
  Scaled ratio;    ///< f/p, with its sign

  /// f is finite, p positive and finite.
  WeighedSample(double f, double p, AWDTarget aim) : target(splitExponent(std::abs(f))) {
    const Scaled density = splitExponent(p);
    inverse = {1.0 / density.value, -density.exponent};
    ratio = {std::copysign(target.value, f) * inverse.value, target.exponent + inverse.exponent};
    if (aim == AWD_TARGET_RMS) target = {target.value * target.value, 2 * target.exponent};
  }
};

/// What a tree asks of a box to decide whether and where to halve it: sums over its lower half
/// along an axis, or over all of it.
struct BoxTally {
  BinnedSum weight;  ///< 1/p
  BinnedSum value;   ///< |f|/p, or f^2/p if the target is RMS
  BinnedSum square;  ///< its square by p

  void add(const WeighedSample& sample);
  void add(const BoxTally& other);
};

/// The sums that the integral is estimated from.
struct PassSums {
  explicit PassSums(std::pmr::memory_resource* memory) : cross(memory) {}

  uint64_t samples = 0;
  uint64_t rejected = 0;
  BinnedSum mean;                     ///< f/p
  BinnedSum square;                   ///< (f/p)^2
  std::pmr::vector<BinnedSum> cross;  ///< f^2 / (p_k p) for each earlier pass k that is kept

  void add(const WeighedSample& sample) {
    ++samples;
    mean.add(sample.ratio.value, sample.ratio.exponent);
    // Squares are kept to twice the digits: the variance is a small difference of large sums.
    const double high = sample.ratio.value * sample.ratio.value;
    square.add(high, 2 * sample.ratio.exponent);
    square.add(std::fma(sample.ratio.value, sample.ratio.value, -high), 2 * sample.ratio.exponent);
  }
  /// Samples of values f drawn from p, of which the earlier pass k would have drawn with `theirs`.
  void addCross(std::size_t k, std::size_t count, const double* f, const double* p,
                const double* theirs);
  void add(const PassSums& other);
};

/// What the estimator `refit` wants to know beside S1 and S0.
struct NormalSums {
  /// blocks: 1 for a grid, the leaves of a tree. No pattern: nothing is summed.
  NormalSums(std::pmr::memory_resource* memory, Ref<NormalPattern> which, std::size_t blocks)
      : pattern(std::move(which)), products(pattern ? blocks * pattern->size() : 0, memory) {}

  /// A sample at x, a place of that block.
  template <uint32_t D>
  void add(std::size_t block, const double* x, const AxisValues* at, const WeighedSample& sample) {
    const double inverse = sample.inverse.value;
    energy.add(sample.target.value * sample.target.value * inverse,
               2 * sample.target.exponent + sample.inverse.exponent);
    BinnedSum* sums = &products[block * pattern->size()];
    pattern->forEachAlive<D>(x, at, [&](std::size_t entry, double product) {
      sums[entry].add(product * inverse, sample.inverse.exponent);
    });
  }

  Ref<NormalPattern> pattern;
  std::pmr::vector<BinnedSum> products;  ///< A_jk, block by block
  BinnedSum energy;                      ///< sum f^2 / p, f the target
};

class DensityStatistics {
 public:
  /// boxTallies: 0 for a grid.
  DensityStatistics(std::pmr::memory_resource* memory, std::size_t coefficients,
                    std::size_t boxTallies, std::size_t earlierPasses,
                    Ref<NormalPattern> pattern = {}, std::size_t blocks = 1);

  PassSums sums;
  std::pmr::vector<Tally> tallies;   ///< one a coefficient
  std::pmr::vector<BoxTally> boxes;  ///< tree: d + 1 a leaf, the lower halves and then the whole
  NormalSums normal;

  /// Fails with AWD_ERROR_INVALID_OPERATION if so many more can't be summed.
  void needRoomFor(uint64_t samples) const;
  /// Of the same sizes.
  void add(const DensityStatistics& other);
  bool sameSizes(const DensityStatistics& other) const;
  std::size_t bytes() const;
};

}  // namespace awd
