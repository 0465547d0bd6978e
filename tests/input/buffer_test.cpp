// SPDX-License-Identifier: Apache-2.0
// Buffers: strides, offsets, alignment, lengths that overflow, and nothing read or written past
// the last item.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <memory>

#include "support/expect.h"
#include "support/films.h"
#include "support/guarded.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

/// Items of `itemSize` bytes at that stride and offset, the last of which ends at a guard page;
/// bytes between items are 0xFF: NaN as a float, out of range as an index.
class GuardedItems {
 public:
  GuardedItems(const void* items, size_t count, size_t itemSize, size_t stride, size_t offset,
               AWDFormat format)
      : memory_(offset + (count - 1) * stride + itemSize), buffer_{memory_.data(), offset, stride,
                                                                   count,          format, 0u} {
    std::memset(memory_.data(), 0xFF, memory_.size());
    for (size_t i = 0; i < count; ++i) {
      std::memcpy(memory_.data() + offset + i * stride,
                  static_cast<const char*>(items) + i * itemSize, itemSize);
    }
  }
  AWDBuffer buffer() const { return buffer_; }
  void wipe() { std::memset(memory_.data(), 0xFF, memory_.size()); }

 private:
  Guarded memory_;
  AWDBuffer buffer_;
};

// Two triangles of a unit square in z = 0; the second is of patch 9 and material 1.
const float kVertices[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const uint32_t kIndices[] = {0, 1, 2, 0, 2, 3};
const uint32_t kMaterials[] = {0, 1};
const uint32_t kPatches[] = {4, 9};

Scene emptyScene(AWDDevice device) {
  Scene scene;
  must(awdNewScene(device, scene.out()));
  const AWDMaterialDesc grey = {sizeof grey, {0.5f, 0.5f, 0.5f}, {1.0f, 0.0f, 0.0f}};
  must(awdAddMaterial(scene, &grey, nullptr));
  must(awdAddMaterial(scene, &grey, nullptr));
  return scene;
}

AWDMeshDesc plainMesh() {
  AWDMeshDesc desc = AWD_MESH_DESC_INIT;
  desc.vertices = {kVertices, 0u, 0u, 4u, AWD_FORMAT_FLOAT3, 0u};
  desc.indices = {kIndices, 0u, 0u, 2u, AWD_FORMAT_UINT3, 0u};
  desc.materials = {kMaterials, 0u, 0u, 2u, AWD_FORMAT_UINT, 0u};
  desc.patches = {kPatches, 0u, 0u, 2u, AWD_FORMAT_UINT, 0u};
  return desc;
}

void expectTheSquare(AWDScene scene) {
  const float xs[2] = {0.75f, 0.25f};
  for (uint32_t triangle = 0; triangle < 2; ++triangle) {
    const AWDRay ray = {{xs[triangle], 0.5f, 3.0f}, 0.0f, {0.0f, 0.0f, -1.0f}, 10.0f};
    AWDHit hit;
    must(awdIntersect(scene, &ray, 1, &hit));
    EXPECT_EQ(hit.triangle, triangle);
    EXPECT_EQ(hit.t, 3.0f);
    EXPECT_EQ(hit.normal[2], 1.0f);
    EXPECT_EQ(hit.material, kMaterials[triangle]);
    EXPECT_EQ(hit.patch, kPatches[triangle]);
  }
}

struct Layout {
  size_t padding;  // between items, a multiple of 4
  size_t offset;
  uint32_t flags;
};

class GuardPage : public testing::TestWithParam<Layout> {};
INSTANTIATE_TEST_SUITE_P(Layouts, GuardPage,
                         testing::Values(Layout{0, 0, 0}, Layout{4, 0, 0}, Layout{20, 8, 0},
                                         Layout{4096, 4, 0}, Layout{0, 0, AWD_MESH_SHARED},
                                         Layout{4, 0, AWD_MESH_SHARED},
                                         Layout{20, 8, AWD_MESH_SHARED},
                                         Layout{4096, 4, AWD_MESH_SHARED}));

TEST_P(GuardPage, TheLastItemEndsAtIt) {
  const Layout layout = GetParam();
  const size_t p = layout.padding, o = layout.offset;
  auto vertices = std::make_unique<GuardedItems>(kVertices, 4, 12, 12 + p, o, AWD_FORMAT_FLOAT3);
  auto indices = std::make_unique<GuardedItems>(kIndices, 2, 12, 12 + p, o, AWD_FORMAT_UINT3);
  auto materials = std::make_unique<GuardedItems>(kMaterials, 2, 4, 4 + p, o, AWD_FORMAT_UINT);
  auto patches = std::make_unique<GuardedItems>(kPatches, 2, 4, 4 + p, o, AWD_FORMAT_UINT);
  AWDMeshDesc desc = AWD_MESH_DESC_INIT;
  desc.vertices = vertices->buffer();
  desc.indices = indices->buffer();
  desc.materials = materials->buffer();
  desc.patches = patches->buffer();
  desc.flags = layout.flags;

  const Device device = newDevice(2u);
  const Scene scene = emptyScene(device);
  must(awdAddMesh(scene, &desc, nullptr));
  const auto forget = [&] {
    vertices.reset(), indices.reset(), materials.reset(), patches.reset();
  };
  if (!(layout.flags & AWD_MESH_SHARED)) forget();  // copied: the host's memory may go now
  must(awdCommitScene(scene));
  forget();  // read by commit: it may go now at the latest
  expectTheSquare(scene);

  const AWDCamera view = camera({0.5, 0.5, 2}, {0.5, 0.5, 0}, {0, 1, 0}, 0.25, 4, 4);
  const Film film = renderFilm(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, 1), {2, 2});
  EXPECT_EQ(film.radiance[0], 1.0f);
}

