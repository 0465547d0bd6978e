// SPDX-License-Identifier: Apache-2.0
// scene_loader.h and gltf_file.h on glTF files
#include <sys/stat.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <nlohmann/json.hpp>

#include "scene_loader.h"
#include "temporary_folder.h"

using namespace command;
using nlohmann::json;

namespace {

std::string base64(const std::string& bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      group = group << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0u);
    }
    for (int shift = 18; shift >= 0; shift -= 6) text += kDigits[group >> shift & 63];
  }
  for (std::size_t k = 0; k < (3 - bytes.size() % 3) % 3; ++k) text[text.size() - 1 - k] = '=';
  return text;
}

/// The unit square at z = 0 as 4 vertices, then 6 indices of 16 bits.
std::string squareBuffer(uint16_t firstIndex = 0) {
  const float points[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const uint16_t indices[] = {firstIndex, 1, 2, 0, 2, 3};
  std::string bytes(sizeof points + sizeof indices, '\0');
  std::memcpy(bytes.data(), points, sizeof points);
  std::memcpy(bytes.data() + sizeof points, indices, sizeof indices);
  return bytes;
}

json square(int material) {
  json primitive = {{"attributes", {{"POSITION", 0}}}, {"indices", 1}};
  if (material >= 0) primitive["material"] = material;
  return primitive;
}

/// A scene of one node with one mesh of one square, and whatever `more` replaces.
json squareScene(const json& more = json::object()) {
  json file = {{"asset", {{"version", "2.0"}}},
               {"scene", 0},
               {"scenes", {{{"nodes", {0}}}}},
               {"nodes", {{{"mesh", 0}}}},
               {"meshes", {{{"name", "square"}, {"primitives", {square(-1)}}}}},
               {"accessors",
                {{{"bufferView", 0},
                  {"componentType", 5126},
                  {"count", 4},
                  {"type", "VEC3"},
                  {"min", {0, 0, 0}},
                  {"max", {1, 1, 0}}},
                 {{"bufferView", 1}, {"componentType", 5123}, {"count", 6}, {"type", "SCALAR"}}}},
               {"bufferViews",
                {{{"buffer", 0}, {"byteLength", 48}},
                 {{"buffer", 0}, {"byteOffset", 48}, {"byteLength", 12}}}},
               {"buffers",
                {{{"byteLength", 60},
                  {"uri", "data:application/octet-stream;base64," + base64(squareBuffer())}}}}};
  file.update(more);
  return file;
}

std::string word(std::size_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xFF);
  return bytes;
}

