// SPDX-License-Identifier: Apache-2.0
// A light pass over the text of an OBJ file and its material libraries. Assimp, which reads the
// geometry after this, accepts much without a word: vertices that are no numbers, faces of two
// vertices, missing libraries.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene_data.h"

namespace command {

/// The materials that its libraries define, by name: Kd (grey of 0.6 if absent), Ke (0 if absent).
/// Throws a Failure that names file and line for: coordinates or colours that are no finite
/// numbers, faces of fewer than three vertices, indices out of range. Warns of libraries that
/// can't be read and of textures, which are ignored.
std::map<std::string, Material> readObjText(const std::string& path);

/// The text of an OBJ file that Assimp would misread, as it reads it right: without a byte order
/// mark, blanks before the lines, and comments after numbers. Nothing of a file that it reads
/// right.
std::optional<std::string> plainObjText(const std::string& path);

/// What a mesh without a defined material has: grey of albedo 0.6, which does not emit.
Material undefinedMaterial(const std::string& name);

}  // namespace command
