// SPDX-License-Identifier: Apache-2.0
#include "render/path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "util/error.h"

namespace awd {

namespace {

constexpr float kPi = 3.14159265358979323846f;
constexpr uint32_t kPaperShadowRays = 4;
constexpr uint32_t kMostShadowRays = 1024;
constexpr uint32_t kPaperMaxLights = 8;
constexpr uint32_t kMaxLights = 1;
/// From here on even a white surface ends paths.
constexpr std::size_t kLongPath = 64;

/// After so many rays a path, of whose branches all are one, is split no more: a field that is
/// wrong by powers of ten would have it split without end. Depends on the rays before alone, so
/// that nothing is biased.
constexpr uint64_t kMostSplitRays = 1u << 16;
constexpr float kLongPathChance = 0.95f;
/// Beyond the vertices that have strata.
constexpr std::size_t kNoStrata = std::numeric_limits<std::size_t>::max();

}  // namespace

PathSettings settle(const AWDRenderDesc& desc) {
  const auto check = [](int32_t value, int32_t most, const char* name) {
    if (value < 0 || value > most) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s is %d: 0 to %d are known", name, value, most);
    }
  };
  check(desc.preset, AWD_PRESET_PAPER, "preset");
  check(desc.guide, AWD_GUIDE_UNIFORM, "guide");
  check(desc.direct, AWD_DIRECT_NONE, "direct");
  check(desc.roulette, AWD_ROULETTE_ADJOINT, "roulette");
  check(desc.points, AWD_POINTS_SOBOL, "points");
  check(desc.lights, AWD_LIGHTS_LEARNED, "lights");
  if (desc.shadowRays > kMostShadowRays) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->shadowRays is %u: at most %u are allowed",
         desc.shadowRays, kMostShadowRays);
  }
  if (desc.roulette == AWD_ROULETTE_ADJOINT && desc.guide != AWD_GUIDE_ADAPTIVE) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->roulette is AWD_ROULETTE_ADJOINT: it goes by what a field has learned, and "
         "desc->guide is not AWD_GUIDE_ADAPTIVE");
  }
  if (desc.lights == AWD_LIGHTS_LEARNED && desc.guide != AWD_GUIDE_ADAPTIVE) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->lights is AWD_LIGHTS_LEARNED: a field learns them, and desc->guide is not "
         "AWD_GUIDE_ADAPTIVE");
  }
  const bool paper = desc.preset == AWD_PRESET_PAPER;
  PathSettings settings;
  settings.guide = desc.guide;
  settings.direct = desc.direct ? desc.direct : paper ? AWD_DIRECT_AREA : AWD_DIRECT_WEIGHTED;
  // Uniform sampling has weights up to 2 albedo: roulette by albedo alone lets them multiply to
  // an infinite variance from albedo 3/4 on (second moment 4 albedo / 3 a vertex).
  const bool spread = desc.guide == AWD_GUIDE_UNIFORM && !paper;
  settings.roulette = desc.roulette                                ? desc.roulette
                      : spread                                     ? AWD_ROULETTE_THROUGHPUT
                      : desc.guide == AWD_GUIDE_ADAPTIVE && !paper ? AWD_ROULETTE_ADJOINT
                                                                   : AWD_ROULETTE_ALBEDO;
  settings.shadowRays = desc.shadowRays ? desc.shadowRays : paper ? kPaperShadowRays : 1;
  settings.maxLights = desc.maxLights ? desc.maxLights : paper ? kPaperMaxLights : kMaxLights;
  settings.maxSplit = settleSplit(desc.maxSplit, "desc->maxSplit");
  settings.learnLights = desc.guide == AWD_GUIDE_ADAPTIVE &&
                         (desc.lights ? desc.lights == AWD_LIGHTS_LEARNED : !paper);
  settings.sobol = desc.points ? desc.points == AWD_POINTS_SOBOL : !paper;
  return settings;
}

PathTracer::PathTracer(const Geometry& geometry, Field* field, const PathSettings& settings)
    : geometry_(geometry),
      field_(field),
      settings_(settings),
      chooseByPower_(geometry.lights().size() > settings.maxLights),
      learnLights_(settings.learnLights && field && chooseByPower_ &&
                   field->lights() == geometry.lights().groups()) {
  for (uint32_t c = 1; c * c <= settings.shadowRays; ++c) {
    if (settings.shadowRays % c == 0) gridColumns_ = c;
  }
}

Rgb PathTracer::trace(Vec3f origin, Vec3f direction, PathPoints& points, float expected) {
  splitsUntil_ = rays_ + kMostSplitRays;
  return arriving({origin, direction, {1.0f, 1.0f, 1.0f}, 0.0f, 1, true}, points, expected);
}

