// SPDX-License-Identifier: Apache-2.0
#include "guide/hemisphere.h"

#include <algorithm>
#include <cmath>

namespace awd {

namespace {

constexpr float kPi = 3.14159265358979323846f;

// The solid angle per area is 0 at the pole of the spherical map and infinite at the horizon of
// the cosine maps. Sine and cosine are kept above what floats resolve there.
constexpr float kLeastSine = 1e-6f;
constexpr float kLeastCosine = 1e-4f;

MappedDirection spherical(float u, float v) {
  const float theta = 0.5f * kPi * u;
  const float phi = 2.0f * kPi * v;
  const float sine = std::max(std::sin(theta), kLeastSine);
  const float cosine = std::max(std::cos(theta), kLeastCosine);
  return {{sine * std::cos(phi), sine * std::sin(phi), cosine}, kPi * kPi * sine};
}

MappedDirection cylindrical(float u, float v) {
  const float cosine = std::max(u, kLeastCosine);
  const float sine = std::sqrt(std::max(1.0f - cosine * cosine, 0.0f));
  const float phi = 2.0f * kPi * v;
  return {{sine * std::cos(phi), sine * std::sin(phi), cosine}, 2.0f * kPi};
}

MappedDirection malley(float u, float v) {
  const float radius = std::sqrt(u);
  const float phi = 2.0f * kPi * v;
  const float cosine = std::sqrt(std::max(1.0f - u, kLeastCosine * kLeastCosine));
  return {{radius * std::cos(phi), radius * std::sin(phi), cosine}, kPi / cosine};
}

/// Sine and cosine for |x| <= pi/4 by Taylor's series: to the last bits of a float.
float sineWithin(float x) {
  const float y = x * x;
  return x * (1.0f + y * (-1.0f / 6 + y * (1.0f / 120 + y * (-1.0f / 5040 + y * (1.0f / 362880)))));
}
float cosineWithin(float x) {
  const float y = x * x;
  return 1.0f + y * (-0.5f + y * (1.0f / 24 + y * (-1.0f / 720 + y * (1.0f / 40320))));
}

MappedDirection concentricCosine(float u, float v) {
  const float a = 2.0f * u - 1.0f;
  const float b = 2.0f * v - 1.0f;
  float x = 0.0f;
  float y = 0.0f;
  if (a != 0.0f || b != 0.0f) {
    const bool alongX = std::abs(a) > std::abs(b);
    const float radius = alongX ? a : b;
    const float angle = alongX ? 0.25f * kPi * (b / a) : 0.25f * kPi * (a / b);
    const float major = radius * cosineWithin(angle);
    const float minor = radius * sineWithin(angle);
    x = alongX ? major : minor;
    y = alongX ? minor : major;
  }
  const float cosine = std::sqrt(std::max(1.0f - x * x - y * y, kLeastCosine * kLeastCosine));
  return {{x, y, cosine}, kPi / cosine};
}

float belowOne(float x) { return std::clamp(x, 0.0f, std::nextafter(1.0f, 0.0f)); }

}  // namespace

MappedDirection mapToHemisphere(AWDHemisphereMap map, float u, float v) {
  switch (map) {
    case AWD_MAP_SPHERICAL:
      return spherical(u, v);
    case AWD_MAP_CYLINDRICAL:
      return cylindrical(u, v);
    case AWD_MAP_COSINE:
      return malley(u, v);
    default:
      return concentricCosine(u, v);
  }
}

void mapToSquare(AWDHemisphereMap map, Vec3f d, float& u, float& v) {
  if (map != AWD_MAP_CONCENTRIC_COSINE) {
    const float phi = std::atan2(d.y, d.x);
    v = belowOne((phi < 0.0f ? phi + 2.0f * kPi : phi) / (2.0f * kPi));
    u = belowOne(map == AWD_MAP_SPHERICAL     ? std::atan2(std::hypot(d.x, d.y), d.z) * (2.0f / kPi)
                 : map == AWD_MAP_CYLINDRICAL ? d.z
                                              : d.x * d.x + d.y * d.y);
    return;
  }
  const bool alongX = std::abs(d.x) > std::abs(d.y);
  const float major = alongX ? d.x : d.y;
  const float minor = alongX ? d.y : d.x;
  const float radius = std::copysign(std::min(std::hypot(major, minor), 1.0f), major);
  const float ratio = major != 0.0f ? std::atan(minor / major) * (4.0f / kPi) : 0.0f;
  const float a = alongX ? radius : radius * ratio;
  const float b = alongX ? radius * ratio : radius;
  u = belowOne(0.5f * (a + 1.0f));
  v = belowOne(0.5f * (b + 1.0f));
}

float solidAngleAt(AWDHemisphereMap map, Vec3f d) {
  if (map == AWD_MAP_SPHERICAL) return kPi * kPi * std::max(std::hypot(d.x, d.y), kLeastSine);
  if (map == AWD_MAP_CYLINDRICAL) return 2.0f * kPi;
  return kPi / std::max(d.z, kLeastCosine);
}

}  // namespace awd
