// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/rooms.h"
#include "util/error.h"

namespace awd {
namespace {

TEST(Scene, AnswersInHostCoordinates) {
  for (const float scale : {1e-3f, 1.0f, 1e3f}) {
    const Ref<Scene> scene = sceneOf(floorAndLamp(scale));
    // From above the floor at x = 0.5: straight down, half a unit.
    const AWDRay down = {{0.5f * scale, 0.0f, 0.5f * scale}, 0.0f, {0.0f, 0.0f, -scale}, kFar};
    const AWDHit hit = scene->intersect(down);
    EXPECT_NEAR(hit.t, 0.5f, 1e-5f);
    EXPECT_EQ(hit.mesh, 0u);
    EXPECT_EQ(hit.material, 0u);
    EXPECT_EQ(hit.normal[2], 1.0f);
    EXPECT_EQ(hit.patch & AWD_PATCH_BACK, 0u);
    EXPECT_TRUE(scene->occluded(down));
    const AWDRay up = {{0.0f, 0.0f, -scale}, 0.0f, {0.0f, 0.0f, scale}, kFar};
    EXPECT_EQ(scene->intersect(up).patch & AWD_PATCH_BACK, AWD_PATCH_BACK);
    const AWDRay away = {{0.0f, 0.0f, 2 * scale}, 0.0f, {0.0f, 0.0f, scale}, kFar};
    EXPECT_EQ(scene->intersect(away).mesh, AWD_INVALID_ID);
    EXPECT_FALSE(scene->occluded(away));
  }
}

/// Neither a short direction nor a large scene hides anything.
TEST(Scene, MeetsTheSameByRaysOfAnyLength) {
  for (const float size : {1e-30f, 1.0f, 1e9f, 9e17f}) {
    const Ref<Scene> scene = sceneOf(floorAndLamp(size));
    for (const float length : {1e-40f, 1e-30f, 1e-18f, 1e-16f, 1.0f, 1e10f}) {
      if (length / size > 1e18f) continue;
      const AWDRay down = {{0.5f * size, 0.1f * size, 0.5f * size},
                           0.0f,
                           {0.1f * length, 0.2f * length, -length},
                           kFar};
      const AWDHit hit = scene->intersect(down);
      const double t = 0.5 * static_cast<double>(size) / static_cast<double>(length);
      if (t > 3e38) {
        EXPECT_EQ(hit.mesh, AWD_INVALID_ID) << "t is no float";
        continue;
      }
      EXPECT_EQ(hit.mesh, 0u) << size << ", " << length;
      EXPECT_TRUE(scene->occluded(down)) << size << ", " << length;
      EXPECT_NEAR(static_cast<double>(hit.t) / t, 1.0, 1e-5) << size << ", " << length;
      AWDRay segment = down;
      segment.tfar = hit.t * 0.99f;
      EXPECT_FALSE(scene->occluded(segment)) << size << ", " << length;
      segment.tnear = hit.t * 1.01f;
      segment.tfar = kFar;
      EXPECT_FALSE(scene->occluded(segment)) << size << ", " << length;
    }
  }
}

TEST(Scene, KnowsThePatchOfAPoint) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const uint32_t floor = scene->geometry().triangle(0).patch;
  EXPECT_EQ(scene->pointPatch({0.3f, 0.3f, 0.1f}), floor);
  EXPECT_EQ(scene->pointPatch({0.3f, 0.3f, 0.0f}), floor);
  EXPECT_EQ(scene->pointPatch({0.3f, 0.3f, -0.1f}), floor | AWD_PATCH_BACK);
}

TEST(Scene, AFailedCommitKeepsTheFormerGeometry) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  Soup bad = floorAndLamp();
  bad.vertices[4] = std::nanf("");
  scene->addMesh(bad.desc());
  EXPECT_THROW(scene->commit(), Error);
  const AWDRay down = {{0.5f, 0.0f, 0.5f}, 0.0f, {0.0f, 0.0f, -1.0f}, kFar};
  EXPECT_EQ(scene->intersect(down).mesh, 0u);
}

}  // namespace
}  // namespace awd
