// SPDX-License-Identifier: Apache-2.0
// A field's description with every default settled.
#pragma once

#include <limits>

#include "awd/field.h"
#include "density/learning.h"
#include "guide/light_choice.h"
#include "util/vec.h"

namespace awd {

struct FieldSettings {
  AWDPreset preset = AWD_PRESET_DEFAULT;
  AWDHemisphereMap map = AWD_MAP_DEFAULT;
  uint32_t startLevel = 0;
  uint32_t maxLevel = 0;
  LearningSettings learning;  ///< estimator, tau, shrinkage and solver
  double alpha = 0.0;         ///< share of the constant density in every other
  AWDPatches patches = AWD_PATCHES_HOST;
  Vec3f lower, upper;         ///< of spatial patches
  uint32_t patchSamples = 0;  ///< beyond which a spatial patch is split
  uint64_t maxBytes = std::numeric_limits<uint64_t>::max();
  AWDTarget target = AWD_TARGET_MEAN;
  Ref<LightChoice> lights;  ///< how patches begin to choose among them; null: they don't

  /// Whether a patch adds what a pass has taught to what it knew, as far as the estimate of its
  /// function can be had back from its density.
  bool pools() const { return learning.estimator == AWD_ESTIMATOR_LUMPED; }
  AWDSampler sampler() const {
    return learning.estimator == AWD_ESTIMATOR_PAPER ? AWD_SAMPLER_COMPONENT
                                                     : AWD_SAMPLER_INVERSE_CDF;
  }
};

/// The name of the family of a field that names none.
const char* defaultFieldBasis(AWDPreset preset);

/// The finest level that fields with this basis may have.
uint32_t finestFieldLevel(const AWDBasisFamily& family);

/// Settles what `desc` leaves open, within the levels that the family has. AWD_ERROR_... for what
/// can't be.
FieldSettings settle(std::pmr::memory_resource* memory, const AWDFieldDesc& desc,
                     const AWDBasisFamily& family);

/// The first in which they differ, as in "its map", but for maxBytes, which renders lower; null:
/// they don't.
const char* differenceOf(const FieldSettings& a, const FieldSettings& b);

}  // namespace awd
