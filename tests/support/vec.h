// SPDX-License-Identifier: Apache-2.0
// Vectors in double, for tests to compute what the library should find.
#pragma once

#include <cmath>

namespace awdtest {

struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(Vec3 a) { return std::sqrt(dot(a, a)); }
inline Vec3 normalise(Vec3 a) { return (1.0 / length(a)) * a; }

/// Two unit vectors that make a right-handed frame with the unit vector n.
struct Frame {
  Vec3 s, t, n;
  explicit Frame(Vec3 normal) : n(normal) {
    s = normalise(cross(std::fabs(n.x) > 0.6 ? Vec3{0, 1, 0} : Vec3{1, 0, 0}, n));
    t = cross(n, s);
  }
  /// The direction at angle theta from n and phi about it.
  Vec3 direction(double theta, double phi) const {
    return std::sin(theta) * (std::cos(phi) * s + std::sin(phi) * t) + std::cos(theta) * n;
  }
};

}  // namespace awdtest
