// SPDX-License-Identifier: Apache-2.0
// The host's world: a dim room of 1 x 1 x 1 with a bright window in one wall, seen from its floor.
#pragma once

#include "host.h"

namespace host {

constexpr float kAlbedo = 0.5f;

/// Radiance that comes to a point of the floor z = 0 from a direction above it.
float incoming(const Vec& position, const Vec& direction);

/// What the floor reflects there, albedo / pi times the integral of L cos(theta): by quadrature.
double exactReflected(const Vec& position);

}  // namespace host
