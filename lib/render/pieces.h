// SPDX-License-Identifier: Apache-2.0
// Planar pieces of a mesh: coplanar triangles that hang together by whole edges and face the same
// way. They are what patches and lights are made of.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "util/vec.h"

namespace awd {

constexpr uint32_t kNoPiece = 0xFFFFFFFFu;

struct Pieces {
  /// Piece of each triangle, or kNoPiece; numbered in the order of their first triangles.
  std::pmr::vector<uint32_t> ofTriangle;
  uint32_t count;
};

/// Which triangles share an edge, by position: vertices of the same coordinates are one.
class TriangleAdjacency {
 public:
  /// `vertices` are the three corners of each triangle in turn.
  TriangleAdjacency(std::pmr::memory_resource* memory, const std::pmr::vector<Vec3f>& corners);

  const uint32_t* begin(uint32_t triangle) const { return neighbours_.data() + first_[triangle]; }
  const uint32_t* end(uint32_t triangle) const { return neighbours_.data() + first_[triangle + 1]; }

 private:
  std::pmr::vector<std::size_t> first_;
  std::pmr::vector<uint32_t> neighbours_;
};

/// Pieces of the triangles whose label is not kNoPiece; only triangles of equal labels are joined.
/// A triangle belongs to the plane of its piece's first one if its normal is within about 1/20
/// degree and its corners within 1e-5 of it; coordinates are expected within [-1,1].
Pieces planarPieces(std::pmr::memory_resource* memory, const std::pmr::vector<Vec3f>& corners,
                    const std::pmr::vector<Vec3f>& normals, const TriangleAdjacency& adjacency,
                    const std::pmr::vector<uint32_t>& labels);

}  // namespace awd
