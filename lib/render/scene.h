// SPDX-License-Identifier: Apache-2.0
// The object behind AWDScene: what the host has uploaded, and the last committed geometry.
#pragma once

#include "basis/device.h"
#include "render/geometry.h"

namespace awd {

class Scene final : public RefCounted {
 public:
  static Ref<Scene> make(Ref<Device> device);
  explicit Scene(Ref<Device> device);

  Device& device() const { return *device_; }
  uint32_t addMaterial(const AWDMaterialDesc& desc);
  uint32_t addMesh(const AWDMeshDesc& desc);
  void commit();

  /// The geometry last committed; AWD_ERROR_INVALID_OPERATION if there is none.
  const Geometry& geometry() const;
  Ref<Geometry> shareGeometry() const;

  /// Queries in host coordinates.
  AWDHit intersect(const AWDRay& ray) const;
  bool occluded(const AWDRay& ray) const;
  uint32_t pointPatch(Vec3f point) const;

 private:
  void destroy() noexcept override;

  Ref<Device> device_;
  std::pmr::vector<Material> materials_;
  std::pmr::vector<Mesh> meshes_;
  Ref<Geometry> geometry_;
};

}  // namespace awd
