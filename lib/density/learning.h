// SPDX-License-Identifier: Apache-2.0
// What adapting needs to know, and what it made of a pass; the same for grids and trees.
#pragma once

#include "awd/density.h"
#include "density/bases.h"
#include "density/refit.h"

namespace awd {

/// The settings of a density with every default settled but those that go by the samples.
struct LearningSettings {
  AWDEstimator estimator = AWD_ESTIMATOR_DEFAULT;
  AWDTarget target = AWD_TARGET_MEAN;
  double tau = 0.0;             ///< 0: by samples; negative: none
  double shrinkage = 0.0;       ///< kappa, 0: no cascade
  double refitShrinkage = 0.0;  ///< kappa of lambda, negative: by the noise
  Refitter refitter;            ///< of the estimator refit
  uint64_t refitBytes = 0;      ///< that its sums may take
  Levels minLevel{};            ///< that it never goes below; in a tree: least halvings
  Levels maxLevel{};
  uint64_t maxCoefficients = 0;
};

/// How a pass's samples became the next density.
struct LearningReport {
  uint64_t negative = 0;
  uint64_t coarsened = 0;
  uint64_t split = 0;
  double tau = 0.0;
  AWDEstimator estimator = AWD_ESTIMATOR_DEFAULT;
  uint32_t estimatedLevels = 0;
  RefitReport refit;
};

/// Coefficients n that `samples` can bear.
constexpr uint64_t bearable(uint64_t samples) {
  return samples > UINT64_MAX / 2 ? UINT64_MAX : 2 * samples;
}

}  // namespace awd
