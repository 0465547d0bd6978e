// SPDX-License-Identifier: Apache-2.0
// The scene of figure 4: a floor, which is one patch, and a small lamp that indirect rays must hit.
#pragma once

#include "render_shots.h"

namespace bench::paper {

/// Side of the square lamp, 1 above the middle of the floor; that of the floor is 2.
constexpr double kLampSide = 0.06;

/// Seen from just below the lamp, so that nothing hides the floor. No reference.
LoadedScene floorUnderLamp(const awd::Device& device, uint32_t width);

/// The patch that the floor is.
uint32_t floorPatch(const LoadedScene& floor);

/// Of a sample's radiance at a point of the floor.
struct Moments {
  double mean, variance;
};

/// Under the field, without noise: integrals over the lamp by quadrature.
Moments momentsAt(AWDField field, uint32_t patch, double x, double z);

/// Cell of the lamp's middle, seen from there, on the unit square of a density of that level.
uint32_t cellAt(AWDField field, uint32_t patch, uint32_t level, double x, double z);

}  // namespace bench::paper
