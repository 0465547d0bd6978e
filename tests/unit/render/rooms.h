// SPDX-License-Identifier: Apache-2.0
// Small scenes for the tests of this folder.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "basis/device.h"
#include "render/scene.h"

namespace awd {

constexpr float kFar = std::numeric_limits<float>::infinity();

inline Ref<Device> device(uint32_t threads = 1) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = threads;
  return Device::make(desc, {});
}

/// Triangles as a host would hold them.
struct Soup {
  std::vector<float> vertices;
  std::vector<uint32_t> indices;
  std::vector<uint32_t> materials;

  void triangle(Vec3f a, Vec3f b, Vec3f c, uint32_t material) {
    for (const Vec3f p : {a, b, c}) {
      indices.push_back(static_cast<uint32_t>(vertices.size() / 3));
      vertices.insert(vertices.end(), {p.x, p.y, p.z});
    }
    materials.push_back(material);
  }
  /// Counter-clockwise seen from the front.
  void quad(Vec3f a, Vec3f b, Vec3f c, Vec3f d, uint32_t material) {
    triangle(a, b, c, material);
    triangle(a, c, d, material);
  }
  AWDMeshDesc desc() const {
    AWDMeshDesc mesh = AWD_MESH_DESC_INIT;
    mesh.vertices = {vertices.data(), 0, 0, vertices.size() / 3, AWD_FORMAT_FLOAT3, 0};
    mesh.indices = {indices.data(), 0, 0, indices.size() / 3, AWD_FORMAT_UINT3, 0};
    mesh.materials = {materials.data(), 0, 0, materials.size(), AWD_FORMAT_UINT, 0};
    return mesh;
  }
};

inline AWDMaterialDesc material(float albedo, float emission) {
  AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
  for (int c = 0; c < 3; ++c) {
    desc.albedo[c] = albedo;
    desc.emission[c] = emission;
  }
  return desc;
}

/// A floor of material 0 (albedo 0.5) from -1 to 1 in z = 0, and a lamp of material 1 (emission 10)
/// above it that faces down.
inline Soup floorAndLamp(float scale = 1.0f, Vec3f shift = {}) {
  const auto p = [&](float x, float y, float z) { return Vec3f{x, y, z} * scale + shift; };
  Soup soup;
  soup.quad(p(-1, -1, 0), p(1, -1, 0), p(1, 1, 0), p(-1, 1, 0), 0);
  soup.quad(p(-.25f, -.25f, 1), p(-.25f, .25f, 1), p(.25f, .25f, 1), p(.25f, -.25f, 1), 1);
  return soup;
}

inline Ref<Scene> sceneOf(const Soup& soup, Ref<Device> owner = device()) {
  Ref<Scene> scene = Scene::make(owner);
  scene->addMaterial(material(0.5f, 0.0f));
  scene->addMaterial(material(0.0f, 10.0f));
  scene->addMesh(soup.desc());
  scene->commit();
  return scene;
}

}  // namespace awd