/// The same as a .glb.
std::string binaryScene() {
  json file = squareScene({{"buffers", {{{"byteLength", 60}}}}});
  std::string text = file.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string chunks =
      word(text.size()) + "JSON" + text + word(60) + std::string("BIN\0", 4) + squareBuffer();
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

class GltfTest : public TemporaryFolder {
 protected:
  std::string failure(const json& content) const { return failure("scene.gltf", content.dump()); }
  std::string failure(const std::string& name, const std::string& content) const {
    const std::string path = file(name, content);
    const std::string message = failureOf([&] { loadScene(path); });
    EXPECT_CONTAINS(message, path);
    return message;
  }
  SceneData load(const json& content) {
    const std::string path = file("scene.gltf", content.dump());
    testing::internal::CaptureStderr();
    SceneData scene = loadScene(path);
    said_ = testing::internal::GetCapturedStderr();
    return scene;
  }
  std::string said_;
};

json diffuse(const char* name, float red) {
  return {{"name", name},
          {"pbrMetallicRoughness", {{"baseColorFactor", {red, 0, 0, 1}}, {"metallicFactor", 0}}}};
}

TEST_F(GltfTest, EmissionIsFactorTimesStrength) {
  json lamp = diffuse("lamp", 0.5f), glow = diffuse("glow", 0.25f);
  lamp["emissiveFactor"] = {1.0, 0.5, 0.25};
  lamp["extensions"]["KHR_materials_emissive_strength"]["emissiveStrength"] = 17;
  glow["emissiveFactor"] = {0.5, 0.5, 0.5};
  const SceneData scene = load(squareScene({{"materials", {lamp, glow, diffuse("dark", 1)}}}));
  EXPECT_EQ(said_, "");
  ASSERT_GE(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[0].emission, (std::array<float, 3>{17.0f, 8.5f, 4.25f}));
  EXPECT_EQ(scene.materials[0].albedo, (std::array<float, 3>{0.5f, 0.0f, 0.0f}));
  EXPECT_EQ(scene.materials[1].emission, (std::array<float, 3>{0.5f, 0.5f, 0.5f}));
  EXPECT_EQ(scene.materials[2].emission, (std::array<float, 3>{}));
}

TEST_F(GltfTest, MaterialsStayWithTheirMeshesInWhateverOrderTheyAreUsed) {
  // Used in the order 2, 0, 3, none, 2, 0; material 1 not at all.
  const SceneData scene = load(squareScene(
      {{"materials",
        {diffuse("m0", 0.0f), diffuse("m1", 0.1f), diffuse("m2", 0.2f), diffuse("m3", 0.3f)}},
       {"meshes",
        {{{"name", "same"}, {"primitives", {square(3), square(-1)}}},
         {{"primitives", {square(1)}}},
         {{"name", "same"}, {"primitives", {square(2), square(0)}}}}},
       {"scenes", {{{"nodes", {1, 0}}}}},
       {"nodes",
        {{{"mesh", 0}, {"name", "same"}},
         {{"mesh", 2}, {"name", "same"}, {"children", {2}}},
         {{"mesh", 2}}}}}));
  std::vector<std::string> names;
  for (const Mesh& mesh : scene.meshes) names.push_back(scene.materials.at(mesh.material).name);
  EXPECT_EQ(names, (std::vector<std::string>{"m2", "m0", "m2", "m0", "m3", "default"}));
  EXPECT_EQ(scene.materials.back().albedo, (std::array<float, 3>{1.0f, 1.0f, 1.0f}));
}

TEST_F(GltfTest, NodesTransformAndMirrorsKeepTheFrontSide) {
  const SceneData scene =
      load(squareScene({{"scenes", {{{"nodes", {0}}}}},
                        {"nodes",
                         {{{"translation", {10, 0, 0}}, {"children", {1}}},
                          {{"mesh", 0}, {"scale", {-2, 1, 1}}, {"translation", {0, 5, 0}}}}}}));
  const Mesh& mesh = scene.meshes.at(0);
  EXPECT_EQ(mesh.vertices.at(2), (std::array<float, 3>{8.0f, 6.0f, 0.0f}));
  // The square's normal is +z, and mirroring x does not change that.
  for (const std::array<uint32_t, 3>& t : mesh.triangles) {
    const auto &a = mesh.vertices.at(t[0]), &b = mesh.vertices.at(t[1]),
               &c = mesh.vertices.at(t[2]);
    EXPECT_GT((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 0.0f);
  }
}

TEST_F(GltfTest, CameraOfANode) {
  const double s = std::sqrt(0.5);
  const SceneData scene = load(
      squareScene({{"scenes", {{{"nodes", {0, 1}}}}},
                   {"cameras",
                    {{{"type", "perspective"},
                      {"perspective", {{"yfov", 1.0}, {"aspectRatio", 2.0}, {"znear", 0.1}}}}}},
                   {"nodes",
                    {{{"mesh", 0}},
                     {{"translation", {0, 0, 3}}, {"children", {2}}},
                     // A quarter turn about x: the camera looks along +y, its top towards +z.
                     {{"camera", 0}, {"rotation", {s, 0, 0, s}}, {"translation", {1, 2, 0}}}}}}));
  ASSERT_TRUE(scene.camera);
  const AWDCamera& camera = *scene.camera;
  const float eye[] = {1, 2, 3}, look[] = {0, 1, 0}, up[] = {0, 0, 1};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(camera.eye[i], eye[i], 1e-6);
    EXPECT_NEAR(camera.lookDir[i], look[i], 1e-6);
    EXPECT_NEAR(camera.up[i], up[i], 1e-6);
  }
  EXPECT_NEAR(camera.tanHalfFovX, 2.0 * std::tan(0.5), 1e-6);
  EXPECT_EQ(camera.width, 512u);
  EXPECT_EQ(camera.height, 256u);
}

TEST_F(GltfTest, TellsWhichOfSeveralCamerasAndSkipsThoseOutsideTheScene) {
  const json lens = {{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0.1}}}};
  const SceneData scene = load(squareScene({{"scenes", {{{"nodes", {0, 2, 3}}}}},
                                            {"cameras", {lens}},
                                            {"nodes",
                                             {{{"mesh", 0}},
                                              {{"camera", 0}, {"name", "outside"}},
                                              {{"camera", 0}, {"name", "first"}},
                                              {{"camera", 0}, {"name", "second"}}}}}));
  EXPECT_TRUE(scene.camera);
  EXPECT_CONTAINS(said_, "\"first\"");
}

