// SPDX-License-Identifier: Apache-2.0
#include "render/mesh.h"

#include <gtest/gtest.h>

#include <vector>

#include "render/rooms.h"
#include "util/error.h"

namespace awd {
namespace {

TEST(Mesh, CopiesUnlessShared) {
  Soup soup = floorAndLamp();
  AWDMeshDesc desc = soup.desc();
  const Mesh copied(std::pmr::get_default_resource(), desc);
  desc.flags = AWD_MESH_SHARED;
  const Mesh shared(std::pmr::get_default_resource(), desc);
  soup.vertices[0] = 42.0f;
  EXPECT_EQ(copied.vertices()[0].v[0], -1.0f);
  EXPECT_EQ(shared.vertices()[0].v[0], 42.0f);
}

TEST(Mesh, HonoursOffsetAndStrideAtAnyAlignment) {
  std::vector<char> bytes(3 + 3 * 20);
  for (uint32_t i = 0; i < 3; ++i) {
    const float p[3] = {float(i), float(10 * i), float(100 * i)};
    std::memcpy(bytes.data() + 3 + i * 20, p, sizeof p);
  }
  const uint32_t indices[] = {0, 1, 2};
  AWDMeshDesc desc = AWD_MESH_DESC_INIT;
  desc.vertices = {bytes.data(), 3, 20, 3, AWD_FORMAT_FLOAT3, 0};
  desc.indices = {indices, 0, 0, 1, AWD_FORMAT_UINT3, 0};
  desc.material = 5;
  const Mesh mesh(std::pmr::get_default_resource(), desc);
  EXPECT_EQ(mesh.vertices()[2].v[1], 20.0f);
  EXPECT_EQ(mesh.triangles()[0].v[2], 2u);
  EXPECT_EQ(mesh.material(0), 5u);
  EXPECT_FALSE(mesh.hasPatches());
}

/// Offset and stride of a buffer that has no items lead nowhere.
TEST(Mesh, TakesEmptyBuffersWithAnyOffset) {
  AWDMeshDesc desc = AWD_MESH_DESC_INIT;
  desc.vertices = {nullptr, 31, 12, 0, AWD_FORMAT_FLOAT3, 0};
  desc.indices = {nullptr, 7, 12, 0, AWD_FORMAT_UINT3, 0};
  const Mesh mesh(std::pmr::get_default_resource(), desc);
  EXPECT_EQ(mesh.vertices().size(), 0u);
  EXPECT_EQ(mesh.triangles().size(), 0u);
}

TEST(Mesh, RefusesWhatReachesBeyondMemory) {
  const Soup soup = floorAndLamp();
  AWDMeshDesc desc = soup.desc();
  desc.flags = AWD_MESH_SHARED;
  desc.vertices.byteStride = SIZE_MAX / 2;
  EXPECT_THROW(Mesh(std::pmr::get_default_resource(), desc), Error);
  desc = soup.desc();
  desc.vertices.byteOffset = SIZE_MAX - 8;
  EXPECT_THROW(Mesh(std::pmr::get_default_resource(), desc), Error);
}

}  // namespace
}  // namespace awd
