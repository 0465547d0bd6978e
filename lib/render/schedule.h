// SPDX-License-Identifier: Apache-2.0
// How many samples per pixel each pass gets.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "awd/render.h"

namespace awd {

/// Samples per pixel of pass k = 0, 1, .. where the library divides: 1, 1, 1, 2, 2, 2, 4, ..
uint32_t passSize(uint32_t k);

/// The passes that `schedule` asks for, or the preset's. `learns`: whether densities adapt between
/// passes; if not, one pass does.
std::pmr::vector<uint32_t> planPasses(std::pmr::memory_resource* memory,
                                      const AWDSchedule& schedule, AWDPreset preset, bool learns);

/// The limits that a quality stands for.
AWDSchedule qualitySchedule(AWDQuality quality);

}  // namespace awd
