// SPDX-License-Identifier: Apache-2.0
// The backward path tracer: radiance along one camera ray, and what its vertices have learned.
#pragma once

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
  uint32_t maxSplit = 1;
  bool learnLights = false;  ///< if the field chooses among the scene's
  bool sobol = true;
};

/// Settles what `desc` leaves open; AWD_ERROR_INVALID_ARGUMENT for values that are none.
PathSettings settle(const AWDRenderDesc& desc);

/// Traces paths for one thread. Reads the geometry and the field, records into the field.
class PathTracer {
 public:
  /// field: null unless settings.guide is adaptive.
  PathTracer(const Geometry& geometry, Field* field, const PathSettings& settings);

  /// Radiance arriving at `origin` from `direction`, one sample. NaN or infinite only if the
  /// scene's own radiance leaves the range of floats. expected: luminance that the pixel is
  /// expected to have, 0: not known; roulette alone goes by it.
  Rgb trace(Vec3f origin, Vec3f direction, PathPoints& points, float expected = 0.0f);

  uint64_t rays() const { return rays_; }
  uint64_t shadowRays() const { return shadowRays_; }

 private:
  /// A ray, and the path that led to it.
  struct Ray {
    Vec3f origin, direction;
    Rgb throughput;
    float cosine;       ///< at its origin
    std::size_t depth;  ///< of the vertex that it will meet, from 1 on
    bool stratified;    ///< no other ray of this sample has a vertex of that depth
  };
  struct Surface {
    Vec3f point, normal;  ///< on the side of the ray
    Rgb albedo;
    uint32_t patch;
    PatchView view;
  };
  /// An indirect direction and f_r cos / p without the albedo.
  struct Indirect {
    Vec3f direction;
    float cosine, weight;
    AWDDirectionSample sample;
  };

  /// Radiance that arrives along a ray.
  Rgb arriving(const Ray& ray, PathPoints& points, float expected);
  /// What a surface reflects of other surfaces' light; choice: uniform in [0,1).
  Rgb indirectLight(const Ray& ray, const Surface& surface, double choice, PathPoints& points,
                    float expected);
  Indirect chooseDirection(const Surface& surface, std::size_t vertex, PathPoints& points) const;
  /// How many rays go on, on average.
  float raysToGoOn(const Ray& ray, const Surface& surface, float expected) const;
  /// What a surface reflects of the light that shadow rays find.
  Rgb directLight(const Surface& surface, std::size_t vertex, double choice, PathPoints& points);
  /// By one shadow ray to a light that the patch has chosen.
  Rgb learnedLight(const Surface& surface, double choice, SobolPoint at);
  /// choice: chance of the light, for its weight and its share of the shadow rays.
  Rgb oneShadowRay(const Surface& surface, const Light& light, float choice, double u, double v);
  /// Share of a light's radiance that an indirect ray may count (balance heuristic).
  float emitterWeight(const Light& light, float distance, float cosineAtLight,
                      float cosineBefore) const;
  float choiceOf(const Light& light) const { return chooseByPower_ ? light.choice : 1.0f; }

  const Geometry& geometry_;
  Field* field_;
  PathSettings settings_;
  bool chooseByPower_;
  bool learnLights_;
  uint32_t gridColumns_ = 1;  ///< shadow rays are jittered on a grid of this many columns
  uint64_t rays_ = 0;
  uint64_t shadowRays_ = 0;
  uint64_t splitsUntil_ = 0;  ///< so many rays: from there on no ray of the path is split
};

}  // namespace awd
