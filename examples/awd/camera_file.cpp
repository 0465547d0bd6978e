// SPDX-License-Identifier: Apache-2.0
#include "camera_file.h"

#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "failure.h"

namespace command {
namespace {

using nlohmann::json;

class CameraFile {
 public:
  explicit CameraFile(const std::string& path) : path_(path) {
    std::ifstream file(path);
    if (!file) throw Failure("can't read camera file " + inQuotes(path));
    try {
      file_ = json::parse(file);
    } catch (const json::exception& error) {
      throw Failure(path + ": is no JSON: " + error.what());
    }
    if (!file_.is_object()) throw Failure(path + ": is no JSON object");
  }

  [[noreturn]] void fail(const char* key, const char* reason) const {
    throw Failure(path_ + ": " + inQuotes(key) + " " + reason);
  }

  float number(const char* key) const { return toFloat(key, at(key)); }

  void vector(const char* key, float (&result)[3]) const {
    const json& values = at(key);
    if (!values.is_array() || values.size() != 3) fail(key, "must be an array of 3 numbers");
    for (std::size_t i = 0; i < 3; ++i) result[i] = toFloat(key, values[i]);
  }

  uint32_t size(const char* key) const {
    const json& value = at(key);
    if (!value.is_number_integer() || value < 1 || value > 65536) {
      fail(key, "must be a whole number from 1 to 65536");
    }
    return value.get<uint32_t>();
  }

 private:
  const json& at(const char* key) const {
    if (!file_.contains(key)) fail(key, "is missing");
    return file_.at(key);
  }

  float toFloat(const char* key, const json& value) const {
    if (!value.is_number()) fail(key, "must hold numbers");
    const float result = value.get<float>();
    if (!std::isfinite(result)) fail(key, "is too large");
    return result;
  }

  std::string path_;
  json file_;
};

double length(const std::array<double, 3>& v) { return std::hypot(v[0], v[1], v[2]); }

/// Sine of the angle between two vectors that are not zero.
double sineBetween(const float (&a)[3], const float (&b)[3]) {
  const std::array<double, 3> x = {a[0], a[1], a[2]}, y = {b[0], b[1], b[2]};
  return length({x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]}) /
         (length(x) * length(y));
}

bool isZero(const float (&v)[3]) { return v[0] == 0.0f && v[1] == 0.0f && v[2] == 0.0f; }

}  // namespace

AWDCamera readCameraFile(const std::string& path) {
  const CameraFile file(path);
  AWDCamera camera = AWD_CAMERA_INIT;
  file.vector("eye", camera.eye);
  file.vector("look_dir", camera.lookDir);
  file.vector("up", camera.up);
  camera.tanHalfFovX = file.number("tan_half_fov_x");
  camera.width = file.size("width");
  camera.height = file.size("height");
  if (isZero(camera.lookDir)) file.fail("look_dir", "is zero");
  if (isZero(camera.up)) file.fail("up", "is zero");
  if (!(sineBetween(camera.lookDir, camera.up) > 1e-6)) file.fail("up", "is parallel to look_dir");
  if (!(camera.tanHalfFovX > 0.0f)) file.fail("tan_half_fov_x", "must be above 0");
  return camera;
}

}  // namespace command
