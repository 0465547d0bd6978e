// SPDX-License-Identifier: Apache-2.0
// The host's integrator: light on the floor of its room, pixel by pixel and pass by pass.
#pragma once

#include "awd/awd.hpp"
#include "host.h"

namespace host {

/// The floor as n x n pixels, from `samples` directions each, drawn by the cosine.
Picture lightFloor(uint32_t n, uint32_t samples);

/// The same with directions from a field that learns from pass to pass.
Picture lightFloorGuided(const awd::Device& device, uint32_t n, uint32_t samples);

/// Mean of squared differences from the truth, relative to it.
double relativeError(const Picture& floor);

/// Mean over pixels of the quotient of picture and truth, which is 1 but for noise.
double relativeMean(const Picture& floor);

}  // namespace host
