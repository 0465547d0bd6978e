// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

TEST(Scene, IsReadThroughStrides) {
  awd::Scene scene = makeRoom(oneThread());
  const AWDSceneInfo info = MUST(scene.info());
  EXPECT_EQ(info.triangles, 4u);
  EXPECT_EQ(info.lights, 1u);
  EXPECT_EQ(info.patches, 2u);
  const float lower[3] = {-1, 0, -1}, upper[3] = {1, 1, 1};
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(info.lower[i], lower[i]);
    EXPECT_EQ(info.upper[i], upper[i]);
  }
}

TEST(Scene, AnswersRays) {
  const awd::Scene scene = makeRoom(oneThread());
  const AWDRay rays[] = {{{0, 0.5f, 0}, 0, {0, -1, 0}, INFINITY},
                         {{0, 0.5f, 0}, 0, {0, 1, 0}, INFINITY},
                         {{0, 0.5f, 0}, 0, {1, 0, 0}, INFINITY}};
  std::vector<AWDHit> hits(3);
  MUST(scene.intersect(rays, hits));
  EXPECT_EQ(hits[0].t, 0.5f);
  EXPECT_EQ(hits[0].material, 0u);
  EXPECT_EQ(hits[1].material, 1u);
  EXPECT_EQ(hits[2].mesh, AWD_INVALID_ID);
  EXPECT_EQ(MUST(scene.intersect(rays[1])).t, hits[1].t);

  std::array<uint8_t, 3> hidden = {};
  MUST(scene.occluded(rays, hidden));
  EXPECT_EQ(hidden, (std::array<uint8_t, 3>{1, 1, 0}));
  EXPECT_TRUE(MUST(scene.occluded(rays[0])));
  EXPECT_FALSE(MUST(scene.occluded(rays[2])));

  const uint32_t front = MUST(scene.trianglePatch(0, 0));
  EXPECT_EQ(MUST(scene.trianglePatch(0, 0, true)), front | AWD_PATCH_BACK);
  EXPECT_EQ(MUST(scene.pointPatch(std::array<float, 3>{0, 0.1f, 0})), front);
}

TEST(Scene, ViewsMustFit) {
  const awd::Scene scene = makeRoom(oneThread());
  const std::vector<AWDRay> rays(3);
  std::vector<AWDHit> hits(2);
  std::vector<uint8_t> answers(4);
  expectError([&] { return scene.intersect(rays, hits); }, AWD_ERROR_INVALID_ARGUMENT,
              "hits has 2 elements: the other arguments want 3");
  expectError([&] { return scene.occluded(rays, answers); }, AWD_ERROR_INVALID_ARGUMENT,
              "answers has 4 elements");
}

TEST(Scene, CarriesTheLibrarysWords) {
  awd::Scene scene = uploadRoom(oneThread());
  awd::MaterialDesc bad;
  bad.albedo[1] = 2.0f;
  expectError([&] { return scene.add(bad); }, AWD_ERROR_INVALID_ARGUMENT, "albedo");
  expectError([&] { return scene.info(); }, AWD_ERROR_INVALID_OPERATION, "commit");
}

}  // namespace
