// SPDX-License-Identifier: Apache-2.0
// The backward path tracer: radiance along one camera ray, and what its vertices have learned.
#pragma once

#include <memory_resource>
#include <vector>

#include "awd/render.h"
#include "guide/field.h"
#include "render/geometry.h"
#include "render/path_points.h"

namespace awd {

/// The settings of a render with every default settled.
struct PathSettings {
  AWDGuide guide = AWD_GUIDE_ADAPTIVE;
  AWDDirectLight direct = AWD_DIRECT_WEIGHTED;
  AWDRoulette roulette = AWD_ROULETTE_ALBEDO;
  uint32_t shadowRays = 1;
  uint32_t maxLights = 1;
  bool sobol = true;
};

/// Settles what `desc` leaves open; AWD_ERROR_INVALID_ARGUMENT for values that are none.
PathSettings settle(const AWDRenderDesc& desc);

/// Traces paths for one thread. Reads the geometry and the field, records into the field.
class PathTracer {
 public:
  /// field: null unless settings.guide is adaptive.
  PathTracer(std::pmr::memory_resource* memory, const Geometry& geometry, Field* field,
             const PathSettings& settings);

  /// Radiance arriving at `origin` from `direction`, one sample. NaN or infinite only if the
  /// scene's own radiance leaves the range of floats. expected: luminance that the pixel is
  /// expected to have, 0: not known; roulette alone goes by it.
  Rgb trace(Vec3f origin, Vec3f direction, PathPoints& points, float expected = 0.0f);

  uint64_t rays() const { return rays_; }
  uint64_t shadowRays() const { return shadowRays_; }

 private:
  /// A surface point of the path, with what leaves it towards the vertex before.
  struct Vertex {
    Rgb emitted;  ///< by the surface itself, as far as it counts
    Rgb direct;   ///< reflected light of shadow rays
    Rgb weight;   ///< radiance of the indirect ray is multiplied by this: f_r cos / (p q)
    Rgb albedo;
    float cosine;
    uint32_t patch;
    PatchView view;
    AWDDirectionSample sample;
    bool goesOn;  ///< an indirect ray was traced
  };
  struct Surface {
    Vec3f point, normal;  ///< on the side of the ray
    Rgb albedo;
  };
  /// An indirect direction and f_r cos / p without the albedo.
  struct Indirect {
    Vec3f direction;
    float cosine, weight;
    AWDDirectionSample sample;
  };

  Indirect chooseDirection(const Surface& surface, const PatchView& patch,
                           PathPoints& points) const;
  float chanceToGoOn(std::size_t depth, Rgb throughput, Rgb albedo, const PatchView& patch,
                     float expected) const;
  Rgb directLight(const Surface& surface, double choice, PathPoints& points);
  Rgb oneShadowRay(const Surface& surface, const Light& light, float choice, double u, double v);
  /// Share of a light's radiance that an indirect ray may count (balance heuristic).
  float emitterWeight(const Light& light, float distance, float cosineAtLight,
                      float cosineBefore) const;
  float choiceOf(const Light& light) const { return chooseByPower_ ? light.choice : 1.0f; }
  Rgb gather();

  const Geometry& geometry_;
  Field* field_;
  PathSettings settings_;
  bool chooseByPower_;
  uint32_t gridColumns_ = 1;  ///< shadow rays are jittered on a grid of this many columns
  std::pmr::vector<Vertex> path_;
  uint64_t rays_ = 0;
  uint64_t shadowRays_ = 0;
};

}  // namespace awd
