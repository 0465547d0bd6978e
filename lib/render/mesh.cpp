// SPDX-License-Identifier: Apache-2.0
#include "render/mesh.h"

#include <cstdint>

#include "util/error.h"

namespace awd {

namespace {

/// More vertices or triangles in one mesh than a 32-bit index reaches can't be told apart.
constexpr std::size_t kMostItems = 0xFFFFFFFEu;

void check(const AWDBuffer& buffer, const char* name, AWDFormat format, const char* formatName,
           std::size_t itemSize) {
  if (!buffer.data) {
    if (buffer.count == 0) return;
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s.data is NULL, but its count is %zu", name,
         buffer.count);
  }
  if (buffer.format != format) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s.format is 0x%x: it must be %s", name,
         static_cast<unsigned>(buffer.format), formatName);
  }
  if (buffer.reserved != 0) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s.reserved is %u: it must be 0", name,
         buffer.reserved);
  }
  if (buffer.byteStride != 0 && buffer.byteStride < itemSize) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s.byteStride is %zu: an item has %zu bytes", name,
         buffer.byteStride, itemSize);
  }
  if (buffer.count > kMostItems) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s.count is %zu: at most %zu are possible", name,
         buffer.count, kMostItems);
  }
  const std::size_t stride = buffer.byteStride ? buffer.byteStride : itemSize;
  std::size_t end;
  if (__builtin_mul_overflow(buffer.count, stride, &end) ||
      __builtin_add_overflow(end, buffer.byteOffset, &end) ||
      __builtin_add_overflow(end, reinterpret_cast<std::uintptr_t>(buffer.data), &end)) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "desc->%s ends beyond the address space: %zu items of stride %zu from byte %zu", name,
         buffer.count, stride, buffer.byteOffset);
  }
}

}  // namespace

Mesh::Mesh(std::pmr::memory_resource* memory, const AWDMeshDesc& desc)
    : desc_(desc), blocks_(memory) {
  check(desc.vertices, "vertices", AWD_FORMAT_FLOAT3, "AWD_FORMAT_FLOAT3", sizeof(Float3));
  check(desc.indices, "indices", AWD_FORMAT_UINT3, "AWD_FORMAT_UINT3", sizeof(UInt3));
  check(desc.materials, "materials", AWD_FORMAT_UINT, "AWD_FORMAT_UINT", sizeof(uint32_t));
  check(desc.patches, "patches", AWD_FORMAT_UINT, "AWD_FORMAT_UINT", sizeof(uint32_t));
  if (desc.flags & ~static_cast<uint32_t>(AWD_MESH_SHARED)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->flags is 0x%x: only AWD_MESH_SHARED is known",
         desc.flags);
  }
  const auto checkCount = [&](const AWDBuffer& buffer, const char* name) {
    if (buffer.data && buffer.count != desc.indices.count) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "desc->%s.count is %zu, but there are %zu triangles", name,
           buffer.count, desc.indices.count);
    }
  };
  checkCount(desc.materials, "materials");
  checkCount(desc.patches, "patches");
  if (!(desc.flags & AWD_MESH_SHARED)) {
    blocks_.reserve(4);
    copy(desc_.vertices, sizeof(Float3));
    copy(desc_.indices, sizeof(UInt3));
    copy(desc_.materials, sizeof(uint32_t));
    copy(desc_.patches, sizeof(uint32_t));
  }
}

void Mesh::copy(AWDBuffer& buffer, std::size_t itemSize) {
  if (!buffer.data || buffer.count == 0) return;
  const std::size_t stride = buffer.byteStride ? buffer.byteStride : itemSize;
  const char* source = static_cast<const char*>(buffer.data) + buffer.byteOffset;
  std::pmr::vector<char>& block = blocks_.emplace_back(buffer.count * itemSize);
  for (std::size_t i = 0; i < buffer.count; ++i) {
    std::memcpy(block.data() + i * itemSize, source + i * stride, itemSize);
  }
  buffer.data = block.data();
  buffer.byteOffset = 0;
  buffer.byteStride = itemSize;
}

}  // namespace awd