Rgb PathTracer::arriving(const Ray& ray, PathPoints& points, float expected) {
  ++rays_;
  RayHit hit;
  if (!geometry_.embree().intersect(ray.origin, ray.direction, 0.0f,
                                    std::numeric_limits<float>::infinity(), hit)) {
    return {};
  }
  const Triangle& triangle = geometry_.triangle(hit.triangle);
  const Material& material = geometry_.material(triangle);
  const float facing = -dot(triangle.normal, ray.direction);
  const bool front = facing > 0.0f;
  Rgb leaving;
  if (front && triangle.light != kNoLight) {
    const Light& light = geometry_.lights()[triangle.light];
    const float weight = ray.depth == 1 ? 1.0f : emitterWeight(light, hit.t, facing, ray.cosine);
    leaving = material.emission * weight;
  }
  if (!(maxComponent(material.albedo) > 0.0f)) return leaving;

  Surface surface = {
      Geometry::onPlane(triangle, ray.origin + ray.direction * hit.t),
      front ? triangle.normal : -triangle.normal,
      material.albedo,
      triangle.patch | (front ? 0u : AWD_PATCH_BACK),
      {},
  };
  if (field_) {
    if (field_->isSpatial()) {
      surface.patch = field_->findPatch(geometry_.fromFrame(surface.point), surface.normal);
    }
    surface.view = field_->view(surface.patch);
    Field::prefetch(surface.view);
  }
  const std::size_t vertex = ray.stratified ? ray.depth : kNoStrata;
  const SobolPoint choices = points.choices(vertex);
  leaving += directLight(surface, vertex, choices.x, points);
  leaving += indirectLight(ray, surface, choices.y, points, expected);
  return leaving;
}

Rgb PathTracer::indirectLight(const Ray& ray, const Surface& surface, double choice,
                              PathPoints& points, float expected) {
  const float rays = raysToGoOn(ray, surface, expected);
  const uint32_t count = roundedBy(choice, rays);
  Rgb sum;
  for (uint32_t i = 0; i < count; ++i) {
    const bool stratified = ray.stratified && i == 0;
    const Indirect indirect = chooseDirection(surface, stratified ? ray.depth : kNoStrata, points);
    const Rgb weight = surface.albedo * (indirect.weight / rays);
    const Rgb radiance =
        arriving({surface.point + surface.normal * Geometry::kLift, indirect.direction,
                  ray.throughput * weight, indirect.cosine, ray.depth + 1, stratified},
                 points, expected);
    if (field_) {
      // The field learns the luminance of f_r L_i cos(theta).
      const Rgb reflected = surface.albedo * radiance * (indirect.cosine / kPi);
      field_->record(surface.patch, surface.view, indirect.sample,
                     static_cast<double>(luminance(reflected)));
    }
    sum += weight * radiance;
  }
  return sum;
}

float PathTracer::raysToGoOn(const Ray& ray, const Surface& surface, float expected) const {
  float rays = maxComponent(surface.albedo);
  if (settings_.roulette == AWD_ROULETTE_THROUGHPUT) {
    rays = std::min(maxComponent(ray.throughput * surface.albedo), 1.0f);
  } else if (settings_.roulette == AWD_ROULETTE_ADJOINT && surface.view.known && expected > 0.0f) {
    rays = continuation(luminance(ray.throughput), surface.view.mean, expected,
                        static_cast<float>(settings_.maxSplit));
  }
  if (rays_ >= splitsUntil_) rays = std::min(rays, 1.0f);
  return ray.depth > kLongPath ? std::min(rays, kLongPathChance) : rays;
}

PathTracer::Indirect PathTracer::chooseDirection(const Surface& surface, std::size_t vertex,
                                                 PathPoints& points) const {
  const SobolPoint point = points.direction(vertex);
  const double uniforms[3] = {point.x, point.y, points.next()};
  Indirect indirect = {};
  if (field_) {
    indirect.sample = field_->sample(surface.view, surface.normal, uniforms);
    indirect.direction = load(indirect.sample.direction);
    indirect.cosine = std::max(dot(indirect.direction, surface.normal), 0.0f);
    indirect.weight = indirect.cosine / (kPi * indirect.sample.pdf);
    if (surface.view.statistics) surface.view.statistics->prefetch(indirect.sample);
    return indirect;
  }
  const auto u = static_cast<float>(uniforms[0]);
  const auto v = static_cast<float>(uniforms[1]);
  Vec3f local;
  if (settings_.guide == AWD_GUIDE_COSINE) {
    local = mapToHemisphere(AWD_MAP_CONCENTRIC_COSINE, u, v).direction;
    indirect.weight = 1.0f;
  } else {
    const float radius = std::sqrt(std::max(1.0f - u * u, 0.0f));
    local = {radius * std::cos(2.0f * kPi * v), radius * std::sin(2.0f * kPi * v), u};
    indirect.weight = 2.0f * u;
  }
  indirect.direction = Frame(surface.normal).toWorld(local);
  indirect.cosine = local.z;
  return indirect;
}

