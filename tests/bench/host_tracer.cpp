// SPDX-License-Identifier: Apache-2.0
#include "host_tracer.h"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "support/random.h"

namespace bench::host {
namespace {

using awdtest::dot;
using awdtest::Random;

constexpr double kPi = 3.14159265358979323846;
/// From here on even a white surface ends paths.
constexpr std::size_t kLongPath = 64;
constexpr double kLongPathChance = 0.95;

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Tracer {
 public:
  Tracer(const Scene& scene, Guide* guide, PathLength& length)
      : scene_(scene), guide_(guide), length_(length) {}

  /// What arrives at the camera from a direction.
  Vec trace(Vec direction, std::size_t pixel, Random& random, bool learns);
  uint64_t rays() const { return rays_; }

 private:
  Vec emittedAt(const Place& place, Vec origin, Vec direction, double cosineBefore) const;
  Vec directLight(const Place& place, const double uniforms[3]);
  /// What the path at hand tells about the radiance to come.
  void learnLength();

  const Scene& scene_;
  Guide* guide_;
  PathLength& length_;
  Path path_;
  uint64_t rays_ = 0;
};

/// Emission as an indirect ray counts it: the balance heuristic, of the cosine's pdf.
Vec Tracer::emittedAt(const Place& place, Vec origin, Vec direction, double cosineBefore) const {
  if (path_.vertices.empty() || !(place.emissionPdf > 0.0)) return place.emission;
  const Vec way = place.position - origin;
  const double lightPdf = place.emissionPdf * dot(way, way) / -dot(place.normal, direction);
  const double cosinePdf = cosineBefore / kPi;
  return cosinePdf / (cosinePdf + lightPdf) * place.emission;
}

Vec Tracer::directLight(const Place& place, const double uniforms[3]) {
  if (!scene_.hasLights()) return {};
  const LightPoint light = scene_.sampleLight(uniforms[0], uniforms[1], uniforms[2]);
  const Vec way = light.position - place.position;
  const double distance = length(way);
  if (!(distance > 0.0)) return {};
  const double cosine = dot(way, place.normal) / distance;
  const double cosineAtLight = -dot(way, light.normal) / distance;
  if (cosine <= 0.0 || cosineAtLight <= 0.0) return {};
  ++rays_;
  if (scene_.isHidden(place, light)) return {};
  const double lightPdf = light.pdf * distance * distance / cosineAtLight;
  return cosine / (kPi * (lightPdf + cosine / kPi)) * (place.albedo * light.emission);
}

void Tracer::learnLength() {
  Vec incoming;  // what arrives at the vertex from the next one
  for (std::size_t i = path_.vertices.size(); i-- > 0;) {
    const AWDPathVertex& vertex = path_.vertices[i];
    Vec leaving = toVec(vertex.emitted) + toVec(vertex.direct);
    if (vertex.continuation > 0.0f && vertex.sample.pdf > 0.0f) {
      const Vec reflected =
          1.0 / static_cast<double>(vertex.sample.pdf) * (toVec(vertex.scattering) * incoming);
      length_.learn(path_.places[i], luminance(reflected));
      leaving = leaving + 1.0 / static_cast<double>(vertex.continuation) * reflected;
    }
    incoming = leaving;
  }
}

Vec Tracer::trace(Vec direction, std::size_t pixel, Random& random, bool learns) {
  path_.places.clear();
  path_.before.clear();
  path_.vertices.clear();
  Vec radiance, throughput = {1.0, 1.0, 1.0};
  Vec origin = scene_.eye();
  double cosine = 0.0;
  Place place;
  for (;;) {
    ++rays_;
    if (!scene_.intersect(origin, direction, place)) break;
    AWDPathVertex vertex = {};
    vertex.patch = AWD_INVALID_ID;
    const Vec emitted = emittedAt(place, origin, direction, cosine);
    const double light[3] = {random.uniform(), random.uniform(), random.uniform()};
    const Vec direct = directLight(place, light);
    radiance = radiance + throughput * (emitted + direct);
    store(emitted, vertex.emitted);
    store(direct, vertex.direct);

    double chance = length_.chance(place, throughput, pixel);
    if (path_.vertices.size() >= kLongPath) chance = std::min(chance, kLongPathChance);
    const bool goesOn = random.uniform() < chance;
    if (goesOn) {
      const double uniforms[3] = {random.uniform(), random.uniform(), random.uniform()};
      if (guide_) {
        guide_->choose(place, uniforms, vertex);
      } else {
        chooseByCosine(place, uniforms[0], uniforms[1], vertex);
      }
    }
    path_.before.push_back(-1.0 * direction);
    if (goesOn) {
      direction = toVec(vertex.sample.direction);
      cosine = std::max(dot(direction, place.normal), 0.0);
      const Vec scattering = cosine / kPi * place.albedo;
      vertex.continuation = static_cast<float>(chance);
      store(scattering, vertex.scattering);
      throughput =
          1.0 / (static_cast<double>(vertex.sample.pdf) * chance) * (throughput * scattering);
      origin = scene_.lifted(place.position, place.normal);
    }
    path_.places.push_back(place);
    path_.vertices.push_back(vertex);
    // A direction below the surface, or of pdf 0, brings nothing.
    if (!goesOn || !(cosine > 0.0 && vertex.sample.pdf > 0.0f)) break;
  }
  if (learns) guide_->learn(path_);
  if (learns && length_.learns()) learnLength();
  return radiance;
}

std::vector<Vec> scaled(std::vector<Vec> values, double factor) {
  for (Vec& value : values) value = factor * value;
  return values;
}

/// 1, 1, 1, 2, 2, 2, 4, .., and to the last what would be no pass of its own.
std::vector<uint32_t> passesOf(uint32_t samples, bool learns) {
  std::vector<uint32_t> passes;
  if (!learns) return {samples};
  for (uint32_t left = samples; left > 0; left -= passes.back()) {
    const uint32_t size = uint32_t{1} << std::min<std::size_t>(passes.size() / 3, 30);
    passes.push_back(left < 2 * size ? left : size);
  }
  return passes;
}

}  // namespace

void chooseByCosine(const Place& place, double u, double v, AWDPathVertex& vertex) {
  const double height = std::sqrt(1.0 - u);
  const awdtest::Frame frame(place.normal);
  const double radius = std::sqrt(u), phi = 2.0 * kPi * v;
  store(radius * std::cos(phi) * frame.s + radius * std::sin(phi) * frame.t + height * frame.n,
        vertex.sample.direction);
  vertex.sample.pdf = static_cast<float>(height / kPi);
}

bool render(const Scene& scene, const AWDCamera& camera, Guide* guide, Roulette roulette,
            uint32_t samples, uint64_t seed, Cancelled cancelled, Picture& picture) {
  const double start = cpuSeconds();
  const std::size_t pixels = std::size_t{camera.width} * camera.height;
  std::vector<Vec> sums(pixels);
  PathLength length(scene, guide ? roulette : Roulette::kAlbedo, camera.width);
  Tracer tracer(scene, guide, length);
  double weights = 0.0;
  uint32_t before = 0;
  for (const uint32_t passSamples : passesOf(samples, guide != nullptr)) {
    if (guide && before > 0) guide->adapt();
    if (length.learns() && before > 0) length.adapt(scaled(sums, 1.0 / weights));
    const bool learns = guide && before + passSamples < samples;  // nobody learns from the last
    // A sample counts for less while little has been learned.
    const double weight = guide ? (before + 2.0) / (before + 8.0) : 1.0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      if (pixel % camera.width == 0 && cancelled()) return false;
      const std::size_t row = pixel / camera.width;
      const auto x = static_cast<double>(pixel % camera.width);
      const auto y = static_cast<double>(row);
      for (uint32_t i = before; i < before + passSamples; ++i) {
        Random random(Random(Random(seed).bits() ^ pixel).bits() ^ i);
        const double u = random.uniform(), v = random.uniform();
        sums[pixel] = sums[pixel] +
                      weight * tracer.trace(scene.lookThrough(x + u, y + v), pixel, random, learns);
      }
    }
    weights += weight * passSamples;
    before += passSamples;
  }
  picture.pixels.resize(3 * pixels);
  const std::vector<Vec> image = scaled(sums, 1.0 / weights);
  for (std::size_t i = 0; i < pixels; ++i) store(image[i], &picture.pixels[3 * i]);
  picture.cpuSeconds = cpuSeconds() - start;
  picture.rays = tracer.rays();
  return true;
}

}  // namespace bench::host
