// SPDX-License-Identifier: Apache-2.0
// A glTF 2.0 file (.gltf or .glb) as JSON, for what Assimp drops or gets wrong: the strength of
// emission, which material a mesh has (its numbers follow the order of use), cameras, and
// triangles that it leaves out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene_data.h"

#include <nlohmann/json.hpp>

namespace command {

class GltfFile {
 public:
  /// Throws a Failure that names the file, as does everything below.
  explicit GltfFile(const std::string& path);

  /// The file's geometry (gltf_geometry.h) with meshes and nodes named "mesh0", "node0" and so on,
  /// by number, so that what comes out of Assimp can be told.
  std::string relabelled() const;

  /// baseColorFactor as albedo, emissiveFactor times emissiveStrength as emission; then one for
  /// meshes that name none. Warns of what a diffuse renderer leaves out.
  std::vector<Material> materials() const;

  struct Primitive {
    std::string name;       // its mesh's, in the file
    uint32_t material = 0;  // among materials()
    /// Triangles that it should have; none if it is made of lines or points.
    std::size_t triangles = 0;
  };
  /// What a relabelled mesh of Assimp's is: "mesh3-1" is the second primitive of the fourth mesh.
  Primitive primitive(const std::string& label) const;

  /// Perspective cameras and the labels of their nodes.
  struct Camera {
    std::string name, nodeLabel;
    double yfov = 0.0;
    std::optional<double> aspectRatio;
  };
  std::vector<Camera> cameras() const;

 private:
  [[noreturn]] void fail(const std::string& reason) const;
  void takeBinary(const std::string& chunks);
  void parse(const std::string& text);
  void checkExtensions() const;
  /// file_[key], an empty array if there is none.
  const nlohmann::json& list(const char* key) const;

  std::string path_;
  nlohmann::json file_;
  /// What follows the JSON in a .glb.
  std::string binary_;
  bool isBinary_ = false;
};

}  // namespace command
