// SPDX-License-Identifier: Apache-2.0
// A mesh as the host gave it: buffers with offset and stride, copied or shared until commit.
#pragma once

#include <cstring>
#include <memory_resource>
#include <vector>

#include "awd/scene.h"

namespace awd {

/// Reads the items of a checked buffer, wherever they lie and however they are aligned. T is made
/// of 4-byte numbers.
template <class T>
class BufferReader {
 public:
  BufferReader() = default;
  explicit BufferReader(const AWDBuffer& buffer)
      : first_(buffer.count ? static_cast<const char*>(buffer.data) + buffer.byteOffset : nullptr),
        stride_(buffer.byteStride ? buffer.byteStride : sizeof(T)),
        count_(buffer.count) {}

  std::size_t size() const { return count_; }
  T operator[](std::size_t i) const {
    T item;
    std::memcpy(&item, first_ + i * stride_, sizeof item);
    return item;
  }

 private:
  const char* first_ = nullptr;
  std::size_t stride_ = sizeof(T);
  std::size_t count_ = 0;
};

struct Float3 {
  float v[3];
};
struct UInt3 {
  uint32_t v[3];
};

class Mesh {
 public:
  /// Checks the form of the buffers, not their contents; copies them unless AWD_MESH_SHARED.
  Mesh(std::pmr::memory_resource* memory, const AWDMeshDesc& desc);

  BufferReader<Float3> vertices() const { return BufferReader<Float3>(desc_.vertices); }
  BufferReader<UInt3> triangles() const { return BufferReader<UInt3>(desc_.indices); }
  bool hasPatches() const { return desc_.patches.data != nullptr; }
  uint32_t material(std::size_t triangle) const {
    return desc_.materials.data ? BufferReader<uint32_t>(desc_.materials)[triangle]
                                : desc_.material;
  }
  uint32_t patch(std::size_t triangle) const {
    return BufferReader<uint32_t>(desc_.patches)[triangle];
  }

 private:
  void copy(AWDBuffer& buffer, std::size_t itemSize);

  AWDMeshDesc desc_;
  /// One block a copied buffer; blocks don't move when the mesh does.
  std::pmr::vector<std::pmr::vector<char>> blocks_;
};

}  // namespace awd
