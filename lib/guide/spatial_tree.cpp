// SPDX-License-Identifier: Apache-2.0
#include "guide/spatial_tree.h"

#include <algorithm>
#include <cmath>

namespace awd {

namespace {

/// +x, -x, +y, -y, +z, -z: the axis along which a normal is longest.
uint32_t binOf(Vec3f n) {
  const float x = std::abs(n.x);
  const float y = std::abs(n.y);
  const float z = std::abs(n.z);
  if (x >= y && x >= z) return n.x < 0.0f ? 1 : 0;
  if (y >= z) return n.y < 0.0f ? 3 : 2;
  return n.z < 0.0f ? 5 : 4;
}

/// Two zero bits before each of 16 bits.
uint64_t spread(uint64_t bits) {
  bits = (bits | bits << 16) & 0x0000ff0000ffu;
  bits = (bits | bits << 8) & 0x00f00f00f00fu;
  bits = (bits | bits << 4) & 0x0c30c30c30c3u;
  return (bits | bits << 2) & 0x249249249249u;
}

}  // namespace

SpatialTree::SpatialTree(std::pmr::memory_resource* memory, Vec3f lower, Vec3f upper)
    : nodes_(memory), leaves_(memory), table_(memory) {
  const Vec3f size = upper - lower;
  // The cube is larger than the box and off its centre, lest walls in the middle of a scene or at
  // its border lie in a plane that halves cells, where rounding would tear them apart.
  const float extent = std::max(maxComponent(size), 1e-30f) * 1.1f;
  lower_ = lower - Vec3f{0.0371f, 0.0533f, 0.0419f} * extent;
  scale_ = static_cast<float>(1u << kBits) / extent;
  for (uint32_t bin = 0; bin < kBins; ++bin) {
    nodes_.push_back(kLeafFlag | bin);
    leaves_.push_back({bin, bin, 0, 0});
  }
  finish();
}

SpatialTree::SpatialTree(std::pmr::memory_resource* memory, const SpatialTree& other)
    : lower_(other.lower_),
      scale_(other.scale_),
      nodes_(other.nodes_, memory),
      leaves_(other.leaves_, memory),
      table_(other.table_, memory) {}

uint64_t SpatialTree::code(Vec3f point) const {
  const Vec3f p = (point - lower_) * scale_;
  const auto cell = [](float x) {
    constexpr auto kLast = static_cast<float>((1u << kBits) - 1);
    return static_cast<uint64_t>(x > 0.0f ? std::min(x, kLast) : 0.0f);  // NaN: 0
  };
  return spread(cell(p.x)) << 2 | spread(cell(p.y)) << 1 | spread(cell(p.z));
}

uint32_t SpatialTree::find(Vec3f point, Vec3f normal) const {
  const uint64_t bits = code(point);
  constexpr uint32_t kAll = 3 * kBits;
  const Start& start = table_[binOf(normal) << kTableDepth | bits >> (kAll - kTableDepth)];
  uint32_t word = start.word;
  uint32_t left = kAll - start.depth;  // bits not yet used
  while (!(word & kLeafFlag)) {
    --left;
    word = nodes_[word + (bits >> left & 1u)];
  }
  return (word & ~kLeafFlag) * kEighths + static_cast<uint32_t>(bits >> (left - 3) & 7u);
}

uint32_t SpatialTree::split(uint32_t leaf, uint32_t keeper) {
  const auto children = static_cast<uint32_t>(nodes_.size());
  const auto other = static_cast<uint32_t>(leaves_.size());
  const uint32_t depth = leaves_[leaf].depth + 1;
  nodes_.resize(nodes_.size() + 2);
  nodes_[children + keeper] = kLeafFlag | leaf;
  nodes_[children + 1 - keeper] = kLeafFlag | other;
  leaves_.push_back({children + 1 - keeper, leaf, depth, 1 - keeper});
  nodes_[leaves_[leaf].node] = children;
  leaves_[leaf].node = children + keeper;
  leaves_[leaf].depth = depth;
  return other;
}

void SpatialTree::finish() {
  table_.resize(std::size_t{kBins} << kTableDepth);
  for (uint32_t i = 0; i < table_.size(); ++i) {
    uint32_t word = nodes_[i >> kTableDepth];
    uint32_t depth = 0;
    for (; depth < kTableDepth && !(word & kLeafFlag); ++depth) {
      word = nodes_[word + (i >> (kTableDepth - 1 - depth) & 1u)];
    }
    table_[i] = {word, depth};
  }
}

std::size_t SpatialTree::bytes() const {
  // Of what is in use: the same whether the tree grew here or was loaded.
  return nodes_.size() * sizeof(uint32_t) + leaves_.size() * sizeof(Leaf) +
         table_.size() * sizeof(Start);
}

}  // namespace awd
