// SPDX-License-Identifier: Apache-2.0
//
// awd/scene.h in C++.
#ifndef AWD_CPP_SCENE_HPP
#define AWD_CPP_SCENE_HPP

#include "awd/cpp/buffer.hpp"
#include "awd/cpp/device.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Triangle meshes of diffuse materials, which may emit on one side.
class Scene : public Owner<Scene, AWDScene, awdRetainScene, awdReleaseScene> {
 public:
  static Returns<Scene> create(const Device& device) {
    Scene scene;
    return detail::outcome(awdNewScene(device.get(), scene.out()), scene);
  }

  /// The material's number.
  Returns<std::uint32_t> add(const AWDMaterialDesc& desc) {
    std::uint32_t material = AWD_INVALID_ID;
    return detail::outcome(awdAddMaterial(get(), &desc, &material), material);
  }
  /// The mesh's number. Buffers are copied now or, if AWD_MESH_SHARED, read by commit().
  Returns<std::uint32_t> add(const AWDMeshDesc& desc) {
    std::uint32_t mesh = AWD_INVALID_ID;
    return detail::outcome(awdAddMesh(get(), &desc, &mesh), mesh);
  }
  Returns<void> commit() {
    const detail::Call call(get());
    return detail::outcome(call, awdCommitScene(get()));
  }

  Returns<AWDSceneInfo> info() const {
    AWDSceneInfo info = AWD_SCENE_INFO_INIT;
    return detail::outcome(awdGetSceneInfo(get(), &info), info);
  }
  /// As many hits as rays.
  Returns<void> intersect(View<const AWDRay> rays, View<AWDHit> hits) const {
    if (hits.size() != rays.size()) {
      return detail::wrongSize<void>("hits", hits.size(), rays.size());
    }
    return detail::outcome(awdIntersect(get(), rays.data(), rays.size(), hits.data()));
  }
  Returns<AWDHit> intersect(const AWDRay& ray) const {
    AWDHit hit;
    return detail::outcome(awdIntersect(get(), &ray, 1, &hit), hit);
  }
  /// Writes 1 or 0 a ray.
  Returns<void> occluded(View<const AWDRay> rays, View<std::uint8_t> answers) const {
    if (answers.size() != rays.size()) {
      return detail::wrongSize<void>("answers", answers.size(), rays.size());
    }
    return detail::outcome(awdOccluded(get(), rays.data(), rays.size(), answers.data()));
  }
  Returns<bool> occluded(const AWDRay& ray) const {
    std::uint8_t answer = 0;
    const AWDResult result = awdOccluded(get(), &ray, 1, &answer);
    bool isOccluded = answer != 0;
    return detail::outcome(result, isOccluded);
  }
  Returns<std::uint32_t> trianglePatch(std::uint32_t mesh, std::uint32_t triangle,
                                       bool back = false) const {
    std::uint32_t patch = AWD_INVALID_ID;
    return detail::outcome(awdGetTrianglePatch(get(), mesh, triangle, back ? 1 : 0, &patch), patch);
  }
  Returns<std::uint32_t> pointPatch(Float3 point) const {
    std::uint32_t patch = AWD_INVALID_ID;
    return detail::outcome(awdGetPointPatch(get(), point.data(), &patch), patch);
  }
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
