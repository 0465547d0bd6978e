// SPDX-License-Identifier: Apache-2.0
// One patch of a field: the density that is sampled during a pass, and what the pass learns.
#pragma once

#include <memory_resource>

#include "density/square_density.h"
#include "guide/patch_statistics.h"
#include "util/context.h"

namespace awd {

struct Patch {
  Patch(std::pmr::memory_resource* memory, Owned<PatchStatistics> fresh)
      : density(nullptr, {memory}), statistics(std::move(fresh)), marked(nullptr, {memory}) {}

  Owned<SquareDensity> density;  ///< null: the field's start density
  uint64_t learned = 0;          ///< samples that the density was made of
  bool seen = false;             ///< had a sample in a pass that is over
  Owned<PatchStatistics> statistics;
  Owned<PatchStatistics> marked;  ///< the statistics before the field's mark, if there were any

  /// Samples since the last adapt, those before the mark included.
  uint64_t samples() const { return statistics->samples() + (marked ? marked->samples() : 0); }
  bool hasBeenSeen() const { return seen || samples() > 0; }
  std::size_t bytes() const {
    return sizeof *this + (density ? density->bytes() : 0) + statistics->bytes() +
           (marked ? marked->bytes() : 0);
  }
};

}  // namespace awd
