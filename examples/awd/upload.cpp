// SPDX-License-Identifier: Apache-2.0
#include "upload.h"

#include <algorithm>

#include "failure.h"

namespace command {

awd::Scene uploadScene(const awd::Device& device, const SceneData& data, const std::string& file) {
  awd::Scene scene = awd::Scene::create(device);
  for (const Material& material : data.materials) {
    awd::MaterialDesc desc;
    std::copy(material.albedo.begin(), material.albedo.end(), desc.albedo);
    std::copy(material.emission.begin(), material.emission.end(), desc.emission);
    named(file + ": material " + inQuotes(material.name), [&] { return scene.add(desc); });
  }
  for (const Mesh& mesh : data.meshes) {
    awd::MeshDesc desc;
    desc.vertices = awd::float3Buffer(mesh.vertices);
    desc.indices = awd::uint3Buffer(mesh.triangles);
    desc.material = mesh.material;
    desc.flags = AWD_MESH_SHARED;
    named(file + ": mesh " + inQuotes(mesh.name), [&] { return scene.add(desc); });
  }
  return scene;
}

}  // namespace command
