// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "util/error.h"

namespace awd {

namespace {

/// A ray in the scene's frame whose direction has a largest component within 1/2 and 1, so that
/// Embree sees it: it takes components below 1e-18 for 1e-18. t in it is t of the ray times
/// 2^power.
struct TracedRay {
  Vec3f direction;
  int power;
  float tnear, tfar;

  TracedRay(const AWDRay& ray, double scale) {
    const Vec3d d = convert<double>(load(ray.direction)) * scale;
    static_cast<void>(
        std::frexp(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}), &power));
    direction = convert<float>(d * std::ldexp(1.0, -power));
    tnear = std::ldexp(ray.tnear, power);
    tfar = std::ldexp(std::min(ray.tfar, std::numeric_limits<float>::max()), power);
  }
};

}  // namespace

Ref<Scene> Scene::make(Ref<Device> device) {
  std::pmr::memory_resource* memory = device->context().memory();
  return Ref<Scene>::adopt(awd::make<Scene>(memory, std::move(device)));
}

Scene::Scene(Ref<Device> device)
    : device_(std::move(device)),
      materials_(device_->context().memory()),
      meshes_(device_->context().memory()) {}

void Scene::destroy() noexcept {
  const Ref<Device> device = device_;  // the memory outlives the scene
  unmake(device->context().memory(), this);
}

uint32_t Scene::addMaterial(const AWDMaterialDesc& desc) {
  const Rgb albedo = load(desc.albedo);
  const Rgb emission = load(desc.emission);
  const auto within = [](Rgb c, float most) {
    return c.x >= 0.0f && c.y >= 0.0f && c.z >= 0.0f && c.x <= most && c.y <= most && c.z <= most;
  };
  if (!within(albedo, 1.0f)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->albedo is (%g, %g, %g): it must be within 0 and 1",
         albedo.x, albedo.y, albedo.z);
  }
  if (!within(emission, std::numeric_limits<float>::max())) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->emission is (%g, %g, %g): it must be finite and not negative", emission.x,
         emission.y, emission.z);
  }
  materials_.push_back({albedo, emission});
  return static_cast<uint32_t>(materials_.size() - 1);
}

uint32_t Scene::addMesh(const AWDMeshDesc& desc) {
  meshes_.emplace_back(device_->context().memory(), desc);
  return static_cast<uint32_t>(meshes_.size() - 1);
}

void Scene::commit() {
  geometry_ = Geometry::build(device_->shareContext(), this, meshes_, materials_);
  const AWDSceneInfo info = geometry_->info();
  if (info.skipped > 0) {
    device_->context().log(AWD_LOG_WARNING, "%llu of %llu triangles have no area and were skipped",
                           static_cast<unsigned long long>(info.skipped),
                           static_cast<unsigned long long>(info.triangles));
  }
  if (info.triangles == info.skipped) {
    device_->context().log(AWD_LOG_WARNING, "the scene is empty: images of it are black");
  } else if (info.lights == 0) {
    device_->context().log(AWD_LOG_WARNING, "the scene has no light: images of it are black");
  }
}

const Geometry& Scene::geometry() const {
  if (!geometry_) fail(AWD_ERROR_INVALID_OPERATION, "the scene is not committed: awdCommitScene");
  return *geometry_;
}

Ref<Geometry> Scene::shareGeometry() const {
  geometry();
  return geometry_;
}

AWDHit Scene::intersect(const AWDRay& ray) const {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  AWDHit miss = {kInfinity,      {0.0f, 0.0f, 0.0f}, 0.0f,           0.0f,
                 AWD_INVALID_ID, AWD_INVALID_ID,     AWD_INVALID_ID, AWD_INVALID_ID};
  const Geometry& g = geometry();
  const TracedRay traced(ray, g.scale());
  RayHit hit;
  if (ray.tnear > ray.tfar) return miss;
  if (!g.embree().intersect(g.toFrame(load(ray.origin)), traced.direction, traced.tnear,
                            traced.tfar, hit)) {
    return miss;
  }
  const Triangle& triangle = g.triangle(hit.triangle);
  const Geometry::Source source = g.source(triangle);
  const bool back = dot(triangle.normal, traced.direction) > 0.0f;
  return {std::ldexp(hit.t, -traced.power),
          {triangle.normal.x, triangle.normal.y, triangle.normal.z},
          hit.u,
          hit.v,
          source.mesh,
          source.triangle,
          triangle.material,
          triangle.patch | (back ? AWD_PATCH_BACK : 0u)};
}

bool Scene::occluded(const AWDRay& ray) const {
  const Geometry& g = geometry();
  // Embree tells by a negative tfar that it met something.
  if (ray.tnear > ray.tfar) return false;
  const TracedRay traced(ray, g.scale());
  return g.embree().occluded(g.toFrame(load(ray.origin)), traced.direction, traced.tnear,
                             traced.tfar);
}

uint32_t Scene::pointPatch(Vec3f point) const {
  const Geometry& g = geometry();
  const Vec3f p = g.toFrame(point);
  const uint32_t nearest = g.embree().nearest(p);
  if (nearest == AWD_INVALID_ID) return AWD_INVALID_ID;
  const Triangle& triangle = g.triangle(nearest);
  const bool back = dot(triangle.normal, p) < triangle.planeOffset - Geometry::kLift;
  return triangle.patch | (back ? AWD_PATCH_BACK : 0u);
}

}  // namespace awd
