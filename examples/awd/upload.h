// SPDX-License-Identifier: Apache-2.0
// A scene that was read, handed to the library.
#pragma once

#include <string>

#include "awd/awd.hpp"
#include "scene_data.h"

namespace command {

/// Uploads without committing: materials and meshes get the numbers that they have in `data`,
/// whose buffers must live until the commit. Failures name `file`, and the material.
awd::Scene uploadScene(const awd::Device& device, const SceneData& data, const std::string& file);

}  // namespace command
