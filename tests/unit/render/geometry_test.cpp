// SPDX-License-Identifier: Apache-2.0
#include "render/geometry.h"

#include <gtest/gtest.h>

#include "render/rooms.h"

namespace awd {
namespace {

TEST(Geometry, LiesWithinTheUnitCube) {
  for (const float scale : {1e-12f, 1e-3f, 1.0f, 1e3f, 1e12f}) {
    const Ref<Scene> scene = sceneOf(floorAndLamp(scale));
    const Geometry& g = scene->geometry();
    float most = 0.0f;
    for (uint32_t t = 0; t < 4; ++t) {
      for (int k = 0; k < 3; ++k) {
        const Vec3f p = g.embree().corners(t)[k];
        most = std::max({most, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      }
    }
    EXPECT_LE(most, 1.0f) << scale;
    EXPECT_GE(most, 0.5f) << scale;
  }
}

TEST(Geometry, PowersOfTwoChangeNoBit) {
  const Ref<Scene> one = sceneOf(floorAndLamp()), large = sceneOf(floorAndLamp(1024.0f));
  for (uint32_t t = 0; t < 4; ++t) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(one->geometry().embree().corners(t)[k], large->geometry().embree().corners(t)[k]);
    }
    EXPECT_EQ(one->geometry().triangle(t).normal, large->geometry().triangle(t).normal);
  }
}

TEST(Geometry, FarFromTheOriginLosesNothingThatTheVerticesHold) {
  const Ref<Scene> here = sceneOf(floorAndLamp());
  const Ref<Scene> far = sceneOf(floorAndLamp(1.0f, {1e6f, -1e6f, 1e6f}));  // exact in floats
  for (uint32_t t = 0; t < 4; ++t) {
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(here->geometry().embree().corners(t)[k], far->geometry().embree().corners(t)[k]);
    }
  }
}

TEST(Geometry, FindsLightsAndPatches) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Geometry& g = scene->geometry();
  const AWDSceneInfo info = g.info();
  EXPECT_EQ(info.triangles, 4u);
  EXPECT_EQ(info.skipped, 0u);
  EXPECT_EQ(info.lights, 1u);
  EXPECT_EQ(info.patches, 2u);
  EXPECT_EQ(info.meshes, 1u);
  EXPECT_EQ(info.lower[0], -1.0f);
  EXPECT_EQ(info.upper[2], 1.0f);
  EXPECT_EQ(g.triangle(0).light, kNoLight);
  EXPECT_EQ(g.triangle(2).light, 0u);
  EXPECT_EQ(g.triangle(0).patch, g.triangle(1).patch);
  EXPECT_NE(g.triangle(0).patch, g.triangle(2).patch);
  EXPECT_EQ(g.lights()[0].normal, (Vec3f{0, 0, -1}));
}

TEST(Geometry, SkippedTrianglesLeaveTheOthersNumbers) {
  Soup soup;
  soup.triangle({0, 0, 0}, {0, 0, 0}, {1, 0, 0}, 0);
  soup.triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0);
  soup.triangle({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, 0);
  const Ref<Scene> scene = sceneOf(soup);
  const Geometry& g = scene->geometry();
  EXPECT_EQ(g.info().skipped, 2u);
  EXPECT_EQ(g.find(0, 0), AWD_INVALID_ID);
  EXPECT_EQ(g.find(0, 1), 0u);
  EXPECT_EQ(g.find(0, 2), AWD_INVALID_ID);
  EXPECT_EQ(g.source(g.triangle(0)).triangle, 1u);
}

TEST(Geometry, HostPatchesAndPiecesDoNotCollide) {
  const Ref<Device> owner = device();
  Ref<Scene> scene = Scene::make(owner);
  scene->addMaterial(material(0.5f, 0.0f));
  scene->addMaterial(material(0.0f, 10.0f));
  const Soup soup = floorAndLamp();
  AWDMeshDesc numbered = soup.desc();
  const uint32_t ids[] = {7, 8, 7, 7};
  numbered.patches = {ids, 0, 0, 4, AWD_FORMAT_UINT, 0};
  scene->addMesh(numbered);
  const Soup other = floorAndLamp(1.0f, {10, 0, 0});
  scene->addMesh(other.desc());
  scene->commit();
  const Geometry& g = scene->geometry();
  EXPECT_EQ(g.triangle(g.find(0, 1)).patch, 8u);
  EXPECT_EQ(g.triangle(g.find(1, 0)).patch, 9u);
  EXPECT_EQ(g.info().patches, 4u);
}

}  // namespace
}  // namespace awd
