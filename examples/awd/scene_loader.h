// SPDX-License-Identifier: Apache-2.0
// Scene files to plain structs, by Assimp: OBJ, glTF 2.0 (.gltf, .glb).
#pragma once

#include <string>

#include "scene_data.h"

namespace command {

/// Throws a Failure that names the file and what is wrong with it; warns of what is left out.
/// Geometry is triangulated and put in world space; nothing is merged.
SceneData loadScene(const std::string& path);

}  // namespace command
