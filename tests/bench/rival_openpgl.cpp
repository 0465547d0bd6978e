// SPDX-License-Identifier: Apache-2.0
// Open PGL as a guide: one update a pass on one thread, paths by its own recorder.
#include <openpgl/cpp/OpenPGL.h>

#include <algorithm>

#include "rival_methods.h"

namespace bench::rival {
namespace {

struct Settings {
  PGL_DIRECTIONAL_DISTRIBUTION_TYPE kind = PGL_DIRECTIONAL_DISTRIBUTION_PARALLAX_AWARE_VMM;
  double probability = 0.5;  ///< with which a direction is Open PGL's, else by the cosine
  std::size_t leafSamples = PGL_TREE_MAX_SAMPLE_PER_LEAF;
};

pgl_vec3f toPgl(host::Vec v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

pgl_vec3f toPgl(const float v[3]) { return {v[0], v[1], v[2]}; }

/// Rounding to float must not make it 1.
float belowOne(double uniform) { return std::min(static_cast<float>(uniform), 0x1.fffffep-1f); }

class OpenPglGuide : public host::Guide {
 public:
  OpenPglGuide(const Settings& settings, const host::Scene& scene)
      : probability_(settings.probability),
        device_(PGL_DEVICE_TYPE_CPU_8, 1),
        config_(settings),
        field_(&device_, config_.config),
        distribution_(&field_) {
    const AWDSceneInfo& info = scene.info();
    field_.SetSceneBounds({toPgl(info.lower), toPgl(info.upper)});
    segments_.Reserve(kMostSegments + 1);
  }

  void choose(const host::Place& place, const double uniforms[3], AWDPathVertex& vertex) override {
    float ofRegion = belowOne(uniforms[2]);
    if (!distribution_.Init(&field_, toPgl(place.position), ofRegion)) {
      chooseByCosine(place, uniforms[0], uniforms[1], vertex);
      return;
    }
    const bool product = distribution_.SupportsApplyCosineProduct();
    if (product) distribution_.ApplyCosineProduct(toPgl(place.normal));
    AWDDirectionSample& sample = vertex.sample;
    double guided = 0.0;
    if (uniforms[0] < probability_) {
      pgl_vec3f direction;
      guided = distribution_.SamplePDF(
          {belowOne(uniforms[0] / probability_), belowOne(uniforms[1])}, direction);
      host::store({direction.x, direction.y, direction.z}, sample.direction);
    } else {
      const double u = (uniforms[0] - probability_) / (1.0 - probability_);
      chooseByCosine(place, u, uniforms[1], vertex);
      guided = distribution_.PDF(toPgl(sample.direction));
    }
    const double cosine = std::max(dot(host::toVec(sample.direction), place.normal), 0.0);
    sample.pdf = static_cast<float>(probability_ * guided + (1.0 - probability_) * cosine / kPi);
  }

  void learn(const host::Path& path) override {
    segments_.Clear();
    const std::size_t count = std::min(path.vertices.size(), kMostSegments);
    for (std::size_t i = 0; i < count; ++i) {
      const AWDPathVertex& vertex = path.vertices[i];
      const host::Place& place = path.places[i];
      openpgl::cpp::PathSegment& segment = *segments_.NextSegment();
      segment.position = toPgl(place.position);
      segment.normal = toPgl(place.normal);
      segment.directionOut = toPgl(path.before[i]);
      segment.directContribution = toPgl(vertex.emitted);  // with its weight: miWeight is 1
      segment.scatteredContribution = toPgl(vertex.direct);
      segment.russianRouletteSurvivalProbability = vertex.continuation;
      if (!(vertex.continuation > 0.0f && vertex.sample.pdf > 0.0f)) continue;
      segment.directionIn = toPgl(vertex.sample.direction);
      segment.pdfDirectionIn = vertex.sample.pdf;
      segment.scatteringWeight =
          toPgl(1.0 / static_cast<double>(vertex.sample.pdf) * host::toVec(vertex.scattering));
    }
    segments_.PropagateSamples(&samples_, true);
  }

  void adapt() override {
    field_.UpdateSurface(samples_);
    samples_.Clear();
  }

 private:
  static constexpr double kPi = 3.14159265358979323846;
  static constexpr std::size_t kMostSegments = 255;

  struct Config {
    explicit Config(const Settings& settings) {
      config.Init(PGL_SPATIAL_STRUCTURE_KDTREE, settings.kind, false, settings.leafSamples);
    }
    openpgl::cpp::FieldConfig config;
  };

  double probability_;
  openpgl::cpp::Device device_;
  Config config_;
  openpgl::cpp::Field field_;
  openpgl::cpp::SurfaceSamplingDistribution distribution_;
  openpgl::cpp::PathSegmentStorage segments_;
  openpgl::cpp::SampleStorage samples_;
};

Method method(const char* name, const char* what, const Settings& settings) {
  return {name, what, [settings](AWDDevice, const host::Scene& scene) {
            return std::make_unique<OpenPglGuide>(settings, scene);
          }};
}

}  // namespace

std::vector<Method> openPglMethods() {
  const auto parallax = PGL_DIRECTIONAL_DISTRIBUTION_PARALLAX_AWARE_VMM;
  return {
      method("openpgl",
             "Open PGL at its best here: parallax-aware mixtures, regions of 500 samples",
             {parallax, 0.5, 500}),
      method("openpgl-250", "openpgl, regions of 250 samples", {parallax, 0.5, 250}),
      method("openpgl-1000", "openpgl, regions of 1000 samples", {parallax, 0.5, 1000}),
      method("openpgl-0.75", "openpgl, a quarter of the directions by the cosine, not half",
             {parallax, 0.75, 500}),
      method("openpgl-quadtree", "openpgl with quadtrees",
             {PGL_DIRECTIONAL_DISTRIBUTION_QUADTREE, 0.5, 500}),
      method("openpgl-default", "openpgl with its own default, regions of 32,000 samples", {}),
  };
}

}  // namespace bench::rival
