// SPDX-License-Identifier: Apache-2.0
// Buffers of a mesh: as large as they say, to the byte, or of a size that can't be and is to be
// refused before anything is read.
#pragma once

#include <memory>
#include <vector>

#include "awd/awd.h"
#include "bytes.h"

namespace fuzz {

class MeshBuffers {
 public:
  explicit MeshBuffers(Bytes& bytes, uint32_t materials);

  const AWDMeshDesc& desc() const { return desc_; }
  /// Has a buffer that can't be.
  bool impossible() const { return impossible_; }

 private:
  /// Items of so many words from `words`.
  void lay(Bytes& bytes, AWDBuffer& buffer, const std::vector<uint32_t>& words, size_t each,
           AWDFormat format);
  void spoil(Bytes& bytes, AWDBuffer& buffer, size_t itemSize);

  AWDMeshDesc desc_;
  std::vector<std::unique_ptr<char[]>> blocks_;
  bool impossible_ = false;
};

}  // namespace fuzz
