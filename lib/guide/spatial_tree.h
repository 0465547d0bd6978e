// SPDX-License-Identifier: Apache-2.0
// Where patches lie when the library makes them: the leaves of binary trees over a cube, one tree
// for each dominant direction of normals, so that finely tessellated surfaces share patches and
// large ones are split. Cells are halved along x, y and z in turn: the path to a leaf is the Morton
// code of any point in it.
#pragma once

#include <array>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "util/vec.h"

namespace awd {

class SpatialTree {
 public:
  /// Each leaf tells its eighths apart: the next three halvings.
  static constexpr uint32_t kEighths = 8;

  /// Over the box from lower to upper, finite and not inverted; points outside belong to the cells
  /// at its border.
  SpatialTree(std::pmr::memory_resource* memory, Vec3f lower, Vec3f upper);
  /// A copy in that memory.
  SpatialTree(std::pmr::memory_resource* memory, const SpatialTree& other);

  /// The leaf of a point of a surface with this normal, times kEighths, plus the eighth of the
  /// leaf that it lies in.
  uint32_t find(Vec3f point, Vec3f normal) const;

  /// Leaves of a tree that has not been split: one of each direction of normals.
  static constexpr uint32_t kBins = 6;

  uint32_t leaves() const { return static_cast<uint32_t>(leaves_.size()); }
  /// The leaf that this one was split from, or itself.
  uint32_t origin(uint32_t leaf) const { return leaves_[leaf].origin; }
  uint32_t depth(uint32_t leaf) const { return leaves_[leaf].depth; }
  /// Which half of its origin the leaf was when the split made it.
  uint32_t side(uint32_t leaf) const { return leaves_[leaf].side; }
  bool canSplit(uint32_t leaf) const {
    return leaves_[leaf].depth < kDeepest && leaves_.size() < kMostLeaves;
  }

  /// Halves a leaf. One half keeps its number, the first or the second; the other gets the next
  /// number, which is returned. Call finish() before the next find().
  uint32_t split(uint32_t leaf, uint32_t keeper);
  void finish();

  std::size_t bytes() const;

 private:
  static constexpr uint32_t kBits = 16;  ///< of a coordinate
  static constexpr uint32_t kDeepest = 3 * kBits - 3;
  // A word of a node: kLeafFlag | depth | number of a leaf, or the index of the first of two
  // children, which lie side by side.
  static constexpr uint32_t kLeafFlag = 0x80000000u;
  static constexpr uint32_t kDepthShift = 25;
  static constexpr uint32_t kDepthMask = 63;
  static constexpr uint32_t kMostLeaves = 1u << kDepthShift;
  static uint32_t leafWord(uint32_t leaf, uint32_t depth) {
    return kLeafFlag | depth << kDepthShift | leaf;
  }

  struct Leaf {
    uint32_t node;  ///< that holds its number
    uint32_t origin;
    uint32_t depth;
    uint32_t side;
  };

  uint64_t code(Vec3f point) const;
  void fillTable(uint32_t word, uint32_t first, uint32_t levels);

  Vec3f lower_;
  float scale_;
  std::pmr::vector<uint32_t> nodes_;  ///< the first are the roots
  std::pmr::vector<Leaf> leaves_;
  /// The first levels are looked up at once: for each root the words there. More levels if there
  /// are many leaves.
  std::pmr::vector<uint32_t> table_;
  uint32_t tableDepth_;
};

}  // namespace awd