/// The library reads or refuses what is not aligned; under the sanitizer a plain load would end
/// the test.
TEST(Misaligned, ItemsWork) {
  for (const size_t shift : {1u, 2u, 3u}) {
    for (const uint32_t flags : {0u, uint32_t{AWD_MESH_SHARED}}) {
      const GuardedItems vertices(kVertices, 4, 12, 13, shift, AWD_FORMAT_FLOAT3);
      const GuardedItems indices(kIndices, 2, 12, 15, shift, AWD_FORMAT_UINT3);
      const GuardedItems materials(kMaterials, 2, 4, 5, shift, AWD_FORMAT_UINT);
      const GuardedItems patches(kPatches, 2, 4, 7, shift, AWD_FORMAT_UINT);
      AWDMeshDesc desc = AWD_MESH_DESC_INIT;
      desc.vertices = vertices.buffer();
      desc.indices = indices.buffer();
      desc.materials = materials.buffer();
      desc.patches = patches.buffer();
      desc.flags = flags;
      const Device device = newDevice(1u);
      const Scene scene = emptyScene(device);
      must(awdAddMesh(scene, &desc, nullptr));
      must(awdCommitScene(scene));
      expectTheSquare(scene);
    }
  }
}

class Buffers : public testing::Test {
 protected:
  /// The mesh is refused, at upload or at the latest by commit, and commit then goes without it.
  void expectRefused(const AWDMeshDesc& desc, const std::vector<std::string>& parts) {
    const Scene scene = emptyScene(device_);
    uint32_t mesh = 0;
    expectFailure(awdAddMesh(scene, &desc, &mesh), AWD_ERROR_INVALID_ARGUMENT, parts);
    must(awdCommitScene(scene));
    AWDSceneInfo info = AWD_SCENE_INFO_INIT;
    must(awdGetSceneInfo(scene, &info));
    EXPECT_EQ(info.meshes, 0u);
  }

  struct Part {
    const char* name;
    AWDBuffer AWDMeshDesc::*buffer;
    size_t size;
  };
  static constexpr Part kParts[] = {{"vertices", &AWDMeshDesc::vertices, 12},
                                    {"indices", &AWDMeshDesc::indices, 12},
                                    {"materials", &AWDMeshDesc::materials, 4},
                                    {"patches", &AWDMeshDesc::patches, 4}};
  const Device device_ = newDevice(1u);
};
constexpr Buffers::Part Buffers::kParts[];

TEST_F(Buffers, StrideBelowTheItem) {
  for (const Part& part : kParts) {
    AWDMeshDesc desc = plainMesh();
    (desc.*part.buffer).byteStride = part.size - 1;
    expectRefused(desc, {part.name, std::to_string(part.size - 1), std::to_string(part.size)});
  }
}

TEST_F(Buffers, WrongFormat) {
  const AWDFormat formats[] = {AWD_FORMAT_UNDEFINED, AWD_FORMAT_UINT, AWD_FORMAT_UINT3,
                               AWD_FORMAT_FLOAT3,    0x1234,          -1};
  for (const Part& part : kParts) {
    for (const AWDFormat format : formats) {
      AWDMeshDesc desc = plainMesh();
      if (format == (desc.*part.buffer).format) continue;
      (desc.*part.buffer).format = format;
      expectRefused(desc, {part.name, "format"});
    }
  }
}

TEST_F(Buffers, NullWithItems) {
  for (const Part& part : kParts) {
    AWDMeshDesc desc = plainMesh();
    (desc.*part.buffer).data = nullptr;
    expectRefused(desc, {part.name, "NULL"});
  }
}

TEST_F(Buffers, ReservedAndUnknownFlagsMustBeZero) {
  for (const Part& part : kParts) {
    AWDMeshDesc desc = plainMesh();
    (desc.*part.buffer).reserved = 1;
    expectRefused(desc, {part.name, "reserved"});
  }
  AWDMeshDesc desc = plainMesh();
  desc.flags = 0x80u;
  expectRefused(desc, {"flags"});
}

