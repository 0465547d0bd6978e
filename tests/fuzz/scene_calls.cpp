// SPDX-License-Identifier: Apache-2.0
// Calls of scene.h in any order, with any structs.
#include <algorithm>
#include <cmath>

#include "bounded_device.h"
#include "mesh_buffers.h"
#include "random_structs.h"
#include "render_use.h"
#include "require.h"
#include "support/handles.h"
#include "support/random.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Render;
using awdtest::Scene;

class SceneCalls {
 public:
  SceneCalls(const Bounds& bounds, Bytes& bytes) : bytes_(bytes) {
    require(awdNewScene(bounds.device(), scene_.out()) == AWD_SUCCESS, "no scene");
  }

  void next() {
    switch (bytes_.below(10)) {
      case 0:
      case 1:
        addMaterial();
        break;
      case 2:
      case 3:
      case 4:
        addMesh();
        break;
      case 5:
        commit();
        break;
      case 6:
        trace();
        break;
      case 7:
        askPatches();
        break;
      case 8:
        render();
        break;
      default:
        askInfo();
    }
  }
  void commit() {
    const bool committed =
        oneOf(awdCommitScene(scene_),
              {AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_CANCELLED}, "commit");
    committed_ |= committed;
    askInfo();
  }
  void trace() {
    AWDRay rays[4];
    for (AWDRay& ray : rays) ray = readRay(bytes_);
    AWDHit hits[4];
    uint8_t occluded[4];
    if (oneOf(awdIntersect(scene_, rays, 4, hits), wrong(), "intersect")) {
      require(committed_, "a hit before commit");
      for (const AWDHit& hit : hits) {
        const bool none = hit.mesh == AWD_INVALID_ID;
        require(!std::isnan(hit.t) && none == std::isinf(hit.t), "a hit is none");
        for (const float x : hit.normal) require(std::isfinite(x), "a normal is none");
        if (none) continue;
        uint32_t patch = 0;
        require(awdGetTrianglePatch(scene_, hit.mesh, hit.triangle, 0, &patch) == AWD_SUCCESS &&
                    patch == (hit.patch & ~AWD_PATCH_BACK),
                "a hit's triangle has another patch");
      }
    }
    oneOf(awdOccluded(scene_, rays, 4, occluded), wrong(), "occluded");
  }
  void render() {
    AWDCamera camera = readCamera(bytes_);
    AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
    desc.camera = &camera;
    desc.guide = static_cast<AWDGuide>(bytes_.below(3));
    camera.width = std::min(camera.width, 4u);
    camera.height = std::min(camera.height, 4u);
    Render render;
    if (!oneOf(awdNewRender(scene_, nullptr, &desc, render.out()), wrong(), "new render")) return;
    if (oneOf(awdRenderPass(render, 2, nullptr), {AWD_ERROR_CANCELLED, AWD_ERROR_OUT_OF_MEMORY},
              "pass")) {
      lookAt(render);
    }
  }

 private:
  std::initializer_list<AWDResult> wrong() const {
    static constexpr std::initializer_list<AWDResult> kBefore = {AWD_ERROR_INVALID_OPERATION,
                                                                 AWD_ERROR_INVALID_ARGUMENT};
    static constexpr std::initializer_list<AWDResult> kAfter = {AWD_ERROR_INVALID_ARGUMENT,
                                                                AWD_ERROR_OUT_OF_MEMORY};
    return committed_ ? kAfter : kBefore;
  }
  void addMaterial() {
    const AWDMaterialDesc desc = readMaterial(bytes_);
    uint32_t number = 0;
    if (!oneOf(awdAddMaterial(scene_, &desc, &number), {AWD_ERROR_INVALID_ARGUMENT}, "material")) {
      return;
    }
    require(number == materials_++, "a material has another number");
  }
  void addMesh() {
    meshes_.push_back(std::make_unique<MeshBuffers>(bytes_, materials_));
    const MeshBuffers& mesh = *meshes_.back();
    const bool added = oneOf(awdAddMesh(scene_, &mesh.desc(), nullptr),
                             {AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_OUT_OF_MEMORY}, "mesh");
    // What a short struct does not have is not looked at.
    const bool whole = mesh.desc().structSize >= sizeof(AWDMeshDesc);
    require(!(added && whole && mesh.impossible()), "a buffer that can't be was taken");
  }
  void askPatches() {
    const float point[3] = {real32(bytes_), real32(bytes_), real32(bytes_)};
    uint32_t patch = 0;
    oneOf(awdGetPointPatch(scene_, point, &patch), wrong(), "point");
    const uint32_t mesh = bytes_.integer(), triangle = bytes_.integer();
    oneOf(awdGetTrianglePatch(scene_, mesh, triangle, 1, &patch), wrong(), "triangle");
  }
  void askInfo() {
    AWDSceneInfo info = AWD_SCENE_INFO_INIT;
    if (!oneOf(awdGetSceneInfo(scene_, &info), {AWD_ERROR_INVALID_OPERATION}, "info")) {
      require(!committed_, "a committed scene has no figures");
      return;
    }
    require(committed_, "figures before commit");
    require(info.skipped <= info.triangles, "more skipped than there are");
    for (int i = 0; i < 3; ++i) {
      require(std::isfinite(info.lower[i]) && info.lower[i] <= info.upper[i], "no box");
    }
  }

  Bytes& bytes_;
  std::vector<std::unique_ptr<MeshBuffers>> meshes_;  // shared ones live until the end
  Scene scene_;
  uint32_t materials_ = 0;
  bool committed_ = false;
};

void run(const uint8_t* data, std::size_t size) {
  const Bounds bounds(std::size_t{64} << 20, 400);
  Bytes bytes(data, size);
  SceneCalls calls(bounds, bytes);
  for (int i = 0; i < 40 && !bytes.empty(); ++i) calls.next();
  calls.commit();
  calls.trace();
  calls.render();
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  awdtest::Random random(6);
  for (int i = 0; i < 24; ++i) {
    Input input(60 + random.bits() % 200);
    // Small numbers: plain structs.
    for (uint8_t& byte : input) byte = static_cast<uint8_t>(random.bits() % (i % 2 ? 256 : 200));
    input[0] = 0;
    result.push_back(std::move(input));
  }
  return result;
}

}  // namespace

const Target kSceneCalls = {"scene-calls", run, seeds};

}  // namespace fuzz
