// SPDX-License-Identifier: Apache-2.0
#include "render/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "util/digest.h"
#include "util/error.h"

namespace awd {

namespace {

/// Coordinates beyond are refused: their products leave the range of floats.
constexpr float kMostCoordinate = 1e18f;
/// A triangle is without area if its double area is below this share of its longest edge squared:
/// less than rounding its corners to floats can bring about.
constexpr double kLeastAspect = 1e-12;

/// The back side of this number would be AWD_INVALID_ID.
/// Their corners are numbered by 32 bits.
constexpr uint32_t kMostTriangles = 0xFFFFFFFFu / 3;
constexpr uint32_t kPatchEnd = AWD_INVALID_ID & ~AWD_PATCH_BACK;

Vec3d corner(const Mesh& mesh, uint32_t index) {
  const Float3 p = mesh.vertices()[index];
  return {p.v[0], p.v[1], p.v[2]};
}

void checkMesh(const Mesh& mesh, uint32_t number, std::size_t materialCount) {
  const auto vertices = mesh.vertices();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Float3 p = vertices[i];
    for (const float coordinate : p.v) {
      if (!(std::abs(coordinate) <= kMostCoordinate)) {
        fail(AWD_ERROR_INVALID_ARGUMENT,
             "mesh %u, vertex %zu is (%g, %g, %g): coordinates must be finite and at most 1e18",
             number, i, p.v[0], p.v[1], p.v[2]);
      }
    }
  }
  const auto triangles = mesh.triangles();
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const uint32_t index : triangles[i].v) {
      if (index >= vertices.size()) {
        fail(AWD_ERROR_INVALID_ARGUMENT,
             "mesh %u, triangle %zu has the vertex index %u: there are %zu vertices", number, i,
             index, vertices.size());
      }
    }
    const uint32_t material = mesh.material(i);
    if (material >= materialCount) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "mesh %u, triangle %zu has the material %u: there are %zu materials", number, i,
           material, materialCount);
    }
    if (mesh.hasPatches() && mesh.patch(i) >= kPatchEnd) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "mesh %u, triangle %zu has the patch %u: it must be below 2^31 - 1", number, i,
           mesh.patch(i));
    }
  }
}

/// Calls visit(mesh, triangle number, corners) for each triangle that has an area.
template <class Visit>
void forEachTriangle(const std::pmr::vector<Mesh>& meshes, Visit&& visit) {
  for (uint32_t m = 0; m < meshes.size(); ++m) {
    const auto triangles = meshes[m].triangles();
    for (uint32_t i = 0; i < triangles.size(); ++i) {
      const UInt3 index = triangles[i];
      const Vec3d p[3] = {corner(meshes[m], index.v[0]), corner(meshes[m], index.v[1]),
                          corner(meshes[m], index.v[2])};
      const Vec3d edges[3] = {p[1] - p[0], p[2] - p[1], p[0] - p[2]};
      const double longest =
          std::max({dot(edges[0], edges[0]), dot(edges[1], edges[1]), dot(edges[2], edges[2])});
      if (length(cross(edges[0], edges[1])) > kLeastAspect * longest) visit(m, i, p);
    }
  }
}

bool emits(const Material& material) { return maxComponent(material.emission) > 0.0f; }

}  // namespace

struct Geometry::Parts {
  Ref<Context> context;
  std::pmr::memory_resource* memory = context->memory();
  Vec3d center, lower, upper;
  double scale = 1.0;
  std::pmr::vector<Triangle> triangles{memory};
  std::pmr::vector<Material> materials{memory};
  std::pmr::vector<uint64_t> meshBegin{memory};
  Lights lights{memory};
  Owned<Embree> embree{nullptr, {memory}};
  uint64_t patchCount = 0;
  std::pmr::vector<Vec3f> corners{memory};
  std::pmr::vector<Vec3f> normals{memory};

  explicit Parts(Ref<Context> owner) : context(std::move(owner)) {}
  void placeFrame(const std::pmr::vector<Mesh>& meshes);
  void gatherTriangles(const std::pmr::vector<Mesh>& meshes);
  void findPieces(const std::pmr::vector<Mesh>& meshes);
  void gatherLights(const Pieces& pieces);
};

