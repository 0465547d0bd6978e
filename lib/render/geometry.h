// SPDX-License-Identifier: Apache-2.0
// A committed scene: checked, immutable, ready to be traced. Queries and renders hold on to it.
//
// Everything lies in a normalised frame: centred on the bounding box and scaled by a power of two
// so that coordinates are within [-1,1]. So one length serves as ray epsilon for all scenes, the
// image of a scene does not depend on its unit, and scaling by powers of two changes no bit.
#pragma once

#include <memory_resource>
#include <vector>

#include "render/embree.h"
#include "render/lights.h"
#include "render/mesh.h"
#include "util/context.h"
#include "util/vec.h"

namespace awd {

struct Material {
  Rgb albedo;
  Rgb emission;
};

/// What shading needs to know of a triangle, in half a cache line.
struct Triangle {
  Vec3f normal;       ///< unit, front side
  float planeOffset;  ///< dot(normal, p) for p on the triangle
  uint32_t material;
  uint32_t patch;  ///< of the front side
  uint32_t light;  ///< kNoLight if it doesn't emit
  uint32_t source;
};

class Geometry final : public RefCounted {
 public:
  /// Checks and builds. `scene` is the handle for progress reports.
  static Ref<Geometry> build(Ref<Context> context, const void* scene,
                             const std::pmr::vector<Mesh>& meshes,
                             const std::pmr::vector<Material>& materials);

  struct Parts;  ///< what build() gathers
  explicit Geometry(Parts&& parts);

  const Embree& embree() const { return *embree_; }
  const Triangle& triangle(uint32_t index) const { return triangles_[index]; }
  const Material& material(const Triangle& triangle) const { return materials_[triangle.material]; }
  const Lights& lights() const { return lights_; }

  /// Host coordinates to the normalised frame, and lengths likewise.
  Vec3f toFrame(Vec3f p) const { return convert<float>((convert<double>(p) - center_) * scale_); }
  double scale() const { return scale_; }
  Vec3f fromFrame(Vec3f p) const {
    return convert<float>(convert<double>(p) * (1.0 / scale_) + center_);
  }

  /// A point that was hit, moved onto its triangle's plane as closely as floats allow.
  static Vec3f onPlane(const Triangle& triangle, Vec3f p) {
    return p - triangle.normal * (dot(triangle.normal, p) - triangle.planeOffset);
  }
  /// How far ray ends are lifted off a surface, against hits with itself by rounding: a few
  /// roundings of coordinates up to 1.
  static constexpr float kLift = 0x1p-20f;

  /// Where a triangle came from.
  struct Source {
    uint32_t mesh, triangle;
  };
  Source source(const Triangle& triangle) const;
  /// The index of a host's triangle; AWD_INVALID_ID if it was skipped. Checks the numbers.
  uint32_t find(uint32_t mesh, uint32_t triangle) const;

  AWDSceneInfo info() const { return info_; }
  /// Tells apart whatever is rendered differently.
  uint64_t digest() const;

 private:
  void destroy() noexcept override;

  Ref<Context> context_;
  Vec3d center_;
  double scale_;
  std::pmr::vector<Triangle> triangles_;
  std::pmr::vector<Material> materials_;
  std::pmr::vector<uint64_t> meshBegin_;  ///< first source number of each mesh, and the end
  Lights lights_;
  Owned<Embree> embree_;
  AWDSceneInfo info_;
};

}  // namespace awd