Rgb PathTracer::directLight(const Surface& surface, std::size_t vertex, double choice,
                            PathPoints& points) {
  if (settings_.direct == AWD_DIRECT_NONE) return {};
  const Lights& lights = geometry_.lights();
  const uint32_t rays = settings_.shadowRays;
  const uint32_t gridRows = rays / gridColumns_;
  Rgb sum;
  const auto jittered = [&](const Light& light, uint32_t i) {
    const uint32_t column = i % gridColumns_;
    const uint32_t row = i / gridColumns_;
    const double u = (column + points.next()) / gridColumns_;
    const double v = (row + points.next()) / gridRows;
    sum += oneShadowRay(surface, light, 1.0f, u, v);
  };
  if (chooseByPower_) {
    for (uint32_t i = 0; i < rays; ++i) {
      const double uniform = (i + (i > 0 ? points.next() : choice)) / rays;
      const SobolPoint at = points.light(i > 0 ? kNoStrata : vertex);
      if (learnLights_) {
        sum += learnedLight(surface, uniform, at);
      } else {
        const Light& light = lights[lights.choose(uniform)];
        sum += oneShadowRay(surface, light, light.choice, at.x, at.y);
      }
    }
  } else if (rays == 1 && lights.size() == 1) {
    const SobolPoint at = points.light(vertex);
    sum = oneShadowRay(surface, lights[0], 1.0f, at.x, at.y);
  } else {
    for (uint32_t l = 0; l < lights.size(); ++l) {
      for (uint32_t i = 0; i < rays; ++i) jittered(lights[l], i);
    }
  }
  return surface.albedo * sum * (1.0f / static_cast<float>(rays));
}

Rgb PathTracer::learnedLight(const Surface& surface, double choice, SobolPoint at) {
  const Lights& lights = geometry_.lights();
  const LightChoice::Chosen group = surface.view.lights->choose(choice);
  const Light& light = lights[lights.chooseIn(group.light, group.rest)];
  // Weighed against indirect rays by its power, whatever chose it: what the field learns of
  // directions must not change with what it knows of lights.
  const Rgb found =
      oneShadowRay(surface, light, light.choice, at.x, at.y) * lights.groupChance(group.light);
  field_->recordLight(surface.patch, surface.view, group.light,
                      static_cast<double>(luminance(surface.albedo * found)));
  return found * (1.0f / group.chance);
}

Rgb PathTracer::oneShadowRay(const Surface& surface, const Light& light, float choice, double u,
                             double v) {
  const Vec3f point = geometry_.lights().sample(light, u, v);
  const Vec3f towards = point - surface.point;
  const float distance2 = dot(towards, towards);
  const float distance = std::sqrt(distance2);
  if (!(distance > 0.0f)) return {};
  const Vec3f direction = towards * (1.0f / distance);
  const float cosine = dot(direction, surface.normal);
  const float cosineAtLight = -dot(direction, light.normal);
  if (cosine <= 0.0f || cosineAtLight <= 0.0f) return {};
  ++rays_;
  ++shadowRays_;
  // Both ends are lifted off their surfaces, so that the segment between them is all that can hide
  // the light: no relative epsilon that would leak through what stands close to it.
  const Vec3f from = surface.point + surface.normal * Geometry::kLift;
  const Vec3f to = point + light.normal * Geometry::kLift;
  if (geometry_.embree().occluded(from, to - from, 0.0f, 1.0f)) return {};
  const float areaPdf = choice * distance2 / (cosineAtLight * light.area);  // in solid angle
  const float divisor =
      settings_.direct == AWD_DIRECT_AREA ? areaPdf : areaPdf + cosine / kPi;  // balance heuristic
  return light.emission * (cosine / (kPi * divisor));
}

float PathTracer::emitterWeight(const Light& light, float distance, float cosineAtLight,
                                float cosineBefore) const {
  if (settings_.direct == AWD_DIRECT_AREA) return 0.0f;
  if (settings_.direct == AWD_DIRECT_NONE) return 1.0f;
  const float areaPdf = choiceOf(light) * distance * distance / (cosineAtLight * light.area);
  const float cosinePdf = cosineBefore / kPi;
  return cosinePdf > 0.0f ? cosinePdf / (cosinePdf + areaPdf) : 0.0f;
}

}  // namespace awd
