// SPDX-License-Identifier: Apache-2.0
// One patch of a field: the density that is sampled during a pass, and what the pass learns.
#pragma once

#include <memory_resource>

#include "density/square_density.h"
#include "guide/light_choice.h"
#include "guide/patch_statistics.h"

namespace awd {

/// What all passes together have taught a patch.
struct PatchKnowledge {
  Ref<SquareDensity> density;  ///< null: the field's start density
  double weight = 0.0;         ///< samples that it was made of; a part of them after a split
  double mean = 0.0;           ///< of f/p over them: the integral of f
  double alpha = 1.0;          ///< share of the constant in the density
  PatchStatistics::Eighths eighths{};  ///< samples in each, since the last split
  double root = 0.0;                   ///< integral of sqrt(E[f^2]), if that is the target
  Ref<LightChoice> lights;             ///< null: the field's prior
  double lightShare = 1.0;             ///< of what the lights know, that counts after splits
};

struct Patch {
  Patch(std::pmr::memory_resource* memory, Owned<PatchStatistics> fresh)
      : statistics(std::move(fresh)), marked(nullptr, {memory}) {}

  PatchKnowledge known;
  uint64_t learned = 0;  ///< samples of the pass that the density was last made of
  bool seen = false;     ///< had a record in a pass that is over
  Owned<PatchStatistics> statistics;
  Owned<PatchStatistics> marked;  ///< the statistics before the field's mark, if there were any

  /// Samples since the last adapt, those before the mark included.
  uint64_t samples() const { return statistics->samples() + (marked ? marked->samples() : 0); }
  bool hasRecords() const { return !statistics->isEmpty() || (marked && !marked->isEmpty()); }
  bool hasBeenSeen() const { return seen || hasRecords(); }
  /// Without the density, which patches may share.
  std::size_t bytes() const {
    return sizeof *this + statistics->bytes() + (marked ? marked->bytes() : 0);
  }
};

}  // namespace awd
