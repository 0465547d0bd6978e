// SPDX-License-Identifier: Apache-2.0
// From the sums of a pass to coefficients: the estimators of awd/density.h, and the floor that
// makes a density of them.
#pragma once

#include <memory_resource>
#include <vector>

#include "awd/density.h"
#include "density/bases.h"
#include "density/tally.h"
#include "density/tensor.h"

namespace awd {

/// S1, S0 and n of every coefficient as plain numbers. Powers of two are taken out of S1 and S0,
/// so that both are near 1 at most: only the shape of a density matters.
struct LevelSums {
  LevelSums(std::pmr::memory_resource* memory, const Shape& shape,
            const std::pmr::vector<Tally>& tallies);
  /// In the same memory, where vectors copied by default would be in that of the process.
  LevelSums(const LevelSums& other);
  LevelSums& operator=(const LevelSums& other) = delete;
  LevelSums(LevelSums&& other) = default;
  LevelSums& operator=(LevelSums&& other) = delete;
  ~LevelSums() = default;

  Shape shape;
  int valueExponent, weightExponent;  ///< of the powers of two
  Coefficients value, weight, count;

  /// The same along `axis` of the next coarser level: N_coarse = P^T N_fine holds at every sample.
  void restrict(const BasisLevel& coarse, uint32_t axis);
};

/// r_j, the estimated local mean of the target: S1 / S0; under `mixture` S1 / (m w_j); under
/// `paper` the mean over the samples of component j. 0 where there are none. The root is taken if
/// the target is RMS.
Coefficients localMeans(const BasisLevel* const* levels, const LevelSums& sums,
                        AWDEstimator estimator, AWDTarget target);

/// The dual: c with G c = b, b_j = w_j r_j, on all axes.
void project(const DensityBases& bases, const Levels& levels, const Shape& shape,
             Coefficients& means);

/// Whether the estimator goes by the cascade over the levels.
constexpr bool shrinks(AWDEstimator estimator) {
  return estimator == AWD_ESTIMATOR_QUASI || estimator == AWD_ESTIMATOR_REFIT;
}

/// tau as it was asked for or else for m samples and n coefficients; 0: no floor.
double settleTau(double asked, AWDEstimator estimator, bool smooth, bool cascade, double samples,
                 double coefficients);

/// Raises coefficients below tau times `mean` to it, negative ones to 0 at least. Returns how many
/// were negative.
uint64_t clampCoefficients(double tau, double mean, Coefficients& coefficients);

}  // namespace awd
