// SPDX-License-Identifier: Apache-2.0
#include "awd/scene.h"

#include <cmath>

#include "api/handles.h"
#include "basis/device.h"
#include "render/scene.h"

using namespace awd;

namespace {

void checkRay(const Geometry& geometry, const AWDRay& ray, size_t index) {
  const Vec3f origin = load(ray.origin), direction = load(ray.direction);
  if (isFinite(origin) && isFinite(direction) && ray.tnear >= 0.0f && std::isfinite(ray.tnear) &&
      !std::isnan(ray.tfar)) {
    if (Embree::takes(geometry.toFrame(origin)) &&
        Embree::takes(convert<float>(convert<double>(direction) * geometry.scale()))) {
      return;
    }
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "rays[%zu] has origin (%g, %g, %g), direction (%g, %g, %g): more than 1e18 times the size "
         "of the scene",
         index, origin.x, origin.y, origin.z, direction.x, direction.y, direction.z);
  }
  fail(AWD_ERROR_INVALID_ARGUMENT,
       "rays[%zu] has origin (%g, %g, %g), direction (%g, %g, %g), tnear %g, tfar %g: NaN is not "
       "allowed, infinity only in tfar, and tnear not below 0",
       index, origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, ray.tnear,
       ray.tfar);
}

/// Nothing is written unless all rays are good.
template <class Output>
const Geometry& checkRays(AWDScene scene, const AWDRay* rays, size_t count, Output* output,
                          const char* outputName) {
  const Geometry& geometry = object(scene, "scene").geometry();
  if (count > 0) {
    need(rays, "rays");
    need(output, outputName);
  }
  for (size_t i = 0; i < count; ++i) checkRay(geometry, rays[i], i);
  return geometry;
}

}  // namespace

extern "C" {

AWDResult AWD_CALL awdNewScene(AWDDevice device, AWDScene* scene) noexcept {
  return guard(__func__, [&] {
    clearOutput(scene, "scene");
    give(scene, Scene::make(Ref<Device>::share(&object(device, "device"))));
  });
}

void AWD_CALL awdRetainScene(AWDScene scene) noexcept {
  if (scene) behind(scene)->retain();
}

void AWD_CALL awdReleaseScene(AWDScene scene) noexcept {
  if (scene) behind(scene)->release();
}

AWDResult AWD_CALL awdAddMaterial(AWDScene scene, const AWDMaterialDesc* desc,
                                  uint32_t* material) noexcept {
  return guard(__func__, [&] {
    const uint32_t number =
        idle(scene, "scene").addMaterial(readStruct(desc, "desc", "AWD_MATERIAL_DESC_INIT"));
    if (material) *material = number;
  });
}

AWDResult AWD_CALL awdAddMesh(AWDScene scene, const AWDMeshDesc* desc, uint32_t* mesh) noexcept {
  return guard(__func__, [&] {
    const uint32_t number =
        idle(scene, "scene").addMesh(readStruct(desc, "desc", "AWD_MESH_DESC_INIT"));
    if (mesh) *mesh = number;
  });
}

AWDResult AWD_CALL awdCommitScene(AWDScene scene) noexcept {
  return guard(__func__, [&] {
    const AtWork<Scene> known(&object(scene, "scene"), "scene");
    known->commit();
  });
}

AWDResult AWD_CALL awdGetSceneInfo(AWDScene scene, AWDSceneInfo* info) noexcept {
  return guard(__func__, [&] {
    writeStruct(info, object(scene, "scene").geometry().info(), "info", "AWD_SCENE_INFO_INIT");
  });
}

AWDResult AWD_CALL awdIntersect(AWDScene scene, const AWDRay* rays, size_t count,
                                AWDHit* hits) noexcept {
  return guard(__func__, [&] {
    checkRays(scene, rays, count, hits, "hits");
    for (size_t i = 0; i < count; ++i) hits[i] = behind(scene)->intersect(rays[i]);
  });
}

AWDResult AWD_CALL awdOccluded(AWDScene scene, const AWDRay* rays, size_t count,
                               uint8_t* occluded) noexcept {
  return guard(__func__, [&] {
    checkRays(scene, rays, count, occluded, "occluded");
    for (size_t i = 0; i < count; ++i) occluded[i] = behind(scene)->occluded(rays[i]) ? 1 : 0;
  });
}

AWDResult AWD_CALL awdGetTrianglePatch(AWDScene scene, uint32_t mesh, uint32_t triangle,
                                       int32_t back, uint32_t* patch) noexcept {
  return guard(__func__, [&] {
    const Geometry& geometry = object(scene, "scene").geometry();
    const uint32_t found = geometry.find(mesh, triangle);
    *need(patch, "patch") = found == AWD_INVALID_ID
                                ? AWD_INVALID_ID
                                : geometry.triangle(found).patch | (back ? AWD_PATCH_BACK : 0u);
  });
}

AWDResult AWD_CALL awdGetPointPatch(AWDScene scene, const float point[3],
                                    uint32_t* patch) noexcept {
  return guard(__func__, [&] {
    const Vec3f p = load(need(point, "point"));
    if (!isFinite(p)) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "point is (%g, %g, %g): it must be finite", p.x, p.y, p.z);
    }
    const Scene& known = object(scene, "scene");
    if (!Embree::takes(known.geometry().toFrame(p))) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "point is (%g, %g, %g): more than 1e18 times the size of the scene", p.x, p.y, p.z);
    }
    *need(patch, "patch") = known.pointPatch(p);
  });
}

}  // extern "C"
