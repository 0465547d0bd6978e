// SPDX-License-Identifier: Apache-2.0
#include "render/path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
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
constexpr float kLongPathChance = 0.95f;
/// Roulette by what is to come: survivors carry about 1 / kAdjointFactor of what the pixel is
/// expected to have, and one in 1 / kLeastChance goes on in any case.
constexpr float kAdjointFactor = 3.0f;
constexpr float kLeastChance = 0.1f;

}  // namespace

PathSettings settle(const AWDRenderDesc& desc) {
  const auto check = [](int32_t value, int32_t most, const char* name) {
    if (value < 0 || value > most) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s is %d: 0 to %d are known", name, value, most);
    }
  };
  check(desc.preset, AWD_PRESET_PAPER, "preset");
  check(desc.guide, AWD_GUIDE_UNIFORM, "guide");
  check(desc.direct, AWD_DIRECT_WEIGHTED, "direct");
  check(desc.roulette, AWD_ROULETTE_ADJOINT, "roulette");
  check(desc.points, AWD_POINTS_SOBOL, "points");
  if (desc.shadowRays > kMostShadowRays) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->shadowRays is %u: at most %u are allowed",
         desc.shadowRays, kMostShadowRays);
  }
  if (desc.roulette == AWD_ROULETTE_ADJOINT && desc.guide != AWD_GUIDE_ADAPTIVE) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->roulette is AWD_ROULETTE_ADJOINT: it goes by what a field has learned, and "
         "desc->guide is not AWD_GUIDE_ADAPTIVE");
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
  settings.sobol = desc.points ? desc.points == AWD_POINTS_SOBOL : !paper;
  return settings;
}

PathTracer::PathTracer(std::pmr::memory_resource* memory, const Geometry& geometry, Field* field,
                       const PathSettings& settings)
    : geometry_(geometry),
      field_(field),
      settings_(settings),
      chooseByPower_(geometry.lights().size() > settings.maxLights),
      path_(memory) {
  path_.reserve(kLongPath);
  for (uint32_t c = 1; c * c <= settings.shadowRays; ++c) {
    if (settings.shadowRays % c == 0) gridColumns_ = c;
  }
}

Rgb PathTracer::trace(Vec3f origin, Vec3f direction, PathPoints& points, float expected) {
  path_.clear();
  Rgb throughput = {1.0f, 1.0f, 1.0f};
  for (;;) {
    ++rays_;
    RayHit hit;
    if (!geometry_.embree().intersect(origin, direction, 0.0f,
                                      std::numeric_limits<float>::infinity(), hit)) {
      break;
    }
    const Triangle& triangle = geometry_.triangle(hit.triangle);
    const Material& material = geometry_.material(triangle);
    const float facing = -dot(triangle.normal, direction);
    const bool front = facing > 0.0f;

    Vertex& vertex = path_.emplace_back();
    if (front && triangle.light != kNoLight) {
      const float weight = path_.size() == 1
                               ? 1.0f
                               : emitterWeight(geometry_.lights()[triangle.light], hit.t, facing,
                                               path_[path_.size() - 2].cosine);
      vertex.emitted = material.emission * weight;
    }
    if (!(maxComponent(material.albedo) > 0.0f)) break;

    const Surface surface = {
        Geometry::onPlane(triangle, origin + direction * hit.t),
        front ? triangle.normal : -triangle.normal,
        material.albedo,
    };
    vertex.albedo = material.albedo;
    vertex.patch = triangle.patch | (front ? 0u : AWD_PATCH_BACK);
    PatchView& patch = vertex.view;
    if (field_) {
      if (field_->isSpatial()) {
        vertex.patch = field_->findPatch(geometry_.fromFrame(surface.point), surface.normal);
      }
      patch = field_->view(vertex.patch);
      Field::prefetch(patch);
    }
    const SobolPoint choices = points.choices(path_.size());
    vertex.direct = directLight(surface, choices.x, points);

    const float chance = chanceToGoOn(path_.size(), throughput, material.albedo, patch, expected);
    if (!(choices.y < chance)) break;  // nor on a chance that is NaN
    const Indirect indirect = chooseDirection(surface, patch, points);
    vertex.sample = indirect.sample;
    vertex.cosine = indirect.cosine;
    vertex.weight = material.albedo * (indirect.weight / chance);
    vertex.goesOn = true;
    throughput = throughput * vertex.weight;
    origin = surface.point + surface.normal * Geometry::kLift;
    direction = indirect.direction;
  }
  return gather();
}

