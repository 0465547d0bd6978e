// SPDX-License-Identifier: Apache-2.0
// Ray tracing by Embree, which this file pair alone knows of; compiles against Embree 3 and 4.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "util/context.h"
#include "util/vec.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace awd {

struct RayHit {
  float t, u, v;
  uint32_t triangle;
};

/// An acceleration structure over triangles; all queries are free.
class Embree {
 public:
  /// What others have done of a commit before its part.
  static constexpr double kProgressBegins = 0.6;
  /// corners: three a triangle, finite; kept. Reports to `progress` and throws if it is cancelled.
  Embree(Context& context, std::pmr::vector<Vec3f> corners, Progress& progress);
  ~Embree();
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  /// Whether this may be an origin or a direction: beyond, Embree ends the program.
  static bool takes(Vec3f v) {
    constexpr float kMost = 1e18f;
    return std::fabs(v.x) <= kMost && std::fabs(v.y) <= kMost && std::fabs(v.z) <= kMost;
  }
  /// The first hit on o + t d, tnear <= t <= tfar. False if there is none.
  bool intersect(Vec3f origin, Vec3f direction, float tnear, float tfar, RayHit& hit) const;
  /// Whether there is any hit.
  bool occluded(Vec3f origin, Vec3f direction, float tnear, float tfar) const;
  /// The triangle nearest to a point; 0xFFFFFFFF if there is none.
  uint32_t nearest(Vec3f point) const;

  const Vec3f* corners(uint32_t triangle) const { return &corners_[3 * std::size_t{triangle}]; }

 private:
  void build(Context& context, std::size_t count, Progress& progress);
  void close() noexcept;

  std::pmr::vector<Vec3f> corners_;
  std::pmr::vector<uint32_t> indices_;
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

}  // namespace awd
