// SPDX-License-Identifier: Apache-2.0
// How long the host's paths live: by the radiance still to come, as the host itself has seen it,
// so that it is the same rule whatever guides the directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host_scene.h"

namespace bench::host {

enum class Roulette { kAlbedo, kAdjoint };

class PathLength {
 public:
  /// Of images of `width` pixels a row.
  PathLength(const Scene& scene, Roulette roulette, uint32_t width);

  /// To go on from a place, before the direction is drawn; throughput: before the place.
  double chance(const Place& place, Vec throughput, std::size_t pixel) const;
  /// An estimate of the luminance of indirect light that a place reflects.
  void learn(const Place& place, double reflected);
  /// Between passes; image: the mean of all samples so far.
  void adapt(const std::vector<Vec>& image);
  bool learns() const { return roulette_ == Roulette::kAdjoint; }

 private:
  struct Cell {
    double sum = 0.0, mean = 0.0;
    uint32_t count = 0;
  };
  std::size_t cellOf(const Place& place) const;

  Roulette roulette_;
  uint32_t width_;
  Vec lower_;
  double cellsPerLength_;
  std::vector<Cell> cells_;       ///< by position, of each of six dominant directions of normals
  std::vector<double> expected_;  ///< luminance of each pixel; empty: not known
};

}  // namespace bench::host
