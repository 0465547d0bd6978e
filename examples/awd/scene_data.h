// SPDX-License-Identifier: Apache-2.0
// A scene as read from a file, before it goes to the library.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "awd/awd.h"

namespace command {

struct Material {
  std::string name;
  std::array<float, 3> albedo = {};
  std::array<float, 3> emission = {};
};

struct Mesh {
  std::string name;
  std::vector<std::array<float, 3>> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  uint32_t material = 0;
};

struct SceneData {
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::optional<AWDCamera> camera;  // the file's own
};

}  // namespace command
