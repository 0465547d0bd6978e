// SPDX-License-Identifier: Apache-2.0
// Small scenes of quads, and cameras to look at them.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/handles.h"
#include "support/vec.h"

namespace awdtest {

using Rgb = std::array<float, 3>;
inline Rgb grey(double value) {
  const float v = static_cast<float>(value);
  return {v, v, v};
}

template <class T>
AWDBuffer bufferOf(const std::vector<T>& items, AWDFormat format, size_t perItem) {
  return {items.data(), 0u, 0u, items.size() / perItem, format, 0u};
}

/// Collects triangles in one mesh. Each quad is a patch: the library finds it as a planar piece.
class SceneBuilder {
 public:
  uint32_t material(Rgb albedo, Rgb emission = {0.0f, 0.0f, 0.0f}) {
    AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
    for (size_t i = 0; i < 3; ++i) {
      desc.albedo[i] = albedo[i];
      desc.emission[i] = emission[i];
    }
    materials_.push_back(desc);
    return static_cast<uint32_t>(materials_.size() - 1);
  }

  /// Counter-clockwise seen from the front.
  void triangle(Vec3 a, Vec3 b, Vec3 c, uint32_t material) {
    addTriangle(vertex(a), vertex(b), vertex(c), material);
  }
  void quad(Vec3 a, Vec3 b, Vec3 c, Vec3 d, uint32_t material) {
    const uint32_t i = vertex(a);
    vertex(b), vertex(c), vertex(d);
    addTriangle(i, i + 1, i + 2, material);
    addTriangle(i, i + 2, i + 3, material);
  }
  /// Six walls whose fronts look inside (or outside), each of n x n panels that take the materials
  /// in turn.
  void box(Vec3 lower, Vec3 upper, bool inwards, const std::vector<uint32_t>& materials,
           uint32_t n = 1) {
    const Vec3 x = {upper.x - lower.x, 0, 0}, y = {0, upper.y - lower.y, 0},
               z = {0, 0, upper.z - lower.z};
    uint32_t panel = 0;
    const auto wall = [&](Vec3 o, Vec3 u, Vec3 v) {
      if (!inwards) std::swap(u, v);
      const Vec3 du = (1.0 / n) * u, dv = (1.0 / n) * v;
      for (uint32_t i = 0; i < n * n; ++i) {
        const Vec3 a = o + double(i % n) * du + double(i / n) * dv;
        quad(a, a + du, a + du + dv, a + dv, materials[panel++ % materials.size()]);
      }
    };
    wall(lower, x, y), wall(lower, y, z), wall(lower, z, x);
    wall(lower + z, y, x), wall(lower + x, z, y), wall(lower + y, x, z);
  }

  void scale(double factor) {
    for (float& v : vertices_) v = static_cast<float>(factor * v);
  }
  void translate(Vec3 by) {
    for (size_t i = 0; i < vertices_.size(); i += 3) {
      vertices_[i] = static_cast<float>(vertices_[i] + by.x);
      vertices_[i + 1] = static_cast<float>(vertices_[i + 1] + by.y);
      vertices_[i + 2] = static_cast<float>(vertices_[i + 2] + by.z);
    }
  }

  /// The mesh's buffers point into this builder.
  AWDMeshDesc mesh() const {
    AWDMeshDesc desc = AWD_MESH_DESC_INIT;
    desc.vertices = bufferOf(vertices_, AWD_FORMAT_FLOAT3, 3);
    desc.indices = bufferOf(indices_, AWD_FORMAT_UINT3, 3);
    desc.materials = bufferOf(triangleMaterials_, AWD_FORMAT_UINT, 1);
    return desc;
  }

  /// Uploads everything, without commit.
  Scene upload(AWDDevice device) const {
    Scene scene;
    must(awdNewScene(device, scene.out()));
    for (const AWDMaterialDesc& desc : materials_) must(awdAddMaterial(scene, &desc, nullptr));
    const AWDMeshDesc desc = mesh();
    must(awdAddMesh(scene, &desc, nullptr));
    return scene;
  }
  Scene commit(AWDDevice device) const {
    Scene scene = upload(device);
    must(awdCommitScene(scene));
    return scene;
  }

