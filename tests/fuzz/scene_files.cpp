// SPDX-License-Identifier: Apache-2.0
// Scene and camera files through the code of the command awd: loaded, uploaded and committed, or
// refused with a reason that names the file. An OBJ file's material library follows it after a line
// "----".
#include <algorithm>
#include <cstring>
#include <new>

#include "camera_choice.h"
#include "camera_file.h"
#include "console.h"
#include "failure.h"
#include "require.h"
#include "scene_loader.h"
#include "scratch_file.h"
#include "target.h"
#include "upload.h"

// What Assimp forgets when it gives up a file is lost until the command ends, which is at once.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }

namespace fuzz {

namespace {

/// A reason of `work` must name the file; memory may also run out.
template <class Work>
void tryFile(const std::string& path, Work&& work) {
  command::mute();
  try {
    work();
  } catch (const command::Failure& failure) {
    // Material libraries stand in the same folder.
    const std::string folder = path.substr(0, path.rfind('/'));
    require(std::strstr(failure.what(), folder.c_str()) != nullptr, failure.what());
  } catch (const awd::Error& error) {
    require(std::strlen(error.what()) > 8, "refused without a reason");
  } catch (const std::bad_alloc&) {
  }
}

const awd::Device& device() {
  static const awd::Device one = [] {
    awd::DeviceDesc desc;
    desc.threads = 1;
    desc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
    return awd::Device::create(desc);
  }();
  return one;
}

void loadAll(const std::string& path) {
  tryFile(path, [&] {
    const command::SceneData data = command::loadScene(path);
    command::chooseCamera(std::nullopt, path, data);
    awd::Scene scene = command::uploadScene(device(), data, path);
    scene.commit();
  });
}

void runObj(const uint8_t* data, std::size_t size) {
  const char kBetween[] = "\n----\n";
  const uint8_t* const end = data + size;
  const uint8_t* const split = std::search(data, end, kBetween, kBetween + 6);
  const std::string path = scratchPath("scene.obj");
  writeScratch(path, {data, split});
  writeScratch(scratchPath("scene.mtl"), split == end ? Input() : Input(split + 6, end));
  loadAll(path);
}

void runGltf(const uint8_t* data, std::size_t size) {
  const bool binary = size >= 4 && std::memcmp(data, "glTF", 4) == 0;
  const std::string path = scratchPath(binary ? "scene.glb" : "scene.gltf");
  writeScratch(path, {data, data + size});
  loadAll(path);
}

void runCamera(const uint8_t* data, std::size_t size) {
  const std::string path = scratchPath("view.camera.json");
  writeScratch(path, {data, data + size});
  tryFile(path, [&] {
    AWDCamera camera = command::readCameraFile(path);
    command::resize(camera, 16, std::nullopt);
    awd::Scene scene = awd::Scene::create(device());
    scene.commit();
    camera.height = std::min(camera.height, 16u);
    AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
    desc.camera = &camera;
    desc.guide = AWD_GUIDE_COSINE;
    AWDRender render = nullptr;
    require(awdNewRender(scene.get(), nullptr, &desc, &render) == AWD_SUCCESS,
            "a camera was read that the library refuses");
    awdReleaseRender(render);
  });
}

std::vector<Input> objSeeds() {
  return {inputOf("mtllib scene.mtl\nv -1 -1 1\nv 1 -1 1\nv 1 -1 -1\nv -1 -1 -1\no box\n"
                  "usemtl white\nf 1 2 3 4\no lamp\nusemtl lamp\nf 4 3 -4\n----\n"
                  "newmtl white\nKd 0.7 0.7 0.7\nnewmtl lamp\nKd 0 0 0\nKe 17 12 8\n"),
          inputOf("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0\\\n 1\nvn 0 0 1\nvt 0 0\ns 1\ng a b\n"
                  "f 1/1/1 2/1/1 3/1/1\nl 1 2\np 1\n"),
          inputOf("# none\r\nv 0 0 0\r\nv 1e3 0 0\r\nv 0 1 0\r\nv 1 1 0\r\nf 1//1 2//1 3//1\r\n"
                  "vp 1 2\ncurv 0 1 1 2\nusemtl x y\nf 2 4 3 1 2\n")};
}

/// A square of 4 points and 6 indices, in base64 where it is text.
const char kSquare[] =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1]}],)"
    R"("nodes":[{"mesh":0,"children":[2],"scale":[1,2,1]},{"camera":0,"translation":[0,0,3]},)"
    R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}],)"
    R"("cameras":[{"type":"perspective","perspective":{"yfov":0.8,"aspectRatio":1.5,"znear":1}}],)"
    R"("materials":[{"name":"m","pbrMetallicRoughness":{"baseColorFactor":[1,0.5,0.5,1]},)"
    R"("emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":)"
    R"({"emissiveStrength":3}}}],"meshes":[{"name":"s","primitives":[{"attributes":)"
    R"({"POSITION":0},"indices":1,"material":0,"mode":4}]}],"accessors":[{"bufferView":0,)"
    R"("componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
    R"({"bufferView":1,"byteOffset":0,"componentType":5123,"count":6,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":48,"byteStride":12},{"buffer":0,"byteOffset":48,)"
    R"("byteLength":12}],"buffers":[{"byteLength":60)";
const char kData[] =
    "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA";

std::vector<Input> gltfSeeds() {
  const std::string square = kSquare;
  std::vector<Input> result = {
      inputOf(square + ",\"uri\":\"data:application/octet-stream;base64," + kData + "\"}]}"),
      inputOf(square + ",\"uri\":\"data.bin\"}]}")};
  std::string strips =
      square + ",\"uri\":\"data:application/octet-stream;base64," + kData + "\"}]}";
  strips.replace(strips.find("\"mode\":4"), 8, "\"mode\":5");
  result.push_back(inputOf(strips));
  std::string text = square + "}]}";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
  };
  std::string data(60, '\0');
  for (std::size_t i = 0; i < 6; ++i) data[48 + 2 * i] = "\0\1\2\0\2\3"[i];
  const std::string chunks =
      word(text.size()) + "JSON" + text + word(data.size()) + std::string("BIN\0", 4) + data;
  result.push_back(inputOf("glTF" + word(2) + word(12 + chunks.size()) + chunks));
  return result;
}

std::vector<Input> cameraSeeds() {
  return {inputOf(R"({"eye":[2,1.5,3.75],"look_dir":[0,0,-1],"up":[0,1,0],)"
                  R"("tan_half_fov_x":0.75,"width":64,"height":48,"else":{"a":[null,"\u00e4"]}})"),
          inputOf(R"({"eye":[0,0,0],"look_dir":[1e-40,0,1e-42],"up":[0,1e38,0],)"
                  R"("tan_half_fov_x":1e-30,"width":65536,"height":1})")};
}

}  // namespace

const Target kObj = {"obj", runObj, objSeeds};
const Target kGltf = {"gltf", runGltf, gltfSeeds};
const Target kCameraFile = {"camera-file", runCamera, cameraSeeds};

}  // namespace fuzz
