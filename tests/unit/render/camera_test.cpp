// SPDX-License-Identifier: Apache-2.0
#include "render/camera.h"

#include <gtest/gtest.h>

#include "render/rooms.h"

namespace awd {
namespace {

TEST(Camera, FollowsItsFormula) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  AWDCamera desc = AWD_CAMERA_INIT;
  desc.width = 200;
  desc.height = 100;
  desc.tanHalfFovX = 0.5f;
  const Camera camera(desc, scene->geometry());
  const auto expected = [](double x, double y) {
    // Looking down -z with y up: right is +x.
    return normalized(Vec3d{0.5 * (2 * x / 200 - 1), 0.5 * (1 - 2 * y / 100) * 0.5, -1.0});
  };
  for (const double x : {0.0, 37.5, 200.0}) {
    for (const double y : {0.0, 12.25, 100.0}) {
      const Vec3d d = convert<double>(camera.direction(x, y));
      EXPECT_NEAR(length(d - expected(x, y)), 0.0, 1e-6);
    }
  }
}

TEST(Camera, MakesUpOrthogonal) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  AWDCamera straight = AWD_CAMERA_INIT;
  AWDCamera skewed = straight;
  skewed.lookDir[2] = -7.0f;
  skewed.up[2] = -3.0f;
  const Camera a(straight, scene->geometry()), b(skewed, scene->geometry());
  EXPECT_NEAR(length(a.direction(10, 20) - b.direction(10, 20)), 0.0f, 1e-6f);
}

/// Beside a pixel that is 1e38 wide the way to the middle is nothing, but it is not lost.
TEST(Camera, LooksAheadHoweverWideItsView) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  AWDCamera wide = AWD_CAMERA_INIT;
  wide.tanHalfFovX = 3e38f;
  const Camera camera(wide, scene->geometry());
  const Vec3f ahead = camera.direction(0.5 * wide.width, 0.5 * wide.height);
  EXPECT_EQ(ahead.x, 0.0f);
  EXPECT_EQ(ahead.y, 0.0f);
  EXPECT_EQ(ahead.z, -1.0f);
  EXPECT_NEAR(camera.direction(wide.width, 0.5 * wide.height).x, 1.0f, 1e-6f);
}

}  // namespace
}  // namespace awd
