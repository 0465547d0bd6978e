// SPDX-License-Identifier: Apache-2.0
// What Assimp is given of a glTF file: nodes, and the corners of what they show, under names that
// tell their numbers. Assimp 5.2 trusts in offsets, counts and trees, and reads and writes beyond
// its memory where they are wrong: here they are checked, and all that no image needs is left out.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>

namespace command {

/// Throws a Failure, or an exception of the JSON library where something is of another type.
/// binaryBytes: of the chunk of data in a .glb.
nlohmann::json gltfGeometry(const nlohmann::json& file, std::size_t binaryBytes);

}  // namespace command
