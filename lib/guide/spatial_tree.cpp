// SPDX-License-Identifier: Apache-2.0
#include "guide/spatial_tree.h"

#include <algorithm>
#include <cmath>

namespace awd {

namespace {

/// Leaves from which on the table has its full depth: about as many as it has cells that a surface
/// goes through.
constexpr uint32_t kManyLeaves = 256;
constexpr uint32_t kFewLevels = 6;
constexpr uint32_t kManyLevels = 12;

/// +x, -x, +y, -y, +z, -z: the axis along which a normal is longest. Without branches, which
/// would be hard to foretell.
uint32_t binOf(Vec3f n) {
  const float x = std::abs(n.x);
  const float y = std::abs(n.y);
  const float z = std::abs(n.z);
  const uint32_t alongX = (x >= y) & (x >= z);
  const uint32_t alongY = (alongX ^ 1u) & (y >= z);
  const uint32_t alongZ = alongX ^ alongY ^ 1u;
  const uint32_t negative =
      (alongX & (n.x < 0.0f)) | (alongY & (n.y < 0.0f)) | (alongZ & (n.z < 0.0f));
  return 2 * alongY + 4 * alongZ + negative;
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
    nodes_.push_back(leafWord(bin, 0));
    leaves_.push_back({bin, bin, 0, 0});
  }
  finish();
}

SpatialTree::SpatialTree(std::pmr::memory_resource* memory, const SpatialTree& other)
    : lower_(other.lower_),
      scale_(other.scale_),
      nodes_(other.nodes_, memory),
      leaves_(other.leaves_, memory),
      table_(other.table_, memory),
      tableDepth_(other.tableDepth_) {}

inline uint64_t SpatialTree::code(Vec3f point) const {
  const Vec3f p = (point - lower_) * scale_;
  const auto cell = [](float x) {
    constexpr auto kLast = static_cast<float>((1u << kBits) - 1);
    return static_cast<uint64_t>(static_cast<int32_t>(std::min(std::max(0.0f, x), kLast)));
  };  // NaN: 0
  return spread(cell(p.x)) << 2 | spread(cell(p.y)) << 1 | spread(cell(p.z));
}

uint32_t SpatialTree::find(Vec3f point, Vec3f normal) const {
  const uint64_t bits = code(point);
  constexpr uint32_t kAll = 3 * kBits;
  uint32_t left = kAll - tableDepth_;  // bits not yet used
  uint32_t word = table_[binOf(normal) << tableDepth_ | bits >> left];
  while (!(word & kLeafFlag)) {
    --left;
    word = nodes_[word + (bits >> left & 1u)];
  }
  const uint32_t depth = word >> kDepthShift & kDepthMask;
  return (word & (kMostLeaves - 1)) * kEighths +
         static_cast<uint32_t>(bits >> (kAll - 3 - depth) & 7u);
}

uint32_t SpatialTree::split(uint32_t leaf, uint32_t keeper) {
  const auto children = static_cast<uint32_t>(nodes_.size());
  const auto other = static_cast<uint32_t>(leaves_.size());
  const uint32_t depth = leaves_[leaf].depth + 1;
  nodes_.resize(nodes_.size() + 2);
  nodes_[children + keeper] = leafWord(leaf, depth);
  nodes_[children + 1 - keeper] = leafWord(other, depth);
  leaves_.push_back({children + 1 - keeper, leaf, depth, 1 - keeper});
  nodes_[leaves_[leaf].node] = children;
  leaves_[leaf].node = children + keeper;
  leaves_[leaf].depth = depth;
  return other;
}

void SpatialTree::fillTable(uint32_t word, uint32_t first, uint32_t levels) {
  if (levels == 0 || word & kLeafFlag) {
    std::fill_n(table_.begin() + first, std::size_t{1} << levels, word);
    return;
  }
  fillTable(nodes_[word], first, levels - 1);
  fillTable(nodes_[word + 1], first + (1u << (levels - 1)), levels - 1);
}

void SpatialTree::finish() {
  tableDepth_ = leaves() < kManyLeaves ? kFewLevels : kManyLevels;
  table_.resize(std::size_t{kBins} << tableDepth_);
  for (uint32_t bin = 0; bin < kBins; ++bin) {
    fillTable(nodes_[bin], bin << tableDepth_, tableDepth_);
  }
}

std::size_t SpatialTree::bytes() const {
  // Of what is in use: the same whether the tree grew here or was loaded.
  return nodes_.size() * sizeof(uint32_t) + leaves_.size() * sizeof(Leaf) +
         table_.size() * sizeof(uint32_t);
}

}  // namespace awd
