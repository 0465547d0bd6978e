// SPDX-License-Identifier: Apache-2.0
// camera_file.h and camera_choice.h
#include "camera_choice.h"
#include "camera_file.h"

#include <cmath>

#include "temporary_folder.h"

using namespace command;

namespace {

constexpr char kCamera[] =
    R"({"eye": [1, 2, 3], "look_dir": [0, 0, -2], "up": [0, 1, 0], "tan_half_fov_x": 0.25,
        "width": 64, "height": 32, "right": "ignored", "notes": [1, {"a": null}]})";

class CameraTest : public TemporaryFolder {
 protected:
  /// What is wrong with kCamera once `from` has become `to`.
  std::string failureWith(const std::string& from, const std::string& to) const {
    std::string text = kCamera;
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    const std::string path = file("bad.json", text);
    const std::string message = failureOf([&] { readCameraFile(path); });
    EXPECT_CONTAINS(message, path);
    return message;
  }
};

SceneData quad(float size) {
  SceneData scene;
  scene.meshes.emplace_back();
  scene.meshes[0].vertices = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, size}};
  return scene;
}

TEST_F(CameraTest, ReadsItsKeysAndIgnoresOthers) {
  const AWDCamera camera = readCameraFile(file("good.json", kCamera));
  EXPECT_EQ(camera.eye[0], 1.0f);
  EXPECT_EQ(camera.eye[1], 2.0f);
  EXPECT_EQ(camera.eye[2], 3.0f);
  EXPECT_EQ(camera.lookDir[2], -2.0f);
  EXPECT_EQ(camera.up[1], 1.0f);
  EXPECT_EQ(camera.tanHalfFovX, 0.25f);
  EXPECT_EQ(camera.width, 64u);
  EXPECT_EQ(camera.height, 32u);
}

TEST_F(CameraTest, NamesMissingKeys) {
  for (const char* key : {"eye", "look_dir", "up", "tan_half_fov_x", "width", "height"}) {
    const std::string name = '"' + std::string(key) + '"';
    EXPECT_CONTAINS(failureWith(name, "\"else\""), name + " is missing");
  }
}

TEST_F(CameraTest, NamesKeysOfTheWrongType) {
  EXPECT_CONTAINS(failureWith("[1, 2, 3]", "[1, 2]"), "\"eye\" must be an array of 3 numbers");
  EXPECT_CONTAINS(failureWith("[1, 2, 3]", "[1, 2, 3, 4]"), "\"eye\"");
  EXPECT_CONTAINS(failureWith("[1, 2, 3]", "[1, \"2\", 3]"), "\"eye\" must hold numbers");
  EXPECT_CONTAINS(failureWith("[0, 1, 0]", "7"), "\"up\"");
  EXPECT_CONTAINS(failureWith("[0, 0, -2]", "null"), "\"look_dir\"");
  EXPECT_CONTAINS(failureWith("0.25", "true"), "\"tan_half_fov_x\"");
  EXPECT_CONTAINS(failureWith("64", "64.5"), "\"width\"");
  EXPECT_CONTAINS(failureWith("32", "\"32\""), "\"height\"");
}

TEST_F(CameraTest, NamesValuesOutOfRange) {
  EXPECT_CONTAINS(failureWith("[1, 2, 3]", "[1, 1e39, 3]"), "\"eye\" is too large");
  EXPECT_CONTAINS(failureWith("[0, 0, -2]", "[0, 0, 0]"), "\"look_dir\" is zero");
  EXPECT_CONTAINS(failureWith("[0, 1, 0]", "[0, 0, 0]"), "\"up\" is zero");
  EXPECT_CONTAINS(failureWith("[0, 1, 0]", "[0, 0, 5]"), "\"up\" is parallel to look_dir");
  EXPECT_CONTAINS(failureWith("0.25", "0"), "\"tan_half_fov_x\" must be above 0");
  EXPECT_CONTAINS(failureWith("0.25", "-1"), "\"tan_half_fov_x\" must be above 0");
  EXPECT_CONTAINS(failureWith("64", "0"), "\"width\" must be a whole number from 1 to 65536");
  EXPECT_CONTAINS(failureWith("64", "65537"), "\"width\"");
  EXPECT_CONTAINS(failureWith("32", "-32"), "\"height\"");
}

TEST_F(CameraTest, RefusesWhatIsNoJson) {
  EXPECT_CONTAINS(failureWith("[1, 2, 3]", "[1, NaN, 3]"), "is no JSON");
  EXPECT_CONTAINS(failureWith("[1, 2, 3]", "[1, 1e999, 3]"), "is no JSON");
  EXPECT_CONTAINS(failureWith("]", ""), "is no JSON");
  EXPECT_CONTAINS(failureOf([&] { readCameraFile(file("empty.json", "")); }), "is no JSON");
  EXPECT_CONTAINS(failureOf([&] { readCameraFile(file("list.json", "[]")); }), "no JSON object");
  EXPECT_CONTAINS(failureOf([&] { readCameraFile(folder() + "/none.json"); }), "none.json");
}

TEST_F(CameraTest, GivenFileThenFileBesideThenOwnThenFraming) {
  const std::string scene = folder() + "/scene.obj";
  SceneData data = quad(1.0f);
  testing::internal::CaptureStderr();
  chooseCamera(std::nullopt, scene, data);
  EXPECT_CONTAINS(testing::internal::GetCapturedStderr(), "scene.camera.json");

  testing::internal::CaptureStderr();
  data.camera = AWDCamera(AWD_CAMERA_INIT);
  data.camera->width = 7;
  EXPECT_EQ(chooseCamera(std::nullopt, scene, data).width, 7u);
  file("scene.camera.json", kCamera);
  EXPECT_EQ(chooseCamera(std::nullopt, scene, data).width, 64u);
  std::string other = kCamera;
  other.replace(other.find("64"), 2, "99");
  EXPECT_EQ(chooseCamera(file("other.json", other), scene, data).width, 99u);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(CameraTest, FramingSeesAllCornersAtAnyScale) {
  for (const float size : {1e-6f, 1.0f, 1e6f}) {
    const SceneData scene = quad(size);
    const AWDCamera camera = frameScene(scene);
    const float* d = camera.lookDir;
    for (const std::array<float, 3>& point : scene.meshes[0].vertices) {
      double along = 0.0, squared = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double offset = point[i] - camera.eye[i];
        along += offset * d[i];
        squared += offset * offset;
      }
      EXPECT_GT(along, 0.0);
      // Within the cone that the square image holds.
      EXPECT_LT(std::sqrt(squared - along * along), camera.tanHalfFovX * along);
    }
  }
}

TEST(Resize, KeepsTheFieldOfViewAndTheRatio) {
  AWDCamera camera = AWD_CAMERA_INIT;
  camera.width = 1000;
  camera.height = 500;
  AWDCamera resized = camera;
  resize(resized, 100, std::nullopt);
  EXPECT_EQ(resized.width, 100u);
  EXPECT_EQ(resized.height, 50u);
  resized = camera;
  resize(resized, std::nullopt, 100);
  EXPECT_EQ(resized.width, 200u);
  EXPECT_EQ(resized.height, 100u);
  resized = camera;
  resize(resized, 3, 7);
  EXPECT_EQ(resized.width, 3u);
  EXPECT_EQ(resized.height, 7u);
  EXPECT_EQ(resized.tanHalfFovX, camera.tanHalfFovX);
  resized = camera;
  resize(resized, 1, std::nullopt);
  EXPECT_EQ(resized.height, 1u);
}

}  // namespace
