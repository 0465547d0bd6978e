// SPDX-License-Identifier: Apache-2.0
#include "density/settings.h"

#include <algorithm>
#include <cmath>

#include "density/blended_row.h"
#include "density/leaf_sampler.h"
#include "util/error.h"

namespace awd {

namespace {

constexpr uint64_t kPassSamples = 1024;
constexpr uint64_t kMaxCoefficients = 65536;
constexpr uint64_t kMostCoefficients = uint64_t{1} << 30;
constexpr uint32_t kTreeHalvings = 20;
/// A tree starts with so many boxes that each gets that many samples of the first pass.
constexpr uint64_t kSamplesPerStartBox = 8;
constexpr double kConstantShrinkage = 2.0;
constexpr double kSmoothShrinkage = 0.5;
constexpr uint64_t kRefitBytes = uint64_t{1} << 28;

int32_t settleChoice(int32_t asked, int32_t standard, int32_t last, const char* name) {
  if (asked < 0 || asked > last) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s is %d: 0 to %d is allowed", name, asked, last);
  }
  return asked == 0 ? standard : asked;
}

/// Number of coefficients, or a number beyond all limits.
uint64_t sizeOn(const AWDBasisFamily* const* families, uint32_t dimensions, const Levels& levels) {
  uint64_t size = 1;
  for (uint32_t a = 0; a < dimensions; ++a) {
    size *= families[a]->count(levels[a]);
    if (size > kMostCoefficients) return kMostCoefficients + 1;
  }
  return size;
}

/// What the host says of one axis's levels, within what the family or the tree has.
struct AxisLevels {
  uint32_t least, most;       // that there are
  bool hasStart, hasMaximum;  // that the host settles
  uint32_t start, maximum;
};

AxisLevels axisLevels(const AWDDensityDesc& desc, uint32_t axis, bool tree,
                      const AWDBasisFamily& family) {
  AxisLevels levels = {};
  levels.least = tree ? 0 : family.minLevel;
  levels.most = tree ? kMostHalvings : family.maxLevel;
  const AWDDensityAxis given = desc.axes ? desc.axes[axis] : AWDDensityAxis{};
  levels.hasStart = given.startLevel != 0;
  levels.hasMaximum = given.maxLevel != 0;
  levels.start = levels.hasStart ? given.startLevel - 1 : levels.least;
  levels.maximum = levels.hasMaximum ? given.maxLevel - 1 : levels.most;
  for (const auto& [level, name] :
       {std::pair(levels.start, "startLevel"), std::pair(levels.maximum, "maxLevel")}) {
    if (level < levels.least || level > levels.most) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->axes[%u].%s is level %u: %s has levels %u to %u (AWD_LEVEL(l) says level l)",
           axis, name, level, tree ? "a tree" : family.name, levels.least, levels.most);
    }
  }
  if (levels.start > levels.maximum) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->axes[%u].startLevel is level %u, above maxLevel, %u",
         axis, levels.start, levels.maximum);
  }
  return levels;
}

/// Rungs of all axes that may go on, while the coefficients are at most so many.
void raise(const AWDBasisFamily* const* families, uint32_t dimensions, const Levels& maximum,
           uint64_t coefficients, Levels& levels) {
  for (;;) {
    Levels next = levels;
    for (uint32_t a = 0; a < dimensions; ++a) next[a] = std::min(levels[a] + 1, maximum[a]);
    if (next == levels || sizeOn(families, dimensions, next) > coefficients) return;
    levels = next;
  }
}

