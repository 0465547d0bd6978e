// SPDX-License-Identifier: Apache-2.0
// A render of several passes, looked at after each.
#pragma once

#include <cstdint>
#include <vector>

#include "render_shots.h"

namespace bench::paper {

/// The film and what it took, from the first pass to the end of this one.
struct Stage {
  uint32_t samples = 0;  ///< a pixel
  double l1 = 0.0;       ///< against the scene's reference, unless that is empty
  double cpuSeconds = 0.0;
  command::RgbImage film;
};

/// Passes of so many samples; the densities adapt after the first `learning` of them. The field is
/// `field`, or if that is NULL one that begins empty. Throws Cancelled.
std::vector<Stage> renderStages(const LoadedScene& loaded, const Settings& settings,
                                const std::vector<uint32_t>& passes, std::size_t learning,
                                uint64_t seed, AWDField field = nullptr);

/// One image of so many samples by the library's own schedule. Throws Cancelled.
Stage renderWhole(const LoadedScene& loaded, const Settings& settings, uint32_t samples,
                  uint64_t seed);

/// The image of the later stage's own samples, where all count the same.
command::RgbImage between(const Stage& earlier, const Stage& later);

}  // namespace bench::paper
