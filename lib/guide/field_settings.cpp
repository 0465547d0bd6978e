// SPDX-License-Identifier: Apache-2.0
#include "guide/field_settings.h"

#include <algorithm>
#include <cmath>

#include "density/settings.h"
#include "util/error.h"

namespace awd {

namespace {

// The paper's settings, and ours where they differ.
constexpr uint32_t kPaperStartLevel = 2;
constexpr uint32_t kPaperMaxLevel = 4;
constexpr double kPaperTau = 0.05;
constexpr uint32_t kDefaultStartLevel = 3;
constexpr uint32_t kDefaultMaxLevel = 4;
constexpr double kDefaultTau = 0.3;  ///< of the estimators that know no alpha
constexpr double kDefaultAlpha = 0.1;
constexpr uint32_t kDefaultPatchSamples = 2000;
/// A density of a level has some 4^level coefficients: beyond this one they don't fit anywhere.
constexpr uint32_t kFinestLevel = 12;

uint32_t settleLevel(uint32_t asked, const char* name, uint32_t preset,
                     const AWDBasisFamily& family) {
  const uint32_t finest = finestFieldLevel(family);
  if (asked == 0) return std::clamp(preset, family.minLevel, finest);
  const uint32_t level = asked - 1;
  if (level < family.minLevel || level > finest) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "%s is level %u: fields with basis \"%s\" have levels %u to %u", name, level, family.name,
         family.minLevel, finest);
  }
  return level;
}

void check(int32_t value, int32_t most, const char* name) {
  if (value < 0 || value > most) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s is %d: 0 to %d are known", name, value, most);
  }
}

void settleLevels(const AWDFieldDesc& desc, const AWDBasisFamily& family, FieldSettings& settings) {
  const bool paper = desc.preset == AWD_PRESET_PAPER;
  settings.maxLevel = settleLevel(desc.maxLevel, "desc->maxLevel",
                                  paper ? kPaperMaxLevel : kDefaultMaxLevel, family);
  settings.startLevel = settleLevel(desc.startLevel, "desc->startLevel",
                                    paper ? kPaperStartLevel : kDefaultStartLevel, family);
  if (settings.startLevel <= settings.maxLevel) return;
  // An explicit bound at one end moves the preset's value at the other.
  if (desc.startLevel && desc.maxLevel) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->startLevel is level %u, above desc->maxLevel, %u",
         settings.startLevel, settings.maxLevel);
  }
  (desc.startLevel ? settings.maxLevel : settings.startLevel) =
      desc.startLevel ? settings.startLevel : settings.maxLevel;
}

/// Spatial patches want a box; without one, and none asked for, patches are the host's.
void settlePatches(const AWDFieldDesc& desc, FieldSettings& settings) {
  settings.lower = load(desc.lower);
  settings.upper = load(desc.upper);
  const Vec3f size = settings.upper - settings.lower;
  const bool boxed = isFinite(size) && size.x >= 0.0f && size.y >= 0.0f && size.z >= 0.0f &&
                     maxComponent(size) > 0.0f;
  const bool empty = size == Vec3f{} && settings.lower == Vec3f{};
  if (!boxed && !empty) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->lower is (%g, %g, %g) and desc->upper (%g, %g, %g): they must be finite, and upper "
         "nowhere below lower and above it somewhere",
         settings.lower.x, settings.lower.y, settings.lower.z, settings.upper.x, settings.upper.y,
         settings.upper.z);
  }
  settings.patches = desc.patches                      ? desc.patches
                     : desc.preset == AWD_PRESET_PAPER ? AWD_PATCHES_HOST
                     : boxed                           ? AWD_PATCHES_SPATIAL
                                                       : AWD_PATCHES_HOST;
  if (settings.patches == AWD_PATCHES_SPATIAL && !boxed) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->patches is AWD_PATCHES_SPATIAL: give desc->lower and desc->upper, a box around the "
         "scene");
  }
  settings.patchSamples = desc.patchSamples ? desc.patchSamples : kDefaultPatchSamples;
  if (desc.maxBytes) settings.maxBytes = desc.maxBytes;
}