void settleGrid(const AWDDensityDesc& desc, const AWDBasisFamily* const* families,
                DensitySettings& settings) {
  LearningSettings& learning = settings.learning;
  const uint32_t d = settings.dimensions;
  Levels ceiling{}, startCeiling{};
  for (uint32_t a = 0; a < d; ++a) {
    const AxisLevels levels = axisLevels(desc, a, false, *families[a]);
    settings.startLevel[a] = levels.start;
    settings.fixedStart[a] = levels.hasStart;
    const bool fixed = levels.hasStart && levels.start == levels.maximum;
    learning.minLevel[a] = fixed ? levels.start : levels.least;
    ceiling[a] = levels.maximum;
    startCeiling[a] = levels.hasStart ? levels.start : levels.maximum;
  }
  const uint64_t least = sizeOn(families, d, settings.startLevel);
  if (least > learning.maxCoefficients) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->axes ask for %s%llu coefficients at the start: desc->maxCoefficients is %llu",
         least > kMostCoefficients ? "more than " : "",
         static_cast<unsigned long long>(std::min(least, kMostCoefficients)),
         static_cast<unsigned long long>(learning.maxCoefficients));
  }
  raise(families, d, startCeiling,
        std::min(bearable(settings.passSamples), learning.maxCoefficients), settings.startLevel);
  // No tables are made for levels that the coefficients allowed can't reach.
  learning.maxLevel = settings.startLevel;
  raise(families, d, ceiling, learning.maxCoefficients, learning.maxLevel);
}

void settleTree(const AWDDensityDesc& desc, const AWDBasisFamily* const* families,
                DensitySettings& settings) {
  LearningSettings& learning = settings.learning;
  const uint32_t d = settings.dimensions;
  if (settings.sampler == AWD_SAMPLER_COMPONENT) {
    fail(AWD_ERROR_UNSUPPORTED, "desc->sampler is component: a tree has inverse CDF only");
  }
  uint64_t leaf = 1;
  for (uint32_t a = 0; a < d; ++a) {
    if (!(families[a]->flags & AWD_BASIS_NESTED)) {
      fail(AWD_ERROR_UNSUPPORTED,
           "desc->axes[%u].basis is %s: a tree wants a nested family, such as haar, f2, m2 or m3",
           a, families[a]->name);
    }
    leaf *= families[a]->count(0);
  }
  if (leaf > std::min<uint64_t>(kMostLeafCoefficients, learning.maxCoefficients)) {
    fail(AWD_ERROR_UNSUPPORTED, "a leaf would have %llu coefficients: at most %llu are allowed",
         static_cast<unsigned long long>(leaf),
         static_cast<unsigned long long>(
             std::min<uint64_t>(kMostLeafCoefficients, learning.maxCoefficients)));
  }
  uint64_t leaves = 1;
  for (uint32_t a = 0; a < d; ++a) {
    const AxisLevels levels = axisLevels(desc, a, true, *families[a]);
    settings.fixedStart[a] = levels.hasStart;
    settings.startLevel[a] = levels.start;
    learning.maxLevel[a] =
        levels.hasMaximum ? levels.maximum : std::max(kTreeHalvings, levels.start);
    const bool fixed = levels.hasStart && levels.start == levels.maximum;
    learning.minLevel[a] = fixed ? levels.start : 0;
    leaves = std::min(leaves << std::min(levels.start, 31u), kMostCoefficients);
  }
  const uint64_t asked = leaves * leaf;
  if (asked > learning.maxCoefficients) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->axes ask for %llu coefficients at the start: desc->maxCoefficients is %llu",
         static_cast<unsigned long long>(asked),
         static_cast<unsigned long long>(learning.maxCoefficients));
  }
  const uint64_t most =
      std::min(settings.passSamples / kSamplesPerStartBox, learning.maxCoefficients) / leaf;
  for (bool more = true; more;) {
    more = false;
    for (uint32_t a = 0; a < d; ++a) {
      if (settings.fixedStart[a] || settings.startLevel[a] >= learning.maxLevel[a] ||
          2 * leaves > most) {
        continue;
      }
      ++settings.startLevel[a];
      leaves *= 2;
      more = true;
    }
  }
}

/// Rows that drawing the last coordinate blends, on whichever levels that is most.
std::size_t mostRowsOf(const DensityBases& bases) {
  std::size_t rows = 1;
  for (uint32_t a = 0; a + 1 < bases.dimensions(); ++a) {
    const Family& family = bases.family(a);
    uint32_t alive = 1;
    for (uint32_t l = family.minLevel(); l <= family.maxLevel(); ++l) {
      alive = std::max(alive, family.level(l).alive);
    }
    rows *= alive;
  }
  return rows;
}

}  // namespace

