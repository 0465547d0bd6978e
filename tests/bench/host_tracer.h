// SPDX-License-Identifier: Apache-2.0
// A path tracer of one thread that is not our renderer: a host, which can be guided by anything.
// Lights, roulette, numbers and schedule are the same whatever guides it.
#pragma once

#include <vector>

#include "host_roulette.h"

namespace bench::host {

/// A camera path, from its first surface on. Of each vertex `vertices` has what the library's
/// recorder takes, where `emitted` has the weight of emitter hits already.
struct Path {
  std::vector<Place> places;
  std::vector<Vec> before;  ///< unit, towards the vertex before
  std::vector<AWDPathVertex> vertices;
};

class Guide {
 public:
  Guide() = default;
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;
  virtual ~Guide() = default;

  /// Sets direction and pdf of the vertex' sample, and what else `learn` will want to find.
  virtual void choose(const Place& place, const double uniforms[3], AWDPathVertex& vertex) = 0;
  virtual void learn(const Path& path) = 0;
  /// Between two passes.
  virtual void adapt() = 0;
};

/// By the cosine.
void chooseByCosine(const Place& place, double u, double v, AWDPathVertex& vertex);

struct Picture {
  std::vector<float> pixels;  ///< RGB, rows from the top
  double cpuSeconds = 0.0;    ///< of the process
  uint64_t rays = 0;
};

/// guide NULL: by the cosine, in one pass, and by albedo. False: cancelled.
bool render(const Scene& scene, const AWDCamera& camera, Guide* guide, Roulette roulette,
            uint32_t samples, uint64_t seed, Cancelled cancelled, Picture& picture);

}  // namespace bench::host