void Geometry::Parts::placeFrame(const std::pmr::vector<Mesh>& meshes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  lower = {kInfinity, kInfinity, kInfinity};
  upper = -lower;
  forEachTriangle(meshes, [&](uint32_t, uint32_t, const Vec3d* p) {
    for (int k = 0; k < 3; ++k) {
      lower = {std::min(lower.x, p[k].x), std::min(lower.y, p[k].y), std::min(lower.z, p[k].z)};
      upper = {std::max(upper.x, p[k].x), std::max(upper.y, p[k].y), std::max(upper.z, p[k].z)};
    }
  });
  if (!(lower.x <= upper.x)) {
    lower = upper = {};
    return;
  }
  center = (lower + upper) * 0.5;
  const double extent = maxComponent(upper - center);
  if (extent > 0.0) scale = std::ldexp(1.0, -(std::ilogb(extent) + 1));
}

void Geometry::Parts::gatherTriangles(const std::pmr::vector<Mesh>& meshes) {
  meshBegin.push_back(0);
  for (const Mesh& mesh : meshes) meshBegin.push_back(meshBegin.back() + mesh.triangles().size());
  if (meshBegin.back() > kMostTriangles) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "the scene has %llu triangles: at most %u are possible",
         static_cast<unsigned long long>(meshBegin.back()), kMostTriangles);
  }
  forEachTriangle(meshes, [&](uint32_t m, uint32_t i, const Vec3d* p) {
    Vec3f q[3];
    for (int k = 0; k < 3; ++k) q[k] = convert<float>((p[k] - center) * scale);
    // Of the corners as they are traced, unless rounding has left no area.
    Vec3d across = cross(convert<double>(q[1] - q[0]), convert<double>(q[2] - q[0]));
    if (!(length(across) > 0.0)) across = cross(p[1] - p[0], p[2] - p[0]) * (scale * scale);
    const Vec3f normal = convert<float>(normalized(across));
    corners.insert(corners.end(), q, q + 3);
    normals.push_back(normal);
    triangles.push_back({normal, dot(normal, q[0]), meshes[m].material(i), 0, kNoLight,
                         static_cast<uint32_t>(meshBegin[m] + i)});
  });
}

void Geometry::Parts::findPieces(const std::pmr::vector<Mesh>& meshes) {
  const TriangleAdjacency adjacency(memory, corners);
  // Patches: the host's ids as they are, planar pieces numbered after them.
  std::pmr::vector<uint32_t> labels(triangles.size(), 0, memory);
  std::pmr::vector<uint32_t> hostIds(memory);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto m = static_cast<std::size_t>(
        std::upper_bound(meshBegin.begin(), meshBegin.end(), triangles[t].source) -
        meshBegin.begin() - 1);
    if (!meshes[m].hasPatches()) continue;
    labels[t] = kNoPiece;
    triangles[t].patch = meshes[m].patch(triangles[t].source - meshBegin[m]);
    hostIds.push_back(triangles[t].patch);
  }
  std::sort(hostIds.begin(), hostIds.end());
  hostIds.erase(std::unique(hostIds.begin(), hostIds.end()), hostIds.end());
  const uint64_t base = hostIds.empty() ? 0 : uint64_t{hostIds.back()} + 1;
  const Pieces patches = planarPieces(memory, corners, normals, adjacency, labels);
  if (base + patches.count > kPatchEnd) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "patch %u of the host leaves no numbers below 2^31 - 1 for %u planar pieces",
         hostIds.back(), patches.count);
  }
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (labels[t] != kNoPiece) {
      triangles[t].patch = static_cast<uint32_t>(base) + patches.ofTriangle[t];
    }
  }
  patchCount = hostIds.size() + patches.count;

  for (std::size_t t = 0; t < triangles.size(); ++t) {
    labels[t] = emits(materials[triangles[t].material]) ? triangles[t].material : kNoPiece;
  }
  gatherLights(planarPieces(memory, corners, normals, adjacency, labels));
}

void Geometry::Parts::gatherLights(const Pieces& pieces) {
  std::pmr::vector<uint32_t> emissive(memory);
  for (uint32_t t = 0; t < triangles.size(); ++t) {
    triangles[t].light = pieces.ofTriangle[t];
    if (triangles[t].light != kNoLight) emissive.push_back(t);
  }
  // Not std::stable_sort, whose memory is not the host's.
  std::sort(emissive.begin(), emissive.end(), [&](uint32_t a, uint32_t b) {
    return triangles[a].light != triangles[b].light ? triangles[a].light < triangles[b].light
                                                    : a < b;
  });
  std::pmr::vector<Vec3f> own(memory);
  for (std::size_t begin = 0, end; begin < emissive.size(); begin = end) {
    const Triangle& first = triangles[emissive[begin]];
    own.clear();
    for (end = begin; end < emissive.size(); ++end) {
      if (triangles[emissive[end]].light != first.light) break;
      const Vec3f* p = &corners[3 * std::size_t{emissive[end]}];
      own.insert(own.end(), p, p + 3);
    }
    lights.add(first.normal, materials[first.material].emission, own);
  }
  lights.finish();
}

