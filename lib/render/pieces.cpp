// SPDX-License-Identifier: Apache-2.0
#include "render/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace awd {

namespace {

constexpr float kLeastCosine = 1.0f - 5e-7f;
constexpr float kMostDistance = 1e-5f;

/// A number for each corner, equal for equal positions.
std::pmr::vector<uint32_t> weld(std::pmr::memory_resource* memory,
                                const std::pmr::vector<Vec3f>& corners) {
  std::pmr::vector<uint32_t> order(corners.size(), memory);
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](uint32_t i) {
    return std::make_tuple(corners[i].x, corners[i].y, corners[i].z);
  };
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return key(a) < key(b); });
  std::pmr::vector<uint32_t> welded(corners.size(), memory);
  uint32_t number = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0 && key(order[i - 1]) != key(order[i])) ++number;
    welded[order[i]] = number;
  }
  return welded;
}

}  // namespace

TriangleAdjacency::TriangleAdjacency(std::pmr::memory_resource* memory,
                                     const std::pmr::vector<Vec3f>& corners)
    : first_(corners.size() / 3 + 1, 0, memory), neighbours_(memory) {
  const std::pmr::vector<uint32_t> welded = weld(memory, corners);
  struct Edge {
    uint32_t a, b, triangle;
    bool operator<(const Edge& e) const {
      return std::tie(a, b, triangle) < std::tie(e.a, e.b, e.triangle);
    }
    bool sameEnds(const Edge& e) const { return a == e.a && b == e.b; }
  };
  std::pmr::vector<Edge> edges(corners.size(), memory);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    edges[i] = {std::min(welded[i], welded[next]), std::max(welded[i], welded[next]),
                static_cast<uint32_t>(i / 3)};
  }
  std::sort(edges.begin(), edges.end());

  // Triangles about one edge are linked in a ring, which joins them all and stays linear in size
  // however many there are.
  const auto forEachLink = [&](auto&& link) {
    for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
      for (end = begin + 1; end < edges.size() && edges[end].sameEnds(edges[begin]);) ++end;
      for (std::size_t i = begin; i + 1 < end; ++i) link(edges[i].triangle, edges[i + 1].triangle);
      if (end - begin > 2) link(edges[end - 1].triangle, edges[begin].triangle);
    }
  };
  forEachLink([&](uint32_t a, uint32_t b) {
    ++first_[a + 1];
    ++first_[b + 1];
  });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  neighbours_.resize(first_.back());
  std::pmr::vector<std::size_t> fill(first_.begin(), first_.end() - 1, memory);
  forEachLink([&](uint32_t a, uint32_t b) {
    neighbours_[fill[a]++] = b;
    neighbours_[fill[b]++] = a;
  });
}

Pieces planarPieces(std::pmr::memory_resource* memory, const std::pmr::vector<Vec3f>& corners,
                    const std::pmr::vector<Vec3f>& normals, const TriangleAdjacency& adjacency,
                    const std::pmr::vector<uint32_t>& labels) {
  Pieces pieces = {std::pmr::vector<uint32_t>(normals.size(), kNoPiece, memory), 0};
  std::pmr::vector<uint32_t> frontier(memory);
  for (uint32_t seed = 0; seed < normals.size(); ++seed) {
    if (labels[seed] == kNoPiece || pieces.ofTriangle[seed] != kNoPiece) continue;
    const Vec3f normal = normals[seed];
    const Vec3f origin = corners[3 * std::size_t{seed}];
    const auto belongs = [&](uint32_t triangle) {
      if (labels[triangle] != labels[seed] || pieces.ofTriangle[triangle] != kNoPiece) return false;
      if (dot(normals[triangle], normal) < kLeastCosine) return false;
      const Vec3f* corner = &corners[3 * std::size_t{triangle}];
      return std::all_of(corner, corner + 3, [&](Vec3f p) {
        return std::abs(dot(p - origin, normal)) <= kMostDistance;
      });
    };
    pieces.ofTriangle[seed] = pieces.count;
    frontier.assign(1, seed);
    while (!frontier.empty()) {
      const uint32_t triangle = frontier.back();
      frontier.pop_back();
      for (const uint32_t* n = adjacency.begin(triangle); n != adjacency.end(triangle); ++n) {
        if (!belongs(*n)) continue;
        pieces.ofTriangle[*n] = pieces.count;
        frontier.push_back(*n);
      }
    }
    ++pieces.count;
  }
  return pieces;
}

}  // namespace awd
