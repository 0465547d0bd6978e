// SPDX-License-Identifier: Apache-2.0
// Area lights: each a planar piece of emissive triangles of one material, emitting on its front.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "render/pieces.h"
#include "util/vec.h"

namespace awd {

constexpr uint32_t kNoLight = 0xFFFFFFFFu;

struct Light {
  Vec3f normal;
  Rgb emission;
  float area;
  float choice;  ///< chance to be chosen by power among all lights
  uint32_t firstTriangle, endTriangle;
};

class Lights {
 public:
  explicit Lights(std::pmr::memory_resource* memory);

  /// Adds a light made of these triangles, three corners each.
  void add(Vec3f normal, Rgb emission, const std::pmr::vector<Vec3f>& corners);
  /// Settles the chances once all are added.
  void finish();

  uint32_t size() const { return static_cast<uint32_t>(lights_.size()); }
  const Light& operator[](uint32_t light) const { return lights_[light]; }

  /// A light chosen with probability proportional to area times luminance.
  uint32_t choose(double uniform) const;
  /// Lights in groups, of about equal power where there are more lights than kMostGroups: each is
  /// a run of them in the order in which they were added, in which neighbours tend to be near.
  static constexpr uint32_t kMostGroups = 16;
  uint32_t groups() const { return static_cast<uint32_t>(groupEnds_.size()); }
  /// Chance that choose() falls into a group.
  float groupChance(uint32_t group) const {
    return static_cast<float>(endOf(group) - beginOf(group));
  }
  /// A light of that group, chosen by power.
  uint32_t chooseIn(uint32_t group, double uniform) const;
  /// A point uniform over a light's area, from two uniforms; stratified ones stay so.
  Vec3f sample(const Light& light, double u, double v) const;
  /// Luminance of the brightest.
  float brightest() const;

 private:
  struct Corners {
    Vec3f origin, edge1, edge2;
    double cumulative;  ///< share of the light's area up to and with this triangle; 1 at the last
  };
  void group();

  std::pmr::vector<Light> lights_;
  std::pmr::vector<Corners> triangles_;
  double endOf(uint32_t group) const { return cumulative_[groupEnds_[group] - 1]; }
  double beginOf(uint32_t group) const { return group > 0 ? endOf(group - 1) : 0.0; }

  std::pmr::vector<double> cumulative_;
  std::pmr::vector<uint32_t> groupEnds_;  ///< one past the last light of each
};

}  // namespace awd