/// Lengths that overflow an address, or that no 32-bit number can count; none of it is read.
TEST_F(Buffers, CountsThatOverflow) {
  constexpr size_t kMax = std::numeric_limits<size_t>::max();
  for (const uint32_t flags : {0u, uint32_t{AWD_MESH_SHARED}}) {
    for (const Part& part : kParts) {
      for (const size_t count : {size_t{1} << 32, size_t{1} << 33, kMax / part.size + 1, kMax}) {
        AWDMeshDesc desc = plainMesh();
        desc.flags = flags;
        (desc.*part.buffer).count = count;
        expectRefused(desc, {part.name});
      }
      AWDMeshDesc desc = plainMesh();
      desc.flags = flags;
      (desc.*part.buffer).byteStride = kMax / 2 + 16;  // the fourth item lies before the first
      (desc.*part.buffer).count = 4;
      if (part.size == 12 && std::string(part.name) == "indices") {
        desc.materials = desc.patches = AWDBuffer{};
      }
      expectRefused(desc, {part.name});
      desc = plainMesh();
      desc.flags = flags;
      (desc.*part.buffer).byteOffset = kMax - 8;
      expectRefused(desc, {part.name});
    }
  }
}

TEST_F(Buffers, MissingVerticesOrIndices) {
  AWDMeshDesc desc = plainMesh();
  desc.indices = AWDBuffer{};
  desc.materials = desc.patches = AWDBuffer{};
  const Scene scene = emptyScene(device_);
  const AWDResult added = awdAddMesh(scene, &desc, nullptr);
  if (added == AWD_SUCCESS) {
    must(awdCommitScene(scene));
  } else {
    expectFailure(added, AWD_ERROR_INVALID_ARGUMENT, {"indices"});
  }
  desc = plainMesh();
  desc.vertices = AWDBuffer{};
  const AWDResult result = awdAddMesh(scene, &desc, nullptr);
  expectFailure(result == AWD_SUCCESS ? awdCommitScene(scene) : result, AWD_ERROR_INVALID_ARGUMENT);
}

/// A film of 3 x 2 read with room between pixels and rows, the last pixel ending at a guard page.
TEST_F(Buffers, FilmIsWrittenWhereItShould) {
  const Scene scene = emptyScene(device_);
  const AWDMeshDesc desc = plainMesh();
  must(awdAddMesh(scene, &desc, nullptr));
  must(awdCommitScene(scene));
  const AWDCamera view = camera({0.5, 0.5, 2}, {0.5, 0.5, 0}, {0, 1, 0}, 0.5, 3, 2);
  const Render render = newRender(scene, renderDesc(view, AWD_GUIDE_COSINE, 1));
  must(awdRenderPass(render, 4, nullptr));
  const Film packed = readFilm(render);
  for (const size_t padding : {0u, 4u, 52u}) {
    const size_t pixel = 12 + padding, row = 3 * pixel + 3 * padding;
    const Guarded memory(row + 2 * pixel + 12);
    std::memset(memory.data(), 0x5A, memory.size());
    must(awdReadFilm(render, AWD_FILM_RADIANCE, reinterpret_cast<float*>(memory.data()), pixel,
                     row));
    std::vector<char> expected(memory.size(), 0x5A);
    for (size_t y = 0; y < 2; ++y) {
      for (size_t x = 0; x < 3; ++x) {
        std::memcpy(&expected[y * row + x * pixel], &packed.radiance[3 * (3 * y + x)], 12);
      }
    }
    EXPECT_EQ(std::vector<char>(memory.data(), memory.data() + memory.size()), expected);
  }
  const Guarded memory(72);
  float* pixels = reinterpret_cast<float*>(memory.data());
  expectFailure(awdReadFilm(render, AWD_FILM_RADIANCE, pixels, 8, 0), AWD_ERROR_INVALID_ARGUMENT,
                {"pixelStride"});
  expectFailure(awdReadFilm(render, AWD_FILM_RADIANCE, pixels, 0, 20), AWD_ERROR_INVALID_ARGUMENT,
                {"rowStride"});
  // Each of these, times the pixels or rows, comes out small again.
  constexpr size_t kMost = std::numeric_limits<size_t>::max();
  for (const size_t stride : {kMost, kMost / 2 + 1, kMost / 2 + 7}) {
    expectFailure(awdReadFilm(render, AWD_FILM_RADIANCE, pixels, stride, 0),
                  AWD_ERROR_INVALID_ARGUMENT, {"pixelStride", "no memory"});
    expectFailure(awdReadFilm(render, AWD_FILM_RADIANCE, pixels, 0, stride),
                  AWD_ERROR_INVALID_ARGUMENT, {"rowStride", "no memory"});
    const Field field = newField(device_);
    expectFailure(awdGetPatchPdf(field, 0, 2, pixels, stride), AWD_ERROR_INVALID_ARGUMENT,
                  {"rowStride", "no memory"});
  }
}

}  // namespace
