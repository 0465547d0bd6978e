// SPDX-License-Identifier: Apache-2.0
// Maps from the unit square to directions above a surface, and tangent frames.
#pragma once

#include <cmath>

#include "awd/field.h"
#include "util/vec.h"

namespace awd {

/// A right-handed frame about a unit normal. The tangent depends on the normal alone, through its
/// dominant axis, so that surfaces that share a patch share directions too.
struct Frame {
  Vec3f tangent, bitangent, normal;

  explicit Frame(Vec3f n) : normal(n) {
    const float x = std::abs(n.x);
    const float y = std::abs(n.y);
    const float z = std::abs(n.z);
    // The axis after the dominant one is never parallel to the normal: what is left of it beside
    // the normal has the length sqrt(1 - c^2), c their cosine.
    const bool alongX = (x >= y) & (x >= z);
    const bool alongY = !alongX & (y >= z);
    const Vec3f axis = {alongX || alongY ? 0.0f : 1.0f, alongX ? 1.0f : 0.0f, alongY ? 1.0f : 0.0f};
    const float c = dot(n, axis);
    tangent = (axis - n * c) * (1.0f / std::sqrt(1.0f - c * c));
    bitangent = cross(n, tangent);
  }
  Vec3f toWorld(Vec3f d) const { return tangent * d.x + bitangent * d.y + normal * d.z; }
  Vec3f toLocal(Vec3f d) const { return {dot(d, tangent), dot(d, bitangent), dot(d, normal)}; }
};

/// A point of the square with its direction in the local frame (z up) and the solid angle per
/// area of the square there: p_omega = p_square / solidAngle.
struct MappedDirection {
  Vec3f direction;
  float solidAngle;  ///< |d omega / d(u,v)|, positive and finite
};

/// spherical: theta = pi u / 2, phi = 2 pi v; d omega = pi^2 sin(theta) du dv.
/// cylindrical: cos(theta) = u, phi = 2 pi v; d omega = 2 pi du dv.
/// cosine: Malley's method in polar coordinates, sin(theta)^2 = u, phi = 2 pi v; as the next.
/// concentric-cosine: Shirley and Chiu's equal-area map of the square to the disk, then straight
/// up to the dome (Malley); d omega = pi / cos(theta) du dv.
MappedDirection mapToHemisphere(AWDHemisphereMap map, float u, float v);

/// The inverse; z > 0. The point lies in [0,1)^2.
void mapToSquare(AWDHemisphereMap map, Vec3f direction, float& u, float& v);

/// d omega / d(u,v) at a direction, without its point: for pdfs of directions that were not drawn
/// from the map.
float solidAngleAt(AWDHemisphereMap map, Vec3f direction);

}  // namespace awd
