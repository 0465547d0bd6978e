// SPDX-License-Identifier: Apache-2.0
// A floor under a lamp, whose vertices lie in structs of the host's.
#pragma once

#include <array>
#include <vector>

#include "bindings/cpp/mode.h"

namespace awdtest {

struct Vertex {
  int id;
  float position[3];
  float weight;
};

inline std::vector<Vertex> roomVertices() {
  return {{0, {-1, 0, 1}, 9},      {1, {1, 0, 1}, 9},         {2, {1, 0, -1}, 9},
          {3, {-1, 0, -1}, 9},     {4, {-0.5f, 1, -0.5f}, 9}, {5, {0.5f, 1, -0.5f}, 9},
          {6, {0.5f, 1, 0.5f}, 9}, {7, {-0.5f, 1, 0.5f}, 9}};
}

/// Not committed.
inline awd::Scene uploadRoom(const awd::Device& device) {
  const std::vector<Vertex> vertices = roomVertices();
  const std::array<uint32_t, 3> indices[] = {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  const uint32_t materials[] = {0, 0, 1, 1};
  awd::Scene scene = MUST(awd::Scene::create(device));
  awd::MaterialDesc grey, lamp;
  grey.albedo[0] = grey.albedo[1] = grey.albedo[2] = 0.5f;
  lamp.emission[0] = lamp.emission[1] = lamp.emission[2] = 4.0f;
  EXPECT_EQ(MUST(scene.add(grey)), 0u);
  EXPECT_EQ(MUST(scene.add(lamp)), 1u);
  awd::MeshDesc mesh;
  mesh.vertices = awd::float3Buffer(vertices, &Vertex::position);
  mesh.indices = awd::uint3Buffer(indices);
  mesh.materials = awd::uintBuffer(materials);
  EXPECT_EQ(MUST(scene.add(mesh)), 0u);
  return scene;
}

inline awd::Scene makeRoom(const awd::Device& device) {
  awd::Scene scene = uploadRoom(device);
  MUST(scene.commit());
  return scene;
}

inline awd::Camera roomCamera(uint32_t width, uint32_t height) {
  awd::Camera camera;
  camera.eye[1] = 0.5f;
  camera.eye[2] = 4.0f;
  camera.width = width;
  camera.height = height;
  return camera;
}

inline awd::Device oneThread() {
  awd::DeviceDesc desc;
  desc.threads = 1;
  return MUST(awd::Device::create(desc));
}

}  // namespace awdtest
