// SPDX-License-Identifier: Apache-2.0
// Which camera a scene is seen by, and how large the image is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scene_data.h"

namespace command {

/// In this order: the camera file given; <scene without extension>.camera.json beside the scene;
/// the scene's own camera; a view that frames all of the scene, of which a note tells.
AWDCamera chooseCamera(const std::optional<std::string>& cameraFile, const std::string& scenePath,
                       const SceneData& scene);

/// Looks at the middle of the scene's bounding box from a distance at which all of it is seen.
AWDCamera frameScene(const SceneData& scene);

/// Takes a width, a height or both instead of the camera's; with one of them the other follows to
/// keep the aspect ratio. The horizontal field of view stays.
void resize(AWDCamera& camera, std::optional<uint32_t> width, std::optional<uint32_t> height);

}  // namespace command
