// SPDX-License-Identifier: Apache-2.0
#include "paper_cut.h"

#include "scene_loader.h"
#include "support/handles.h"
#include "upload.h"

namespace bench::paper {
namespace {

using Corner = std::array<float, 3>;

Corner between(const Corner& a, const Corner& b, const Corner& c, uint32_t i, uint32_t k,
               uint32_t n) {
  Corner point = {};
  for (std::size_t x = 0; x < 3; ++x) {
    const double u = double{1} * i / n, v = double{1} * k / n;
    point[x] = static_cast<float>(a[x] + u * (double{b[x]} - a[x]) + v * (double{c[x]} - a[x]));
  }
  return point;
}

command::Mesh cutMesh(const command::Mesh& mesh, uint32_t n) {
  command::Mesh cut;
  cut.name = mesh.name;
  cut.material = mesh.material;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<uint32_t>(cut.vertices.size());
    for (uint32_t i = 0; i <= n; ++i) {
      for (uint32_t k = 0; k <= n - i; ++k) {
        cut.vertices.push_back(between(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]],
                                       mesh.vertices[triangle[2]], i, k, n));
      }
    }
    // Row i begins after rows of n + 1, n, .. vertices.
    const auto at = [&](uint32_t i, uint32_t k) {
      return first + i * (n + 1) - i * (i - 1) / 2 + k;
    };
    for (uint32_t i = 0; i < n; ++i) {
      for (uint32_t k = 0; k < n - i; ++k) {
        cut.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
        if (k + 1 < n - i) cut.triangles.push_back({at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)});
      }
    }
  }
  return cut;
}

}  // namespace

LoadedScene cutScene(const awd::Device& device, const LoadedScene& whole, uint32_t n) {
  command::SceneData data = command::loadScene(whole.file);
  for (command::Mesh& mesh : data.meshes) mesh = cutMesh(mesh, n);
  LoadedScene loaded;
  loaded.name = whole.name;
  loaded.file = whole.file;
  loaded.camera = whole.camera;
  loaded.reference = whole.reference;
  loaded.scene = command::uploadScene(device, data, whole.file);
  awdtest::must(awdCommitScene(loaded.scene.get()));
  return loaded;
}

}  // namespace bench::paper
