// SPDX-License-Identifier: Apache-2.0
#include "upload.h"

#include <algorithm>

#include "failure.h"

namespace command {

Scene uploadScene(const Device& device, const SceneData& data, const std::string& file) {
  Scene scene;
  check(awdNewScene(device.get(), scene.out()));
  for (const Material& material : data.materials) {
    AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
    std::copy(material.albedo.begin(), material.albedo.end(), desc.albedo);
    std::copy(material.emission.begin(), material.emission.end(), desc.emission);
    check(awdAddMaterial(scene.get(), &desc, nullptr),
          file + ": material " + inQuotes(material.name));
  }
  for (const Mesh& mesh : data.meshes) {
    AWDMeshDesc desc = AWD_MESH_DESC_INIT;
    desc.vertices.data = mesh.vertices.data();
    desc.vertices.count = mesh.vertices.size();
    desc.vertices.format = AWD_FORMAT_FLOAT3;
    desc.indices.data = mesh.triangles.data();
    desc.indices.count = mesh.triangles.size();
    desc.indices.format = AWD_FORMAT_UINT3;
    desc.material = mesh.material;
    desc.flags = AWD_MESH_SHARED;
    check(awdAddMesh(scene.get(), &desc, nullptr), file + ": mesh " + inQuotes(mesh.name));
  }
  return scene;
}

}  // namespace command
