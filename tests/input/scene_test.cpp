// SPDX-License-Identifier: Apache-2.0
// Scenes with something wrong in them: the message names it, and the scene is as it was.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A strip of `quads` unit quads in the plane z = 0, and what a test spoils in it.
struct Strip {
  explicit Strip(uint32_t quads) {
    for (uint32_t i = 0; i <= quads; ++i) {
      for (const float y : {0.0f, 1.0f}) {
        vertices.insert(vertices.end(), {static_cast<float>(i), y, 0.0f});
      }
    }
    for (uint32_t i = 0; i < quads; ++i) {
      indices.insert(indices.end(), {2 * i, 2 * i + 2, 2 * i + 3, 2 * i, 2 * i + 3, 2 * i + 1});
    }
    materials.assign(indices.size() / 3, 0);
    patches.assign(indices.size() / 3, 5);
  }
  AWDMeshDesc mesh() const {
    AWDMeshDesc desc = AWD_MESH_DESC_INIT;
    desc.vertices = bufferOf(vertices, AWD_FORMAT_FLOAT3, 3);
    desc.indices = bufferOf(indices, AWD_FORMAT_UINT3, 3);
    desc.materials = bufferOf(materials, AWD_FORMAT_UINT, 1);
    desc.patches = bufferOf(patches, AWD_FORMAT_UINT, 1);
    return desc;
  }
  std::vector<float> vertices;
  std::vector<uint32_t> indices, materials, patches;
};

class BadScene : public testing::Test {
 protected:
  void SetUp() override { begin(); }

