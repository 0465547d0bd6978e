// SPDX-License-Identifier: Apache-2.0
#include "camera_choice.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "camera_file.h"
#include "console.h"
#include "failure.h"
#include "regular_file.h"

namespace command {
namespace {

/// `side` scaled as another side was.
uint32_t scaled(uint32_t side, uint32_t from, uint32_t to) {
  const double size = std::round(static_cast<double>(side) * to / from);
  return static_cast<uint32_t>(std::clamp(size, 1.0, 65536.0));
}

}  // namespace

AWDCamera frameScene(const SceneData& scene) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 3> lower = {kInfinity, kInfinity, kInfinity};
  std::array<double, 3> upper = {-kInfinity, -kInfinity, -kInfinity};
  for (const Mesh& mesh : scene.meshes) {
    for (const std::array<float, 3>& point : mesh.vertices) {
      for (std::size_t i = 0; i < 3; ++i) {
        lower[i] = std::min<double>(lower[i], point[i]);
        upper[i] = std::max<double>(upper[i], point[i]);
      }
    }
  }
  const double radius =
      std::hypot(upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]) / 2.0;
  AWDCamera camera = AWD_CAMERA_INIT;
  // The box's sphere fits into the cone of half the field of view; a little room is left.
  const double sine = camera.tanHalfFovX / std::hypot(1.0, camera.tanHalfFovX);
  const double distance = 1.05 * std::max(radius, 1e-30) / sine;
  const std::array<double, 3> towards = {-1.0 / 3.0, -1.0 / 3.0, -std::sqrt(7.0) / 3.0};
  for (std::size_t i = 0; i < 3; ++i) {
    camera.lookDir[i] = static_cast<float>(towards[i]);
    camera.eye[i] = static_cast<float>((lower[i] + upper[i]) / 2.0 - distance * towards[i]);
  }
  return camera;
}

AWDCamera chooseCamera(const std::optional<std::string>& cameraFile, const std::string& scenePath,
                       const SceneData& scene) {
  if (cameraFile) return readCameraFile(*cameraFile);
  const std::filesystem::path beside =
      std::filesystem::path(scenePath).replace_extension("camera.json");
  if (isRegularFile(beside)) return readCameraFile(beside.string());
  if (scene.camera) return *scene.camera;
  note(scenePath + ": there is no camera, nor a file " + inQuotes(beside.string()) +
       ": a view of the whole scene is taken");
  return frameScene(scene);
}

void resize(AWDCamera& camera, std::optional<uint32_t> width, std::optional<uint32_t> height) {
  const uint32_t oldWidth = camera.width, oldHeight = camera.height;
  if (width) {
    camera.width = *width;
    camera.height = scaled(oldHeight, oldWidth, *width);
  }
  if (height) {
    camera.height = *height;
    if (!width) camera.width = scaled(oldWidth, oldHeight, *height);
  }
}

}  // namespace command
