// SPDX-License-Identifier: Apache-2.0
// How many samples per pixel each pass gets.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "awd/render.h"

namespace awd {

/// The passes that `schedule` asks for, or the preset's. `learns`: whether densities adapt between
/// passes; if not, one pass does.
std::pmr::vector<uint32_t> planPasses(std::pmr::memory_resource* memory,
                                      const AWDSchedule& schedule, AWDPreset preset, bool learns);

}  // namespace awd
