// SPDX-License-Identifier: Apache-2.0
#include "host_scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene_loader.h"
#include "support/handles.h"

namespace bench::host {
namespace {

using awdtest::cross;
using awdtest::dot;
using awdtest::must;

/// Of the scene's size: above what rounding to floats moves a point by.
constexpr double kLift = 0x1p-20;

AWDRay rayOf(Vec origin, Vec direction, float end) {
  AWDRay ray = {};
  store(origin, ray.origin);
  store(direction, ray.direction);
  ray.tfar = end;
  return ray;
}

}  // namespace

double luminance(Vec color) { return 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z; }

Vec operator*(Vec a, Vec b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

Vec toVec(const float values[3]) { return {values[0], values[1], values[2]}; }

void store(Vec v, float values[3]) {
  values[0] = static_cast<float>(v.x);
  values[1] = static_cast<float>(v.y);
  values[2] = static_cast<float>(v.z);
}

Scene::Scene(const LoadedScene& loaded)
    : scene_(loaded.scene.get()),
      data_(command::loadScene(loaded.file)),
      width_(loaded.camera.width),
      height_(loaded.camera.height) {
  must(awdGetSceneInfo(scene_, &info_));
  const Vec size = toVec(info_.upper) - toVec(info_.lower);
  lift_ = kLift * std::max({size.x, size.y, size.z});

  eye_ = toVec(loaded.camera.eye);
  forward_ = normalise(toVec(loaded.camera.lookDir));
  const double halfWidth = loaded.camera.tanHalfFovX;
  const Vec right = normalise(cross(forward_, toVec(loaded.camera.up)));
  right_ = halfWidth * right;
  up_ = halfWidth * height_ / width_ * cross(right, forward_);

  double power = 0.0;
  for (const command::Mesh& mesh : data_.meshes) {
    const Vec emission = toVec(data_.materials[mesh.material].emission.data());
    if (!(luminance(emission) > 0.0)) continue;
    brightest_ = std::max(brightest_, luminance(emission));
    for (const auto& triangle : mesh.triangles) {
      const Vec origin = toVec(mesh.vertices[triangle[0]].data());
      const Vec edge1 = toVec(mesh.vertices[triangle[1]].data()) - origin;
      const Vec edge2 = toVec(mesh.vertices[triangle[2]].data()) - origin;
      const Vec normal = cross(edge1, edge2);
      if (!(length(normal) > 0.0)) continue;
      power += 0.5 * length(normal) * luminance(emission);
      lights_.push_back({origin, edge1, edge2, normalise(normal), emission});
      cumulative_.push_back(power);
    }
  }
}

Vec Scene::lookThrough(double x, double y) const {
  return normalise(forward_ + (2.0 * x / width_ - 1.0) * right_ + (1.0 - 2.0 * y / height_) * up_);
}

bool Scene::intersect(Vec origin, Vec direction, Place& place) const {
  const AWDRay ray = rayOf(origin, direction, std::numeric_limits<float>::infinity());
  AWDHit hit;
  must(awdIntersect(scene_, &ray, 1, &hit));
  if (hit.mesh == AWD_INVALID_ID) return false;
  const command::Material& material = data_.materials[hit.material];
  const command::Mesh& mesh = data_.meshes[hit.mesh];
  const auto& corners = mesh.triangles[hit.triangle];
  const auto corner = [&](std::size_t i) { return toVec(mesh.vertices[corners[i]].data()); };
  const double u = hit.u, v = hit.v;
  place.position = (1.0 - u - v) * corner(0) + u * corner(1) + v * corner(2);
  place.albedo = toVec(material.albedo.data());
  place.normal = toVec(hit.normal);
  place.emission = {};
  place.emissionPdf = 0.0;
  if (dot(place.normal, direction) < 0.0) {
    place.emission = toVec(material.emission.data());
    place.emissionPdf = cumulative_.empty() ? 0.0 : luminance(place.emission) / cumulative_.back();
  } else {
    place.normal = -1.0 * place.normal;
  }
  return true;
}

bool Scene::isHidden(const Place& from, const LightPoint& light) const {
  const Vec start = lifted(from.position, from.normal);
  const Vec end = lifted(light.position, light.normal);
  const AWDRay ray = rayOf(start, end - start, 1.0f);
  uint8_t hidden = 0;
  must(awdOccluded(scene_, &ray, 1, &hidden));
  return hidden != 0;
}

LightPoint Scene::sampleLight(double choice, double u, double v) const {
  const auto found =
      std::upper_bound(cumulative_.begin(), cumulative_.end(), choice * cumulative_.back());
  const auto index = static_cast<std::size_t>(found - cumulative_.begin());
  const Light& light = lights_[std::min(index, lights_.size() - 1)];
  const double root = std::sqrt(u);
  return {light.origin + root * (1.0 - v) * light.edge1 + root * v * light.edge2, light.normal,
          light.emission, luminance(light.emission) / cumulative_.back()};
}

}  // namespace bench::host