Rgb PathTracer::gather() {
  Rgb radiance;  // leaving the vertex at hand towards the one before it
  for (std::size_t i = path_.size(); i-- > 0;) {
    const Vertex& vertex = path_[i];
    Rgb leaving = vertex.emitted + vertex.direct;
    if (vertex.goesOn) {
      // The field learns the luminance of f_r L_i cos(theta).
      if (field_) {
        const Rgb reflected = vertex.albedo * radiance * (vertex.cosine / kPi);
        field_->record(vertex.patch, vertex.view, vertex.sample,
                       static_cast<double>(luminance(reflected)));
      }
      leaving += vertex.weight * radiance;
    }
    radiance = leaving;
  }
  return radiance;
}

float PathTracer::chanceToGoOn(std::size_t depth, Rgb throughput, Rgb albedo,
                               const PatchView& patch, float expected) const {
  float chance = maxComponent(albedo);
  if (settings_.roulette == AWD_ROULETTE_THROUGHPUT) {
    chance = std::min(maxComponent(throughput * albedo), 1.0f);
  } else if (settings_.roulette == AWD_ROULETTE_ADJOINT && patch.known && expected > 0.0f) {
    chance = std::clamp(kAdjointFactor * luminance(throughput) * patch.mean / expected,
                        kLeastChance, 1.0f);
  }
  if (depth > kLongPath) chance = std::min(chance, kLongPathChance);
  return chance;
}

PathTracer::Indirect PathTracer::chooseDirection(const Surface& surface, const PatchView& patch,
                                                 PathPoints& points) const {
  const SobolPoint point = points.direction(path_.size());
  const double uniforms[3] = {point.x, point.y, points.next()};
  Indirect indirect = {};
  if (field_) {
    indirect.sample = field_->sample(patch, surface.normal, uniforms);
    indirect.direction = load(indirect.sample.direction);
    indirect.cosine = std::max(dot(indirect.direction, surface.normal), 0.0f);
    indirect.weight = indirect.cosine / (kPi * indirect.sample.pdf);
    if (patch.statistics) patch.statistics->prefetch(indirect.sample);
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

Rgb PathTracer::directLight(const Surface& surface, double choice, PathPoints& points) {
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
      const Light& light = lights[lights.choose((i + (i > 0 ? points.next() : choice)) / rays)];
      const SobolPoint at = points.light(i > 0 ? SIZE_MAX : path_.size());
      sum += oneShadowRay(surface, light, light.choice, at.x, at.y);
    }
  } else if (rays == 1 && lights.size() == 1) {
    const SobolPoint at = points.light(path_.size());
    sum = oneShadowRay(surface, lights[0], 1.0f, at.x, at.y);
  } else {
    for (uint32_t l = 0; l < lights.size(); ++l) {
      for (uint32_t i = 0; i < rays; ++i) jittered(lights[l], i);
    }
  }
  return surface.albedo * sum * (1.0f / static_cast<float>(rays));
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
  const float areaPdf = choiceOf(light) * distance * distance / (cosineAtLight * light.area);
  const float cosinePdf = cosineBefore / kPi;
  return cosinePdf > 0.0f ? cosinePdf / (cosinePdf + areaPdf) : 0.0f;
}

}  // namespace awd
