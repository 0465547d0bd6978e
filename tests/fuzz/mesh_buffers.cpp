// SPDX-License-Identifier: Apache-2.0
#include "mesh_buffers.h"

#include <cstring>

#include "random_structs.h"

namespace fuzz {

namespace {

uint32_t bitsOf(float value) {
  uint32_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

MeshBuffers::MeshBuffers(Bytes& bytes, uint32_t materials) : desc_(AWD_MESH_DESC_INIT) {
  const uint32_t what = bytes.byte();
  const uint32_t vertices = bytes.below(9), triangles = bytes.below(7);
  std::vector<uint32_t> words;
  for (uint32_t i = 0; i < 3 * vertices; ++i) {
    // Few different coordinates: pieces in one plane, lights, triangles without area.
    words.push_back(bitsOf(what & 1 ? real32(bytes) : static_cast<float>(bytes.below(4))));
  }
  lay(bytes, desc_.vertices, words, 3, AWD_FORMAT_FLOAT3);
  words.clear();
  for (uint32_t i = 0; i < 3 * triangles; ++i) {
    words.push_back(bytes.below(64) ? bytes.below(vertices + 1) % std::max(vertices, 1u)
                                    : bytes.integer());
  }
  lay(bytes, desc_.indices, words, 3, AWD_FORMAT_UINT3);
  for (AWDBuffer* buffer : {&desc_.materials, &desc_.patches}) {
    const bool isMaterial = buffer == &desc_.materials;
    if (!(what & (isMaterial ? 2 : 4))) continue;
    words.clear();
    for (uint32_t i = 0; i < triangles; ++i) {
      words.push_back(bytes.below(64) ? bytes.below(isMaterial ? materials + 1 : 5) %
                                            std::max(isMaterial ? materials : 5u, 1u)
                                      : bytes.integer());
    }
    lay(bytes, *buffer, words, 1, AWD_FORMAT_UINT);
  }
  desc_.material = bytes.below(32) ? 0 : bytes.integer();
  if (what & 8) desc_.flags = AWD_MESH_SHARED;
  if ((what & 0xf0) == 0x10) desc_.flags |= bytes.integer();
  if ((what & 0xf0) == 0x20) {
    AWDBuffer* const buffers[] = {&desc_.vertices, &desc_.indices, &desc_.materials,
                                  &desc_.patches};
    const uint32_t which = bytes.below(4);
    spoil(bytes, *buffers[which], which < 2 ? 12 : 4);
  }
  desc_.structSize = structSize(bytes, sizeof desc_);
}

void MeshBuffers::lay(Bytes& bytes, AWDBuffer& buffer, const std::vector<uint32_t>& words,
                      size_t each, AWDFormat format) {
  const size_t count = words.size() / each, itemSize = 4 * each;
  const uint32_t how = bytes.byte();
  const size_t stride = how & 1 ? itemSize + how % 16 : 0, offset = how & 2 ? how % 32 : 0;
  const size_t step = stride ? stride : itemSize;
  const size_t size = count ? offset + (count - 1) * step + itemSize : 1;
  blocks_.push_back(std::make_unique<char[]>(size));  // to the byte: more is not to be read
  char* const data = blocks_.back().get();
  for (size_t i = 0; i < count; ++i) {
    std::memcpy(data + offset + i * step, &words[i * each], itemSize);
  }
  buffer = {data, offset, stride, count, format, 0u};
}

void MeshBuffers::spoil(Bytes& bytes, AWDBuffer& buffer, size_t itemSize) {
  blocks_.push_back(std::make_unique<char[]>(1));
  buffer.data = blocks_.back().get();
  buffer.count = 1;
  impossible_ = true;
  const size_t huge[] = {size_t{1} << 32, (size_t{1} << 32) - 1, size_t{1} << 63, ~size_t{0}};
  const uint32_t which = bytes.below(4);
  switch (bytes.below(7)) {
    case 0:  // more than an index reaches
      buffer.count = huge[which];
      break;
    case 1:  // around the address space
      buffer.count = size_t{1} << 31;
      buffer.byteStride = (size_t{1} << 33) - which;
      break;
    case 2:
      buffer.byteOffset = ~size_t{0} - which;
      break;
    case 3:
      buffer.byteStride = 1 + which % (itemSize - 1);
      break;
    case 4:
      buffer.format = static_cast<AWDFormat>(bytes.integer() | 0x10000);
      break;
    case 5:
      buffer.reserved = 1 + which;
      break;
    default:
      buffer.data = nullptr;
      buffer.count = size_t{1} << (30 + which);
  }
  if (buffer.format == AWD_FORMAT_UNDEFINED) {
    buffer.format = itemSize == 12 ? AWD_FORMAT_UINT3 : AWD_FORMAT_UINT;
  }
}

}  // namespace fuzz