 private:
  uint32_t vertex(Vec3 v) {
    for (const double x : {v.x, v.y, v.z}) vertices_.push_back(static_cast<float>(x));
    return static_cast<uint32_t>(vertices_.size() / 3 - 1);
  }
  void addTriangle(uint32_t a, uint32_t b, uint32_t c, uint32_t material) {
    indices_.insert(indices_.end(), {a, b, c});
    triangleMaterials_.push_back(material);
  }

  std::vector<AWDMaterialDesc> materials_;
  std::vector<float> vertices_;
  std::vector<uint32_t> indices_, triangleMaterials_;
};

inline AWDCamera camera(Vec3 eye, Vec3 at, Vec3 up, double tanHalfFovX, uint32_t width,
                        uint32_t height) {
  AWDCamera result = AWD_CAMERA_INIT;
  const Vec3 look = normalise(at - eye);
  const double values[3][3] = {{eye.x, eye.y, eye.z}, {look.x, look.y, look.z}, {up.x, up.y, up.z}};
  for (size_t i = 0; i < 3; ++i) {
    result.eye[i] = static_cast<float>(values[0][i]);
    result.lookDir[i] = static_cast<float>(values[1][i]);
    result.up[i] = static_cast<float>(values[2][i]);
  }
  result.tanHalfFovX = static_cast<float>(tanHalfFovX);
  result.width = width;
  result.height = height;
  return result;
}

/// A closed room of 4 x 3 x 4 with coloured walls and a block on the floor. The lamp hangs below
/// the ceiling and shines at it, so that nearly all light in the room is indirect. All coordinates
/// are multiples of 1/8.
inline SceneBuilder lampRoom() {
  SceneBuilder room;
  const uint32_t white = room.material(grey(0.75)), red = room.material({0.7f, 0.2f, 0.15f}),
                 blue = room.material({0.2f, 0.3f, 0.7f}), block = room.material(grey(0.5)),
                 lamp = room.material(grey(0.0), {12.0f, 11.0f, 9.0f});
  room.box({0, 0, 0}, {4, 3, 4}, true, {white, red, white, white, blue, white});
  room.box({2.5, 0, 0.75}, {3.25, 1.25, 1.5}, false, {block});
  room.quad({1.5, 2.25, 1.5}, {1.5, 2.25, 2.5}, {2.5, 2.25, 2.5}, {2.5, 2.25, 1.5}, lamp);
  return room;
}
/// The same room with six lamps more, of many powers: each lights a corner or a wall only.
inline SceneBuilder sevenLampRoom() {
  SceneBuilder room = lampRoom();
  const double heights[] = {0.5, 1.0, 1.5};
  for (int i = 0; i < 6; ++i) {
    const uint32_t lamp = room.material(grey(0.0), grey(2.0 * (1 + 5 * (i % 3))));
    const double x = i < 3 ? 0.25 : 3.75, y = heights[i % 3], z = 0.5 + i % 3, w = 0.125;
    if (i < 3) {
      room.quad({x, y, z}, {x, y, z + w}, {x, y + w, z + w}, {x, y + w, z}, lamp);  // to the left
    } else {
      room.quad({x, y, z}, {x, y + w, z}, {x, y + w, z + w}, {x, y, z + w}, lamp);
    }
  }
  return room;
}
inline AWDCamera lampRoomCamera(uint32_t size, double scale = 1.0, Vec3 translation = {}) {
  AWDCamera result = camera({2, 1.5, 3.75}, {2, 1.375, 0}, {0, 1, 0}, 0.75, size, size);
  const double by[3] = {translation.x, translation.y, translation.z};
  for (size_t i = 0; i < 3; ++i) {
    result.eye[i] = static_cast<float>(scale * result.eye[i] + by[i]);
  }
  return result;
}

}  // namespace awdtest
