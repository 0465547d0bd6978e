// SPDX-License-Identifier: Apache-2.0
// Three numbers: points, directions and linear RGB.
#pragma once

#include <algorithm>
#include <cmath>

namespace awd {

template <class T>
struct Vec3 {
  T x = 0, y = 0, z = 0;

  Vec3 operator+(Vec3 b) const { return {x + b.x, y + b.y, z + b.z}; }
  Vec3 operator-(Vec3 b) const { return {x - b.x, y - b.y, z - b.z}; }
  Vec3 operator*(Vec3 b) const { return {x * b.x, y * b.y, z * b.z}; }
  Vec3 operator*(T s) const { return {x * s, y * s, z * s}; }
  Vec3 operator-() const { return {-x, -y, -z}; }
  Vec3& operator+=(Vec3 b) { return *this = *this + b; }
  bool operator==(const Vec3& b) const { return x == b.x && y == b.y && z == b.z; }
};

using Vec3f = Vec3<float>;
using Vec3d = Vec3<double>;
using Rgb = Vec3<float>;

template <class T>
T dot(Vec3<T> a, Vec3<T> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
Vec3<T> cross(Vec3<T> a, Vec3<T> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class T>
T length(Vec3<T> a) {
  return std::sqrt(dot(a, a));
}

template <class T>
Vec3<T> normalized(Vec3<T> a) {
  return a * (T(1) / length(a));
}

template <class T>
T maxComponent(Vec3<T> a) {
  return std::max(a.x, std::max(a.y, a.z));
}

template <class T>
bool isFinite(Vec3<T> a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

template <class To, class From>
Vec3<To> convert(Vec3<From> a) {
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

inline Vec3f load(const float v[3]) { return {v[0], v[1], v[2]}; }

/// Luminance of linear RGB with the primaries of Rec. 709.
template <class T>
T luminance(Vec3<T> c) {
  return T(0.2126) * c.x + T(0.7152) * c.y + T(0.0722) * c.z;
}

}  // namespace awd