Ref<Geometry> Geometry::build(Ref<Context> context, const void* scene,
                              const std::pmr::vector<Mesh>& meshes,
                              const std::pmr::vector<Material>& materials) {
  Progress progress(*context, "commit", scene, 1);
  const auto reached = [&progress](double fraction) {
    progress.report(fraction);
    progress.throwIfCancelled();
  };
  for (uint32_t m = 0; m < meshes.size(); ++m) checkMesh(meshes[m], m, materials.size());
  reached(0.05);
  Parts parts(std::move(context));
  parts.materials.assign(materials.begin(), materials.end());
  parts.placeFrame(meshes);
  reached(0.1);
  parts.gatherTriangles(meshes);
  reached(0.2);
  parts.findPieces(meshes);
  reached(Embree::kProgressBegins);
  parts.embree =
      makeOwned<Embree>(parts.memory, *parts.context, std::move(parts.corners), progress);
  reached(1.0);
  return Ref<Geometry>::adopt(make<Geometry>(parts.memory, std::move(parts)));
}

Geometry::Geometry(Parts&& parts)
    : context_(std::move(parts.context)),
      center_(parts.center),
      scale_(parts.scale),
      triangles_(std::move(parts.triangles)),
      materials_(std::move(parts.materials)),
      meshBegin_(std::move(parts.meshBegin)),
      lights_(std::move(parts.lights)),
      embree_(std::move(parts.embree)),
      info_(AWD_SCENE_INFO_INIT) {
  info_.triangles = meshBegin_.back();
  info_.skipped = meshBegin_.back() - triangles_.size();
  info_.lights = lights_.size();
  info_.patches = parts.patchCount;
  info_.meshes = static_cast<uint32_t>(meshBegin_.size() - 1);
  info_.materials = static_cast<uint32_t>(materials_.size());
  const Vec3f lower = convert<float>(parts.lower);
  const Vec3f upper = convert<float>(parts.upper);
  std::copy(&lower.x, &lower.x + 3, info_.lower);
  std::copy(&upper.x, &upper.x + 3, info_.upper);
}

void Geometry::destroy() noexcept {
  const Ref<Context> context = context_;
  unmake(context->memory(), this);
}

uint64_t Geometry::digest() const {
  Digest digest;
  digest.add(center_);
  digest.add(scale_);
  for (uint32_t t = 0; t < triangles_.size(); ++t) {
    for (int k = 0; k < 3; ++k) digest.add(embree_->corners(t)[k]);
    digest.add(triangles_[t].material);
    digest.add(triangles_[t].patch);
  }
  for (const Material& material : materials_) {
    digest.add(material.albedo);
    digest.add(material.emission);
  }
  return digest.value();
}

Geometry::Source Geometry::source(const Triangle& triangle) const {
  const auto next = std::upper_bound(meshBegin_.begin(), meshBegin_.end(), triangle.source);
  const auto mesh = static_cast<uint32_t>(next - meshBegin_.begin() - 1);
  return {mesh, static_cast<uint32_t>(triangle.source - meshBegin_[mesh])};
}

uint32_t Geometry::find(uint32_t mesh, uint32_t triangle) const {
  if (mesh + std::size_t{1} >= meshBegin_.size()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "mesh is %u: there are %zu meshes", mesh,
         meshBegin_.size() - 1);
  }
  if (triangle >= meshBegin_[mesh + 1] - meshBegin_[mesh]) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "triangle is %u: mesh %u has %llu triangles", triangle, mesh,
         static_cast<unsigned long long>(meshBegin_[mesh + 1] - meshBegin_[mesh]));
  }
  const auto number = static_cast<uint32_t>(meshBegin_[mesh] + triangle);
  const auto found =
      std::lower_bound(triangles_.begin(), triangles_.end(), number,
                       [](const Triangle& t, uint32_t source) { return t.source < source; });
  if (found == triangles_.end() || found->source != number) return AWD_INVALID_ID;
  return static_cast<uint32_t>(found - triangles_.begin());
}

}  // namespace awd
