// SPDX-License-Identifier: Apache-2.0
// Radiosity of diffuse scenes: a reference that shares nothing with path tracing but first hits.
// Surfaces are cut into elements of constant radiance, form factors are counted by rays, and the
// system of equations is solved by Eigen.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "awd/awd.h"
#include "metrics.h"
#include "scene_data.h"

namespace bench {

struct RadiosityOptions {
  double edge = 0.25;    ///< triangles are cut until none of their edges is longer
  uint32_t rays = 1024;  ///< of each element, for its form factors
  uint64_t seed = 1;
};

/// Front and back of a triangle are elements of their own.
class Radiosity {
 public:
  /// `scene`: committed, and uploaded from `data`.
  Radiosity(AWDScene scene, const command::SceneData& data, const RadiosityOptions& options);

  std::size_t elements() const { return elements_.size(); }
  /// Share of the element's rays that met anything: 1 in a closed scene.
  double rowSum(std::size_t element) const;
  /// Share of the rays from the fronts of the mesh `from`, spread over its area, that meet the mesh
  /// `to`.
  double formFactor(uint32_t from, uint32_t to) const;
  /// Radiance that leaves an element.
  const std::array<double, 3>& radiance(std::size_t element) const { return radiance_[element]; }

  /// What the camera sees, the mean of side x side rays a pixel.
  command::RgbImage image(const AWDCamera& camera, uint32_t side) const;

 private:
  struct Element {
    uint32_t mesh, triangle;
    uint32_t part;  ///< among the cuts x cuts of its triangle
    bool back;
    double area;
  };
  struct Factor {
    uint32_t element;
    double value;
  };

  void cut(double edge);
  void countFactors(uint32_t rays, uint64_t seed);
  void solve();
  AWDRay rayFrom(const Element& element, const std::array<double, 4>& uniforms) const;
  std::size_t elementAt(const AWDHit& hit, const float direction[3]) const;

  AWDScene scene_;
  const command::SceneData& data_;
  double lift_ = 0.0;
  std::vector<Element> elements_;
  std::vector<std::vector<uint32_t>> cuts_;       ///< of each triangle of each mesh
  std::vector<std::vector<std::size_t>> firsts_;  ///< its first element: all fronts, then backs
  std::vector<std::vector<Factor>> factors_;      ///< of each element
  std::vector<std::array<double, 3>> radiance_;
};

}  // namespace bench
