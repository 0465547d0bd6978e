// SPDX-License-Identifier: Apache-2.0
// How a tree density learns: estimate top down, each box shrunk towards the one that holds it; drop
// what is below its standard error; halve the boxes where the density is furthest from what it
// could be.
#pragma once

#include <optional>

#include "density/learning.h"
#include "density/tree_density.h"

namespace awd {

/// The next density of a tree, not normalised; none if the samples are of no use.
std::optional<TreeState> learnTree(const DensityBases& bases, const LearningSettings& settings,
                                   const TreeDensity& density, const DensityStatistics& statistics,
                                   uint64_t nextSamples, LearningReport& report);

}  // namespace awd
