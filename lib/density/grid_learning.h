// SPDX-License-Identifier: Apache-2.0
// How a grid density learns: estimate on the levels that the samples bear, shrink each towards the
// one below, and go on to the level that the next pass will bear.
#pragma once

#include <optional>

#include "density/estimators.h"
#include "density/grid.h"
#include "density/learning.h"

namespace awd {

/// A grid's coefficients and what they belong to.
struct GridState {
  Levels levels;
  Coefficients coefficients;
};

/// The level on which to record a pass of so many samples: rungs above `levels`, which refine
/// every axis that can be refined, while the coefficients are bearable and allowed.
Levels levelsFor(const DensityBases& bases, const LearningSettings& settings, Levels levels,
                 uint64_t samples);

/// The next density of a grid on `levels`, not normalised; none if the samples are of no use.
std::optional<GridState> learnGrid(const DensityBases& bases, const LearningSettings& settings,
                                   const Levels& levels, const DensityStatistics& statistics,
                                   uint64_t nextSamples, LearningReport& report);

/// The same function on finer levels.
Coefficients refineTo(const DensityBases& bases, Levels from, const Levels& to,
                      const Coefficients& coefficients);

}  // namespace awd
