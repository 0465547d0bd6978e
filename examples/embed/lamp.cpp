// SPDX-License-Identifier: Apache-2.0
#include "lamp.h"

#include <algorithm>

namespace host {
namespace {

const std::vector<Vertex> kVertices = {
    {{-1, 0, 1}, {0, 1, 0}},       {{1, 0, 1}, {0, 1, 0}},          {{1, 0, -1}, {0, 1, 0}},
    {{-1, 0, -1}, {0, 1, 0}},      {{-0.5f, 1, -0.5f}, {0, -1, 0}}, {{0.5f, 1, -0.5f}, {0, -1, 0}},
    {{0.5f, 1, 0.5f}, {0, -1, 0}}, {{-0.5f, 1, 0.5f}, {0, -1, 0}}};
const std::vector<std::array<uint32_t, 3>> kTriangles = {
    {0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};

}  // namespace

Picture renderLamp(const awd::Device& device, uint32_t width, uint32_t height) {
  awd::MaterialDesc grey, lamp;
  std::fill(grey.albedo, grey.albedo + 3, 0.5f);
  std::fill(lamp.emission, lamp.emission + 3, 4.0f);
  awd::Scene scene = awd::Scene::create(device);
  const uint32_t floor = scene.add(grey), shade = scene.add(lamp);
  const std::array<uint32_t, 4> materials = {floor, floor, shade, shade};

  // The host's vertices as they lie, normals between them; none is copied before the commit.
  awd::MeshDesc mesh;
  mesh.vertices = awd::float3Buffer(kVertices, &Vertex::position);
  mesh.indices = awd::uint3Buffer(kTriangles);
  mesh.materials = awd::uintBuffer(materials);
  mesh.flags = AWD_MESH_SHARED;
  scene.add(mesh);
  scene.commit();

  awd::Camera camera;
  camera.eye[1] = 0.5f;
  camera.eye[2] = 4.0f;
  camera.width = width;
  camera.height = height;
  awd::Render render = awd::Render::create(scene, awd::RenderDesc(camera));
  render.passes(awd::qualitySchedule(AWD_QUALITY_DRAFT));

  // Into r, g and b of the host's pixels; alpha stays.
  Picture picture(width, height);
  render.readFilm({&picture.pixels[0].r, width, height, sizeof(Pixel)});
  return picture;
}

}  // namespace host