  /// A device and an uncommitted scene with a grey material and a lamp.
  void begin() {
    AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
    desc.threads = 1;
    desc.log = [](void* user, int32_t severity, const char* text) {
      auto& log = *static_cast<std::vector<std::string>*>(user);
      if (severity >= AWD_LOG_WARNING) log.push_back(text);
    };
    desc.logUser = &warnings_;
    device_ = newDevice(&desc);
    must(awdNewScene(device_, scene_.out()));
    const AWDMaterialDesc grey = {sizeof grey, {0.5f, 0.5f, 0.5f}, {0.0f, 0.0f, 0.0f}};
    const AWDMaterialDesc lamp = {sizeof lamp, {0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
    must(awdAddMaterial(scene_, &grey, nullptr));
    must(awdAddMaterial(scene_, &lamp, nullptr));
  }

  void add(const Strip& strip) {
    const AWDMeshDesc desc = strip.mesh();
    must(awdAddMesh(scene_, &desc, nullptr));
  }
  AWDSceneInfo info() {
    AWDSceneInfo result = AWD_SCENE_INFO_INIT;
    must(awdGetSceneInfo(scene_, &result));
    return result;
  }
  AWDHit shoot(float x, float y) {
    const AWDRay ray = {{x, y, 1.0f}, 0.0f, {0.0f, 0.0f, -1.0f}, kInfinity};
    AWDHit hit;
    must(awdIntersect(scene_, &ray, 1, &hit));
    return hit;
  }
  /// Commits a good mesh 0, adds the spoilt mesh 1, and wants commit to fail with these words, and
  /// the scene to be the one that was committed.
  void expectRefused(const Strip& spoilt, std::vector<std::string> parts) {
    add(Strip(1));
    must(awdCommitScene(scene_));
    const AWDSceneInfo before = info();
    add(spoilt);
    parts.push_back("mesh 1");
    for (int again = 0; again < 2; ++again) {
      expectFailure(awdCommitScene(scene_), AWD_ERROR_INVALID_ARGUMENT, parts);
      EXPECT_EQ(info().triangles, before.triangles);
      EXPECT_EQ(info().meshes, before.meshes);
      EXPECT_EQ(shoot(0.25f, 0.5f).mesh, 0u);
      EXPECT_EQ(shoot(1.5f, 0.5f).mesh, AWD_INVALID_ID);
    }
  }

  std::vector<std::string> warnings_;
  Device device_;
  Scene scene_;
};

TEST_F(BadScene, VertexNotFiniteOrTooLarge) {
  for (const float bad : {kNaN, kInfinity, -kInfinity, 2e18f, -3e38f}) {
    for (const size_t axis : {0u, 1u, 2u}) {
      begin();
      Strip strip(100);
      strip.vertices[3 * 137 + axis] = bad;
      expectRefused(strip, {"vertex 137"});
    }
  }
}

TEST_F(BadScene, IndexOutOfRange) {
  for (const uint32_t bad : {202u, 4000000000u, 0xFFFFFFFFu}) {
    begin();
    Strip strip(100);  // 202 vertices
    strip.indices[3 * 61 + 2] = bad;
    expectRefused(strip, {"triangle 61", std::to_string(bad), "202"});
  }
}

TEST_F(BadScene, MaterialOutOfRange) {
  Strip strip(100);
  strip.materials[77] = 42;
  expectRefused(strip, {"triangle 77", "42"});
}

TEST_F(BadScene, MeshMaterialOutOfRange) {
  const Strip strip(2);
  AWDMeshDesc desc = strip.mesh();
  desc.materials = AWDBuffer{};
  desc.material = 2;
  const AWDResult added = awdAddMesh(scene_, &desc, nullptr);
  expectFailure(added == AWD_SUCCESS ? awdCommitScene(scene_) : added, AWD_ERROR_INVALID_ARGUMENT,
                {"material", "2"});
}

TEST_F(BadScene, PatchAboveTheSideBit) {
  for (const uint32_t bad : {0x7FFFFFFFu, 0x80000000u, 0xFFFFFFFFu}) {
    begin();
    Strip strip(100);
    strip.patches[30] = bad;
    expectRefused(strip, {"triangle 30", std::to_string(bad)});
  }
}

TEST_F(BadScene, BufferOfMaterialsOrPatchesOfAnotherLength) {
  for (const bool materials : {true, false}) {
    const Strip strip(3);
    AWDMeshDesc desc = strip.mesh();
    (materials ? desc.materials : desc.patches).count = 5;  // 6 triangles
    const AWDResult added = awdAddMesh(scene_, &desc, nullptr);
    expectFailure(added == AWD_SUCCESS ? awdCommitScene(scene_) : added, AWD_ERROR_INVALID_ARGUMENT,
                  {materials ? "material" : "patch", "5", "6"});
  }
}

TEST_F(BadScene, TrianglesWithoutAreaAreSkippedAndCounted) {
  Strip strip(4);
  strip.indices[1] = strip.indices[0];                     // two equal corners
  strip.indices[6] = strip.indices[7] = strip.indices[8];  // three
  for (size_t i = 0; i < 3; ++i) strip.vertices.insert(strip.vertices.end(), {float(i), 0, 0});
  const uint32_t first = static_cast<uint32_t>(strip.vertices.size() / 3) - 3;
  strip.indices.insert(strip.indices.end(), {first, first + 1, first + 2});  // in a line
  strip.materials.push_back(1);                                              // it would shine
  strip.patches.push_back(6);
  add(strip);
  must(awdCommitScene(scene_));
  EXPECT_EQ(info().triangles, 9u);
  EXPECT_EQ(info().skipped, 3u);
  EXPECT_EQ(info().lights, 0u);
  uint32_t patch = 0;
  must(awdGetTrianglePatch(scene_, 0, 0, 0, &patch));
  EXPECT_EQ(patch, AWD_INVALID_ID);
  must(awdGetTrianglePatch(scene_, 0, 1, 0, &patch));
  EXPECT_EQ(patch, 5u);
  must(awdGetTrianglePatch(scene_, 0, 1, 1, &patch));
  EXPECT_EQ(patch, 5u | AWD_PATCH_BACK);
  EXPECT_EQ(shoot(0.25f, 0.75f).triangle, 1u);
  EXPECT_EQ(shoot(0.75f, 0.25f).mesh, AWD_INVALID_ID) << "triangle 0 has no area";
}

TEST_F(BadScene, OnlyTrianglesWithoutArea) {
  Strip strip(2);
  for (uint32_t& index : strip.indices) index = 1;
  add(strip);
  must(awdCommitScene(scene_));
  EXPECT_EQ(info().skipped, 4u);
  EXPECT_EQ(shoot(0.5f, 0.5f).mesh, AWD_INVALID_ID);
}

TEST_F(BadScene, AlbedoAndEmissionOutOfRange) {
  const float albedos[] = {-0.01f, 1.001f, kNaN, kInfinity, -kInfinity};
  const float emissions[] = {-1e-6f, kNaN, kInfinity, -kInfinity};
  for (size_t channel = 0; channel < 3; ++channel) {
    for (const float bad : albedos) {
      AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
      desc.albedo[channel] = bad;
      uint32_t material = 77;
      expectFailure(awdAddMaterial(scene_, &desc, &material), AWD_ERROR_INVALID_ARGUMENT,
                    {"albedo"});
    }
    for (const float bad : emissions) {
      AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
      desc.emission[channel] = bad;
      expectFailure(awdAddMaterial(scene_, &desc, nullptr), AWD_ERROR_INVALID_ARGUMENT,
                    {"emission"});
    }
  }
  const AWDMaterialDesc whiteAndBright = {sizeof whiteAndBright, {1, 1, 1}, {1e30f, 0, 0}};
  uint32_t material = 77;
  must(awdAddMaterial(scene_, &whiteAndBright, &material));
  EXPECT_EQ(material, 2u) << "a refused material takes no number";
}

void expectBlack(AWDScene scene, AWDGuide guide) {
  const AWDCamera view = camera({0.5, 0.5, 2}, {0.5, 0.5, 0}, {0, 1, 0}, 0.5, 9, 7);
  const Film film = renderFilm(scene, renderDesc(view, guide, 1), {2, 2});
  EXPECT_EQ(film.radiance, std::vector<float>(size_t{9} * 7 * 3, 0.0f));
  EXPECT_EQ(film.variance, std::vector<float>(size_t{9} * 7 * 3, 0.0f));
}

TEST_F(BadScene, WithoutLightItIsBlackAndSaysSo) {
  add(Strip(1));
  must(awdCommitScene(scene_));
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_NE(warnings_[0].find("light"), std::string::npos) << warnings_[0];
  for (const AWDGuide guide : {AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE, AWD_GUIDE_UNIFORM}) {
    expectBlack(scene_, guide);
  }
}

TEST_F(BadScene, EmptyIsBlack) {
  must(awdCommitScene(scene_));
  const AWDSceneInfo figures = info();
  EXPECT_EQ(figures.triangles, 0u);
  EXPECT_EQ(figures.materials, 2u);
  EXPECT_EQ(figures.lower[0], 0.0f);
  EXPECT_EQ(figures.upper[2], 0.0f);
  const AWDHit hit = shoot(0, 0);
  EXPECT_EQ(hit.mesh, AWD_INVALID_ID);
  EXPECT_EQ(hit.patch, AWD_INVALID_ID);
  EXPECT_EQ(hit.t, kInfinity);
  const float origin[3] = {0, 0, 0};
  uint32_t patch = 0;
  must(awdGetPointPatch(scene_, origin, &patch));
  EXPECT_EQ(patch, AWD_INVALID_ID);
  for (const AWDGuide guide : {AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE, AWD_GUIDE_UNIFORM}) {
    expectBlack(scene_, guide);
  }
}

TEST_F(BadScene, MeshWithoutTriangles) {
  Strip strip(1);
  strip.indices.clear();
  strip.materials.clear();
  strip.patches.clear();
  add(strip);
  add(Strip(1));
  must(awdCommitScene(scene_));
  EXPECT_EQ(info().triangles, 2u);
  EXPECT_EQ(shoot(0.5f, 0.25f).mesh, 1u) << "an empty mesh keeps its number";
}

TEST_F(BadScene, NothingWorksBeforeCommit) {
  add(Strip(1));
  const AWDRay ray = {{0, 0, 1}, 0.0f, {0, 0, -1}, kInfinity};
  AWDHit hit;
  uint8_t occluded = 0;
  uint32_t patch = 0;
  const float origin[3] = {0, 0, 0};
  AWDSceneInfo figures = AWD_SCENE_INFO_INIT;
  AWDRender render = reinterpret_cast<AWDRender>(&hit);
  const AWDCamera view = camera({0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 0.5, 4, 4);
  const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_COSINE, 1);
  const AWDResult refused = AWD_ERROR_INVALID_OPERATION;
  expectFailure(awdIntersect(scene_, &ray, 1, &hit), refused, {"awdCommitScene"});
  expectFailure(awdOccluded(scene_, &ray, 1, &occluded), refused, {"awdCommitScene"});
  expectFailure(awdGetTrianglePatch(scene_, 0, 0, 0, &patch), refused, {"awdCommitScene"});
  expectFailure(awdGetPointPatch(scene_, origin, &patch), refused, {"awdCommitScene"});
  expectFailure(awdGetSceneInfo(scene_, &figures), refused, {"awdCommitScene"});
  expectFailure(awdNewRender(scene_, nullptr, &desc, &render), refused, {"awdCommitScene"});
  EXPECT_EQ(render, nullptr);
}

TEST_F(BadScene, QueriesOfWhatIsNotThere) {
  add(Strip(1));
  must(awdCommitScene(scene_));
  uint32_t patch = 0;
  expectFailure(awdGetTrianglePatch(scene_, 1, 0, 0, &patch), AWD_ERROR_INVALID_ARGUMENT, {"mesh"});
  expectFailure(awdGetTrianglePatch(scene_, 0, 2, 0, &patch), AWD_ERROR_INVALID_ARGUMENT,
                {"triangle", "2"});
  const float nowhere[3] = {kNaN, 0, 0};
  expectFailure(awdGetPointPatch(scene_, nowhere, &patch), AWD_ERROR_INVALID_ARGUMENT, {"point"});
  const float farAway[3] = {0.0f, 3e38f, 0.0f};
  expectFailure(awdGetPointPatch(scene_, farAway, &patch), AWD_ERROR_INVALID_ARGUMENT,
                {"point", "1e18"});
}

/// Embree would end the program.
TEST_F(BadScene, RaysThatBeginBehindTheirOrigin) {
  add(Strip(1));
  must(awdCommitScene(scene_));
  AWDHit hit;
  uint8_t occluded;
  for (const float bad : {-1.0f, -kInfinity, kInfinity}) {
    const AWDRay ray = {{0.5f, 0.25f, 1.0f}, bad, {0.0f, 0.0f, -2.0f}, kInfinity};
    expectFailure(awdIntersect(scene_, &ray, 1, &hit), AWD_ERROR_INVALID_ARGUMENT, {"tnear"});
    expectFailure(awdOccluded(scene_, &ray, 1, &occluded), AWD_ERROR_INVALID_ARGUMENT, {"tnear"});
  }
}

/// A ray that makes no sense is a miss or an error, never a hit, and spoils no other ray.
TEST_F(BadScene, RaysThatMakeNoSense) {
  add(Strip(1));
  must(awdCommitScene(scene_));
  const AWDRay good = {{0.5f, 0.25f, 1.0f}, 0.0f, {0.0f, 0.0f, -2.0f}, kInfinity};
  AWDRay rays[7] = {good, good, good, good, good, good, good};
  rays[1].direction[2] = 0.0f;  // no direction at all
  rays[2].origin[0] = kNaN;
  rays[3].direction[1] = kNaN;
  rays[4].tnear = kNaN;
  rays[5].tfar = -1.0f;
  AWDHit hits[7];
  uint8_t occluded[7];
  const AWDResult result = awdIntersect(scene_, rays, 7, hits);
  if (result != AWD_SUCCESS) {
    EXPECT_EQ(result, AWD_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(awdOccluded(scene_, rays, 7, occluded), AWD_ERROR_INVALID_ARGUMENT);
    return;
  }
  must(awdOccluded(scene_, rays, 7, occluded));
  for (size_t i = 0; i < 7; ++i) {
    const bool sane = i == 0 || i == 6;
    EXPECT_EQ(hits[i].mesh, sane ? 0u : AWD_INVALID_ID) << i;
    EXPECT_EQ(occluded[i], sane ? 1 : 0) << i;
    if (sane) {
      EXPECT_EQ(hits[i].t, 0.5f);
    }
  }
}

/// Embree may end the process at a ray from too far away, or too fast.
TEST_F(BadScene, RaysBeyondAllMeasure) {
  add(Strip(1));
  must(awdCommitScene(scene_));
  const AWDRay good = {{0.5f, 0.25f, 1.0f}, 0.0f, {0.0f, 0.0f, -2.0f}, kInfinity};
  AWDHit hit;
  uint8_t occluded;
  for (const float far : {1e19f, -1e25f, 3e38f}) {
    AWDRay distant = good, fast = good;
    distant.origin[2] = far;
    fast.direction[2] = far;
    for (const AWDRay& ray : {distant, fast}) {
      expectFailure(awdIntersect(scene_, &ray, 1, &hit), AWD_ERROR_INVALID_ARGUMENT, {"rays[0]"});
      expectFailure(awdOccluded(scene_, &ray, 1, &occluded), AWD_ERROR_INVALID_ARGUMENT,
                    {"rays[0]"});
    }
  }
  AWDRay ray = good;
  ray.origin[2] = 1e17f;
  must(awdIntersect(scene_, &ray, 1, &hit));
}

/// Light so bright that sums overflow: such paths are left out and counted, the film is finite.
TEST_F(BadScene, BlindingLight) {
  const AWDMaterialDesc blinding = {sizeof blinding, {0.9f, 0.9f, 0.9f}, {3e38f, 1.0f, 0.0f}};
  must(awdAddMaterial(scene_, &blinding, nullptr));
  SceneBuilder room;  // materials are those of the scene: only its mesh is used
  room.box({0, 0, 0}, {1, 1, 1}, true, {2});
  const AWDMeshDesc mesh = room.mesh();
  must(awdAddMesh(scene_, &mesh, nullptr));
  must(awdCommitScene(scene_));
  for (const AWDGuide guide : {AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE, AWD_GUIDE_UNIFORM}) {
    const AWDCamera view = camera({0.5, 0.5, 0.5}, {0.5, 0, 0}, {0, 1, 0}, 0.5, 8, 8);
    const Render render = newRender(scene_, renderDesc(view, guide, 1));
    runPasses(render, {4, 4, 8});
    for (const float value : readFilm(render).radiance) {
      EXPECT_TRUE(std::isfinite(value) && value >= 0.0f) << value;
    }
    AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
    must(awdGetRenderStatistics(render, &figures));
    EXPECT_GT(figures.rejectedSamples, 0u);
    EXPECT_EQ(figures.samples, 64u * 16u);
  }
}

/// The front of a lamp shows its emission, its back is black; the same with both hands of winding.
TEST_F(BadScene, EmissionIsOnTheFrontAlone) {
  Strip strip(1);
  strip.materials.assign(2, 1);
  add(strip);
  must(awdCommitScene(scene_));
  EXPECT_TRUE(warnings_.empty());
  for (const double side : {1.0, -1.0}) {
    const AWDCamera view = camera({0.5, 0.5, side}, {0.5, 0.5, 0}, {0, 1, 0}, 0.25, 4, 4);
    const Film film = renderFilm(scene_, renderDesc(view, AWD_GUIDE_COSINE, 1), {4});
    EXPECT_EQ(film.radiance, std::vector<float>(48, side > 0.0 ? 1.0f : 0.0f));
  }
}

}  // namespace