TEST_F(GltfTest, OrthographicCamerasAreNone) {
  const SceneData scene = load(
      squareScene({{"scenes", {{{"nodes", {0, 1}}}}},
                   {"cameras",
                    {{{"type", "orthographic"},
                      {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0.1}}}}}},
                   {"nodes", {{{"mesh", 0}}, {{"camera", 0}}}}}));
  EXPECT_FALSE(scene.camera);
}

TEST_F(GltfTest, WarnsOfWhatADiffuseRendererLeavesOut) {
  json textured = diffuse("wood", 1.0f);
  textured["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 0;
  const json metal = {{"name", "metal"}};  // metallicFactor is 1 when absent
  load(
      squareScene({{"materials", {textured, metal}}, {"extensionsUsed", {"KHR_lights_punctual"}}}));
  EXPECT_CONTAINS(said_, "textures of 1 materials are ignored");
  EXPECT_CONTAINS(said_, "1 materials are metallic");
  EXPECT_CONTAINS(said_, "only surfaces emit");
}

TEST_F(GltfTest, BinaryFilesAreReadAndTruncatedOnesAreNot) {
  const std::string whole = binaryScene();
  const std::string path = file("scene.glb", whole);
  testing::internal::CaptureStderr();
  EXPECT_EQ(loadScene(path).meshes.at(0).triangles.size(), 2u);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_FALSE(failure("cut.glb", whole.substr(0, size)).empty()) << size;
  }
  EXPECT_CONTAINS(failure("cut.glb", whole.substr(0, whole.size() - 1)), "is truncated");
}