const char* defaultBasis(AWDDensityStructure structure) {
  return structure == AWD_STRUCTURE_TREE ? "haar" : "linear-bspline";
}

void settleShrinkage(double asked, bool constant, LearningSettings& learning) {
  if (!std::isfinite(asked)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->shrinkage is %g: it must be finite", asked);
  }
  const double given = std::max(asked, 0.0);
  learning.shrinkage = asked != 0.0 ? given : constant ? kConstantShrinkage : kSmoothShrinkage;
  learning.refitShrinkage = asked != 0.0 ? given : -1.0;  // left open it goes by the noise
}

DensitySettings settle(const AWDDensityDesc& desc, const AWDBasisFamily* const* families) {
  DensitySettings settings;
  LearningSettings& learning = settings.learning;
  settings.dimensions = desc.dimensions;
  settings.structure =
      settleChoice(desc.structure, AWD_STRUCTURE_GRID, AWD_STRUCTURE_TREE, "structure");
  learning.estimator =
      settleChoice(desc.estimator, AWD_ESTIMATOR_DEFAULT, AWD_ESTIMATOR_REFIT, "estimator");
  learning.target = settleChoice(desc.target, AWD_TARGET_MEAN, AWD_TARGET_RMS, "target");
  const bool paper = learning.estimator == AWD_ESTIMATOR_PAPER;
  settings.sampler =
      settleChoice(desc.sampler, paper ? AWD_SAMPLER_COMPONENT : AWD_SAMPLER_INVERSE_CDF,
                   AWD_SAMPLER_COMPONENT, "sampler");
  if (paper && settings.sampler != AWD_SAMPLER_COMPONENT) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->sampler is inverse CDF: the estimator paper wants the component of each sample");
  }
  settings.combination =
      settleChoice(desc.combination, AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE, "combination");
  if (std::isnan(desc.tau) || desc.tau > 1.0) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->tau is %g: at most 1 is allowed", desc.tau);
  }
  learning.tau = desc.tau;
  settleShrinkage(desc.shrinkage,
                  std::all_of(families, families + desc.dimensions,
                              [](const AWDBasisFamily* f) { return f->order == 1; }),
                  learning);
  learning.refitBytes = desc.refitBytes ? desc.refitBytes : kRefitBytes;
  settings.passSamples = desc.passSamples ? desc.passSamples : kPassSamples;
  learning.maxCoefficients = desc.maxCoefficients ? desc.maxCoefficients : kMaxCoefficients;
  if (learning.maxCoefficients > kMostCoefficients) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->maxCoefficients is %llu: at most %llu are allowed",
         static_cast<unsigned long long>(learning.maxCoefficients),
         static_cast<unsigned long long>(kMostCoefficients));
  }
  settings.structure == AWD_STRUCTURE_TREE ? settleTree(desc, families, settings)
                                           : settleGrid(desc, families, settings);
  return settings;
}

Ref<DensityBases> compileBases(std::pmr::memory_resource* memory, const DensitySettings& settings,
                               const AWDBasisFamily* const* families) {
  DensityBases::Axis axes[kMaxDimensions] = {};
  const bool tree = settings.structure == AWD_STRUCTURE_TREE;
  for (uint32_t a = 0; a < settings.dimensions; ++a) {
    // A leaf is of level 0; halving it wants the two-scale relation to level 1.
    axes[a] = {families[a], tree ? 1 : settings.learning.maxLevel[a]};
  }
  Ref<DensityBases> bases = DensityBases::make(memory, axes, settings.dimensions);
  if (!tree && settings.sampler == AWD_SAMPLER_INVERSE_CDF) {
    const std::size_t rows = mostRowsOf(*bases);
    if (rows > kMostRows) {
      fail(AWD_ERROR_UNSUPPORTED,
           "bases of such high order in %u dimensions: %zu rows of coefficients would be blended "
           "for one point, at most %zu are; take the sampler component",
           settings.dimensions, rows, kMostRows);
    }
  }
  return bases;
}

}  // namespace awd
