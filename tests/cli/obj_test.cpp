// SPDX-License-Identifier: Apache-2.0
// scene_loader.h and obj_text.h on OBJ files
#include "scene_loader.h"

#include "temporary_folder.h"

using namespace command;

namespace {

const std::string kQuad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class ObjTest : public TemporaryFolder {
 protected:
  std::string failure(const std::string& content) const {
    const std::string path = file("scene.obj", content);
    const std::string message = failureOf([&] { loadScene(path); });
    EXPECT_CONTAINS(message, path);
    return message;
  }
  /// What loading says on standard error.
  std::string warnings(const std::string& content, SceneData* scene = nullptr) const {
    const std::string path = file("scene.obj", content);
    testing::internal::CaptureStderr();
    SceneData data;
    EXPECT_EQ(failureOf([&] { data = loadScene(path); }), "");
    if (scene) *scene = data;
    return testing::internal::GetCapturedStderr();
  }
};

/// Triangles of all meshes that have a material of that name.
std::size_t trianglesOf(const SceneData& scene, const std::string& material) {
  std::size_t count = 0;
  for (const Mesh& mesh : scene.meshes) {
    if (scene.materials.at(mesh.material).name == material) count += mesh.triangles.size();
  }
  return count;
}

/// All of which Assimp by itself takes for something else, or for nothing.
TEST_F(ObjTest, BlanksAndCommentsAreNoPartOfIt) {
  file("m.mtl", "newmtl lamp #1\nKe 3 3 3\n");
  for (const char* mark : {"", "\xEF\xBB\xBF"}) {
    SceneData scene;
    EXPECT_EQ(
        warnings(std::string(mark) + "mtllib m.mtl\n v 0 0 0 # the first\nv 1 0 0 # edge 2\n" +
                     "\tv 1 1 0\nv 0 1 0\n\n # nothing\n  usemtl lamp #1\n f 1 2 3 # 4\n" +
                     "f 1 3 \\\n 4\n",
                 &scene),
        "");
    EXPECT_EQ(trianglesOf(scene, "lamp #1"), 2u);
    ASSERT_EQ(scene.meshes.size(), 1u);
    for (const auto& triangle : scene.meshes[0].triangles) {
      for (const uint32_t corner : triangle) {
        const auto& at = scene.meshes[0].vertices.at(corner);
        EXPECT_EQ(at[2], 0.0f);
      }
    }
  }
  EXPECT_CONTAINS(failure("v 1 0 -1\n v 1 x 0\n"), ":2: vertex has \"x\"");
}

TEST_F(ObjTest, MaterialsKeepTheirTrianglesAndLightsTheirStrength) {
  file("m.mtl", "newmtl a\nKd 0.25 0.5 0.75\nKe 17 12048.2 1e-3\nnewmtl b with blank\nKd 1 0 0\n");
  SceneData scene;
  EXPECT_EQ(warnings("mtllib m.mtl\n" + kQuad +
                         "usemtl b with blank\nf 1 2 3 4\nusemtl a\nf 1 2 3\r\n"
                         "usemtl b with blank  \nvt 0 0\nf -4/1 -3 \\\n -2\n",
                     &scene),
            "");
  EXPECT_EQ(trianglesOf(scene, "a"), 1u);
  EXPECT_EQ(trianglesOf(scene, "b with blank"), 3u);
  for (const Material& material : scene.materials) {
    if (material.name != "a") continue;
    EXPECT_EQ(material.albedo, (std::array<float, 3>{0.25f, 0.5f, 0.75f}));
    EXPECT_EQ(material.emission, (std::array<float, 3>{17.0f, 12048.2f, 1e-3f}));
  }
}

TEST_F(ObjTest, TwoObjectsOfOneMaterialStayTwoMeshes) {
  file("m.mtl", "newmtl a\nKd 0 0 0\n");
  SceneData scene;
  warnings("mtllib m.mtl\n" + kQuad + "o one\nusemtl a\nf 1 2 3\no two\nusemtl a\nf 1 3 4\n",
           &scene);
  EXPECT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(trianglesOf(scene, "a"), 2u);
}

TEST_F(ObjTest, MissingLibraryIsAWarningAndGrey) {
  SceneData scene;
  const std::string said = warnings("mtllib no.mtl\n" + kQuad + "usemtl foo\nf 1 2 3\n", &scene);
  EXPECT_CONTAINS(said, "awd: warning: ");
  EXPECT_CONTAINS(said, "scene.obj");
  EXPECT_CONTAINS(said, "\"no.mtl\"");
  EXPECT_CONTAINS(said, "\"foo\"");
  const Material& grey = scene.materials.at(scene.meshes.at(0).material);
  EXPECT_EQ(grey.albedo, (std::array<float, 3>{0.6f, 0.6f, 0.6f}));
  EXPECT_EQ(grey.emission, (std::array<float, 3>{}));
}

TEST_F(ObjTest, LibrariesAreFoundByNamesWithBlanksOrSeveralOnALine) {
  file("my lib.mtl", "newmtl a\nKd 0.1 0.2 0.3\n");
  file("one.mtl", "newmtl a\nKd 0.1 0.2 0.3\n");
  file("two.mtl", "newmtl b\nKd 0.4 0.5 0.6\n");
  for (const char* libraries : {"my lib.mtl", "my lib.mtl ", "two.mtl one.mtl", "one.mtl\r"}) {
    SceneData scene;
    const std::string use = "mtllib " + std::string(libraries) + "\n";
    EXPECT_EQ(warnings(use + kQuad + "usemtl a\nf 1 2 3\n", &scene), "") << libraries;
    EXPECT_EQ(scene.materials.at(scene.meshes.at(0).material).albedo[1], 0.2f) << libraries;
  }
}

TEST_F(ObjTest, UndefinedMaterialIsAWarning) {
  file("m.mtl", "newmtl a\nKd 0 0 0\n");
  EXPECT_CONTAINS(warnings("mtllib m.mtl\n" + kQuad + "usemtl b\nf 1 2 3\n"),
                  "material \"b\" is not defined");
}

TEST_F(ObjTest, LinesPointsAndTexturesAreWarnings) {
  EXPECT_CONTAINS(warnings(kQuad + "f 1 2 3\nl 1 2\nl 2 3\np 1\n"), "points and lines are ignored");
  file("m.mtl", "newmtl a\nKd 0 0 0\nmap_Kd wood.png\n");
  EXPECT_CONTAINS(warnings("mtllib m.mtl\n" + kQuad + "usemtl a\nf 1 2 3\n"),
                  "textures are ignored");
}

TEST_F(ObjTest, NamesTheLineOfBadCoordinates) {
  EXPECT_CONTAINS(failure(kQuad + "v 0 nan 0\nf 1 2 3\n"), ":5: vertex has \"nan\"");
  EXPECT_CONTAINS(failure(kQuad + "v 0 0 -inf\nf 1 2 3\n"), ":5: vertex has \"-inf\"");
  EXPECT_CONTAINS(failure(kQuad + "v 1e39 0 0\nf 1 2 3\n"), ":5: vertex has \"1e39\"");
  EXPECT_CONTAINS(failure(kQuad + "v 1e999 0 0\nf 1 2 3\n"), ":5: vertex has \"1e999\"");
  EXPECT_CONTAINS(failure("v 0 0\n" + kQuad + "f 1 2 3\n"), ":1: vertex has too few numbers");
  EXPECT_CONTAINS(failure("v 0 0 .5\n" + kQuad + "f 1 2 3\n"), "write \"0.5\"");
  EXPECT_CONTAINS(failure("\nv 0 0 x\n" + kQuad + "f 1 2 3\n"), ":2: vertex has \"x\"");
}

TEST_F(ObjTest, TakesTinyAndSignedNumbers) {
  SceneData scene;
  EXPECT_CONTAINS(warnings("v +0 1e-400 0\nv +1.5e+0 0 0\nv -.5 1. +.5\nf 1 2 3\n", &scene),
                  "faces before any usemtl");
  const std::vector<std::array<float, 3>> points = {{0, 0, 0}, {1.5f, 0, 0}, {-0.5f, 1, 0.5f}};
  EXPECT_EQ(scene.meshes.at(0).vertices, points);
}

TEST_F(ObjTest, NamesTheLineOfBadFaces) {
  EXPECT_CONTAINS(failure(kQuad + "f 1 2\n"), ":5: face of 2 vertices");
  EXPECT_CONTAINS(failure(kQuad + "f 1\n"), ":5: face of 1 vertex");
  EXPECT_CONTAINS(failure(kQuad + "f\n"), ":5: face of 0 vertices");
  EXPECT_CONTAINS(failure(kQuad + "f 1 2 3\nf 1 2 9\n"), ":6: face uses vertex 9 of 4");
  EXPECT_CONTAINS(failure(kQuad + "f 1 2 -5\n"), ":5: face uses vertex -5");
  EXPECT_CONTAINS(failure(kQuad + "f 0 1 2\n"), ":5: face has \"0\"");
  EXPECT_CONTAINS(failure(kQuad + "f a b c\n"), ":5: face has \"a\"");
  EXPECT_CONTAINS(failure(kQuad + "f 1 2 99999999999999999999\n"), ":5: face has");
}

TEST_F(ObjTest, NamesTheLineOfBadColours) {
  file("m.mtl", "newmtl a\nKd 0.5 0.5 abc\n");
  EXPECT_CONTAINS(failureOf([&] { loadScene(file("scene.obj", "mtllib m.mtl\n" + kQuad)); }),
                  "m.mtl:2: Kd of material \"a\" has \"abc\"");
  file("m.mtl", "newmtl a\nKd 0.5 0.5 0.5\nKe 1 nan 1\n");
  EXPECT_CONTAINS(failureOf([&] { loadScene(file("scene.obj", "mtllib m.mtl\n" + kQuad)); }),
                  "m.mtl:3: Ke of material \"a\" has \"nan\"");
}

TEST_F(ObjTest, RefusesWhatHoldsNoTriangles) {
  EXPECT_FALSE(failure("").empty());
  EXPECT_FALSE(failure("\x01\x02\xff garbage\nmore of it\n").empty());
  EXPECT_FALSE(failure(std::string(4096, '\0')).empty());
  EXPECT_CONTAINS(failure(kQuad), "has no triangles");
  EXPECT_CONTAINS(failure(kQuad + "l 1 2\n"), "has no triangles");
}

TEST_F(ObjTest, RefusesMissingAndUnknownFiles) {
  EXPECT_CONTAINS(failureOf([&] { loadScene(folder() + "/none.obj"); }), "none.obj");
  EXPECT_CONTAINS(failureOf([&] { loadScene(folder()); }), "no such file");
  EXPECT_CONTAINS(failureOf([&] { loadScene(file("scene.dae", "<x/>")); }), ".obj, .gltf and .glb");
}

}  // namespace