TEST_F(GltfTest, TriangleWithABadIndexIsNotDropped) {
  json file = squareScene();
  file["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(squareBuffer(200));
  const std::string message = failure(file);
  EXPECT_CONTAINS(message, "\"square\"");
  EXPECT_CONTAINS(message, "1 of 2 triangles have an index out of range");
}

TEST_F(GltfTest, RefusesBrokenFiles) {
  EXPECT_CONTAINS(failure("scene.gltf", ""), "is no glTF file");
  EXPECT_CONTAINS(failure("scene.gltf", R"({"asset": {"version": "2.0")"), "is no glTF file");
  EXPECT_CONTAINS(failure("scene.gltf", "[]"), "no JSON object");
  EXPECT_CONTAINS(failure("scene.gltf", "{}"), "is no glTF file");
  EXPECT_CONTAINS(failure({{"asset", {{"version", "1.0"}}}}), "is glTF 1.0");
  EXPECT_CONTAINS(failure(squareScene({{"extensionsRequired", {"KHR_draco_mesh_compression"}}})),
                  "needs extension KHR_draco_mesh_compression");
  EXPECT_CONTAINS(failure(squareScene({{"materials", {{{"emissiveFactor", {1, "x", 1}}}}}})),
                  "material 0");
  EXPECT_CONTAINS(failure(squareScene({{"materials", {{{"emissiveFactor", {1}}}}}})), "material 0");
  EXPECT_CONTAINS(failure(squareScene({{"buffers", {{{"byteLength", 60}, {"uri", "no.bin"}}}}})),
                  "no.bin");
  EXPECT_FALSE(failure(squareScene({{"nodes", "x"}})).empty());
  EXPECT_FALSE(failure(squareScene({{"nodes", {{{"mesh", 7}}}}})).empty());
  EXPECT_FALSE(failure(squareScene({{"nodes", {{{"children", {0}}}}}})).empty());
  EXPECT_FALSE(failure(squareScene({{"bufferViews", json::array()}})).empty());
  EXPECT_CONTAINS(failure(squareScene({{"nodes", {json::object()}}})), "has no triangles");
}

TEST_F(GltfTest, RefusesDegenerateCameras) {
  for (const json& yfov : {json(0.0), json(-1.0), json(4.0), json("wide")}) {
    EXPECT_FALSE(failure(squareScene({{"cameras",
                                       {{{"type", "perspective"},
                                         {"perspective", {{"yfov", yfov}, {"znear", 0.1}}}}}},
                                      {"scenes", {{{"nodes", {0, 1}}}}},
                                      {"nodes", {{{"mesh", 0}}, {{"camera", 0}}}}}))
                     .empty())
        << yfov;
  }
}

/// What each of these made Assimp do: read or write beyond its memory, recurse until the stack was
/// used up, or take all memory.
TEST_F(GltfTest, WhatAssimpTrustsInIsChecked) {
  const auto expectRefused = [&](const std::function<void(json&)>& change, const char* part) {
    json file = squareScene();
    change(file);
    EXPECT_CONTAINS(failure(file), part);
  };
  constexpr uint64_t kAlmost64 = ~uint64_t{0} - 15;
  const auto at = [](const char* list, int index, const char* key, const json& value) {
    return [=](json& file) { file[list][index][key] = value; };
  };
  expectRefused(at("bufferViews", 0, "byteOffset", kAlmost64), "byteOffset");
  expectRefused(at("bufferViews", 0, "byteOffset", 13), "beyond its buffer");
  expectRefused(at("bufferViews", 1, "byteLength", uint64_t{1} << 32), "beyond its buffer");
  expectRefused(at("bufferViews", 0, "byteStride", 4), "beyond its bufferView");
  expectRefused(at("accessors", 0, "byteOffset", kAlmost64), "byteOffset");
  expectRefused(at("accessors", 0, "byteOffset", 1), "beyond its bufferView");
  expectRefused(at("accessors", 0, "count", uint64_t{1} << 31), "beyond its bufferView");
  expectRefused(at("accessors", 1, "count", uint64_t{1} << 32), "count");
  expectRefused(at("accessors", 1, "count", -1), "count");
  expectRefused(at("accessors", 1, "count", 0), "is empty");
  expectRefused(at("accessors", 1, "type", "VEC3"), "not of indices");
  expectRefused(at("accessors", 1, "componentType", 5126), "not of indices");
  expectRefused(at("accessors", 0, "componentType", 5121), "not of positions");
  expectRefused(at("accessors", 0, "sparse", {{"count", 4294967295u}}), "sparse");
  expectRefused([](json& file) { file["accessors"][0].erase("bufferView"); }, "no bufferView");
  for (const int mode : {5, 6}) {
    expectRefused(
        [&](json& file) {
          file["accessors"][1]["count"] = 1;
          file["meshes"][0]["primitives"][0]["mode"] = mode;
        },
        "of 1 corners");
  }
  expectRefused(at("nodes", 0, "children", {0}), "its own ancestor");
  expectRefused(
      [](json& file) {
        file["nodes"] = {{{"children", {1, 1}}}, {{"mesh", 0}}};
      },
      "two parents");
  const auto chain = [](std::size_t length) {
    return [=](json& file) {
      file["nodes"] = json::array();
      for (std::size_t i = 1; i < length; ++i) file["nodes"].push_back({{"children", {i}}});
      file["nodes"].push_back({{"mesh", 0}});
    };
  };
  expectRefused(chain(100000), "levels deep");
  json deep = squareScene();
  chain(500)(deep);
  EXPECT_EQ(load(deep).meshes.size(), 1u);

  std::string nested = squareScene().dump();
  nested.pop_back();
  nested += ",\"extras\":" + std::string(100000, '[') + std::string(100000, ']') + "}";
  EXPECT_CONTAINS(failure("nested.gltf", nested), "nested too deep");
  nested = squareScene({{"extras", std::string(200, '[') + "\"\\"}}).dump();
  EXPECT_EQ(load(json::parse(nested)).meshes.size(), 1u) << "brackets in texts are none";
  std::string cut = binaryScene();
  cut.resize(cut.size() - 1);
  cut.replace(8, 4, word(cut.size()));
  EXPECT_CONTAINS(failure("cut.glb", cut), "truncated within its data");
}

TEST_F(GltfTest, APipeIsNoBuffer) {
  const std::string pipe = folder() + "/pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  json file = squareScene();
  file["buffers"][0]["uri"] = "pipe";
  EXPECT_NE(failure(file), "") << "and it did not wait for it";
}

}  // namespace
