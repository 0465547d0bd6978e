// SPDX-License-Identifier: Apache-2.0
#include "density/refit_bytes.h"

#include <algorithm>
#include <cmath>

#include "density/binned_sum.h"
#include "density/normal_pattern.h"
#include "util/error.h"

namespace awd {

namespace {

[[noreturn]] void refuse(double bytes, uint64_t allowed) {
  fail(AWD_ERROR_INVALID_ARGUMENT,
       "the estimator refit would sum %.4g bytes at the start: desc->refitBytes is %llu; lower "
       "desc->axes[..].startLevel, take a basis of lower order, or allow more",
       bytes, static_cast<unsigned long long>(allowed));
}

/// Lowers the highest of the levels that may be, the last axis first; false if none may.
bool lowerOne(uint32_t dimensions, const Levels& least, Levels& levels) {
  uint32_t chosen = dimensions;
  for (uint32_t a = dimensions; a-- > 0;) {
    if (levels[a] <= least[a]) continue;
    if (chosen == dimensions || levels[a] > levels[chosen]) chosen = a;
  }
  if (chosen == dimensions) return false;
  --levels[chosen];
  return true;
}

}  // namespace

double refitBytes(const DensityBases& bases, const Levels& levels) {
  double bytes = sizeof(BinnedSum);
  for (uint32_t a = 0; a < bases.dimensions(); ++a) {
    bytes *= static_cast<double>(NormalPattern::pairsOf(bases.family(a).level(levels[a]), a == 0));
  }
  return bytes;
}

void fitRefitBytes(const DensityBases& bases, DensitySettings& settings) {
  LearningSettings& learning = settings.learning;
  if (learning.estimator != AWD_ESTIMATOR_REFIT) return;
  const bool tree = settings.structure == AWD_STRUCTURE_TREE;
  const uint32_t d = bases.dimensions();
  const double leaf = tree ? refitBytes(bases, {}) : 0.0;
  const auto bytesOn = [&](const Levels& levels) {
    if (!tree) return refitBytes(bases, levels);
    int halvings = 0;
    for (uint32_t a = 0; a < d; ++a) halvings += static_cast<int>(levels[a]);
    return std::ldexp(leaf, halvings);
  };
  const auto allowed = static_cast<double>(learning.refitBytes);
  const auto keepWithin = [&](const Levels& least, Levels& levels) {
    while (bytesOn(levels) > allowed) {
      if (!lowerOne(d, least, levels)) refuse(bytesOn(levels), learning.refitBytes);
    }
  };
  Levels least{};
  for (uint32_t a = 0; a < d; ++a) {
    least[a] = settings.fixedStart[a] ? settings.startLevel[a]
               : tree                 ? 0
                                      : bases.family(a).minLevel();
  }
  keepWithin(least, settings.startLevel);
  if (tree) {
    const auto leaves = static_cast<uint64_t>(allowed / leaf);
    learning.maxCoefficients = std::min(learning.maxCoefficients, leaves * bases.shape({}).size());
  } else {
    keepWithin(settings.startLevel, learning.maxLevel);
  }
  for (uint32_t a = 0; a < d; ++a) {
    learning.minLevel[a] = std::min(learning.minLevel[a], settings.startLevel[a]);
  }
}

}  // namespace awd