/// The prior; by equal powers where none are given.
Ref<LightChoice> settleLights(std::pmr::memory_resource* memory, const AWDFieldDesc& desc) {
  if (desc.lightCount == 0) return {};
  if (desc.lightCount > AWD_MOST_FIELD_LIGHTS) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->lightCount is %u: a field tells at most %d apart; give groups of lights",
         desc.lightCount, AWD_MOST_FIELD_LIGHTS);
  }
  const std::pmr::vector<float> equal(desc.lightPowers ? 0 : desc.lightCount, 1.0f, memory);
  const float* powers = desc.lightPowers ? desc.lightPowers : equal.data();
  double sum = 0.0;
  for (uint32_t i = 0; i < desc.lightCount; ++i) {
    if (!(powers[i] >= 0.0f && std::isfinite(powers[i]))) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->lightPowers[%u] is %g: powers must be finite and not negative", i, powers[i]);
    }
    sum += static_cast<double>(powers[i]);
  }
  if (!(sum > 0.0)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->lightPowers are all 0: one must be positive");
  }
  return LightChoice::make(memory, powers, desc.lightCount);
}

}  // namespace

uint32_t finestFieldLevel(const AWDBasisFamily& family) {
  return std::min(family.maxLevel, std::max(family.minLevel, kFinestLevel));
}

const char* defaultFieldBasis(AWDPreset preset) {
  return preset == AWD_PRESET_PAPER ? "haar" : "linear-bspline";
}

FieldSettings settle(std::pmr::memory_resource* memory, const AWDFieldDesc& desc,
                     const AWDBasisFamily& family) {
  check(desc.preset, AWD_PRESET_PAPER, "preset");
  check(desc.map, AWD_MAP_COSINE, "map");
  check(desc.patches, AWD_PATCHES_HOST, "patches");
  check(desc.estimator, AWD_ESTIMATOR_LUMPED, "estimator");
  check(desc.target, AWD_TARGET_RMS, "target");
  if (!(desc.tau <= 1.0)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->tau is %g: at most 1 is allowed", desc.tau);
  }
  if (!(desc.alpha <= 1.0)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->alpha is %g: at most 1 is allowed", desc.alpha);
  }
  const bool paper = desc.preset == AWD_PRESET_PAPER;
  FieldSettings settings;
  settings.preset = desc.preset;
  settings.map = desc.map ? desc.map : paper ? AWD_MAP_SPHERICAL : AWD_MAP_CONCENTRIC_COSINE;
  settleLevels(desc, family, settings);
  settlePatches(desc, settings);
  LearningSettings& learning = settings.learning;
  learning.estimator = desc.estimator ? desc.estimator
                       : paper        ? AWD_ESTIMATOR_PAPER
                                      : AWD_ESTIMATOR_LUMPED;
  // Lumped coefficients are never negative: alpha is all the floor that they need.
  const bool lumped = learning.estimator == AWD_ESTIMATOR_LUMPED;
  learning.tau = desc.tau != 0.0 ? desc.tau : paper ? kPaperTau : lumped ? -1.0 : kDefaultTau;
  const double alpha = desc.alpha != 0.0 ? desc.alpha : lumped ? kDefaultAlpha : -1.0;
  settings.alpha = std::max(alpha, 0.0);
  settleShrinkage(desc.shrinkage, family.order == 1, learning);
  learning.maxCoefficients = UINT64_MAX;
  settings.lights = settleLights(memory, desc);
  if (desc.target) settings.target = desc.target;
  return settings;
}

const char* differenceOf(const FieldSettings& a, const FieldSettings& b) {
  const LearningSettings& ours = a.learning;
  const LearningSettings& theirs = b.learning;
  if (a.preset != b.preset) return "its preset";
  if (a.map != b.map) return "its map";
  if (a.startLevel != b.startLevel || a.maxLevel != b.maxLevel) return "its levels";
  if (ours.estimator != theirs.estimator) return "its estimator";
  if (ours.tau != theirs.tau) return "tau";
  if (ours.shrinkage != theirs.shrinkage || ours.refitShrinkage != theirs.refitShrinkage) {
    return "shrinkage";
  }
  if (ours.refitter.solver != theirs.refitter.solver) return "refitSolver";
  if (a.target != b.target) return "target";
  if (a.alpha != b.alpha) return "alpha";
  if (a.patches != b.patches || a.patchSamples != b.patchSamples) return "the kind of its patches";
  if (!(a.lower == b.lower) || !(a.upper == b.upper)) return "its box";
  const uint32_t lights = a.lights ? a.lights->lights() : 0;
  if (lights != (b.lights ? b.lights->lights() : 0)) return "lightCount";
  return lights == 0 || *a.lights == *b.lights ? nullptr : "lightPowers";
}

}  // namespace awd
