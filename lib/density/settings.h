// SPDX-License-Identifier: Apache-2.0
// A density's description with every default settled.
#pragma once

#include "awd/density.h"
#include "density/learning.h"

namespace awd {

/// Of a box, along an axis.
constexpr uint32_t kMostHalvings = 30;

struct DensitySettings {
  uint32_t dimensions = 0;
  AWDDensityStructure structure = AWD_STRUCTURE_GRID;
  AWDSampler sampler = AWD_SAMPLER_INVERSE_CDF;
  AWDCombination combination = AWD_COMBINE_COUNT;
  LearningSettings learning;
  uint64_t passSamples = 0;
  Levels startLevel{};  ///< of a grid; in a tree how often boxes are halved at first
  bool fixedStart[kMaxDimensions] = {};  ///< whether the host said so
};

/// The name of the family that axes without one get.
const char* defaultBasis(AWDDensityStructure structure);

/// Checks and settles what `desc` says, given the families of its axes. desc.axes may be null.
DensitySettings settle(const AWDDensityDesc& desc, const AWDBasisFamily* const* families);

/// Settles how far the estimators are shrunk, as AWDDensityDesc::shrinkage has it. constant: all
/// functions are piecewise constant.
void settleShrinkage(double asked, bool constant, LearningSettings& learning);

/// The tables that such a density needs, not more.
Ref<DensityBases> compileBases(std::pmr::memory_resource* memory, const DensitySettings& settings,
                               const AWDBasisFamily* const* families);

}  // namespace awd
