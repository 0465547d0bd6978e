// SPDX-License-Identifier: Apache-2.0
#include "render/pieces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace awd {
namespace {

std::pmr::memory_resource* memory() { return std::pmr::get_default_resource(); }

struct Surface {
  std::pmr::vector<Vec3f> corners, normals;
  std::pmr::vector<uint32_t> labels;

  void add(Vec3f a, Vec3f b, Vec3f c, uint32_t label = 0) {
    for (const Vec3f p : {a, b, c}) corners.push_back(p);
    normals.push_back(normalized(cross(b - a, c - a)));
    labels.push_back(label);
  }
  Pieces pieces() const {
    return planarPieces(memory(), corners, normals, TriangleAdjacency(memory(), corners), labels);
  }
};

constexpr Vec3f kA = {0, 0, 0}, kB = {1, 0, 0}, kC = {1, 1, 0}, kD = {0, 1, 0};

TEST(Pieces, TwoHalvesOfAQuadAreOne) {
  Surface s;
  s.add(kA, kB, kC);
  s.add(kA, kC, kD);
  EXPECT_EQ(s.pieces().count, 1u);
}

TEST(Pieces, OppositeFacingHalvesAreTwo) {
  Surface s;
  s.add(kA, kB, kC);
  s.add(kA, kD, kC);
  EXPECT_EQ(s.pieces().count, 2u);
}

TEST(Pieces, ACornerAloneDoesNotJoin) {
  Surface s;
  s.add(kA, kB, kC);
  s.add(kC, {2, 1, 0}, {2, 2, 0});
  EXPECT_EQ(s.pieces().count, 2u);
}

TEST(Pieces, LabelsKeepApartAndLeaveOut) {
  Surface s;
  s.add(kA, kB, kC, 1);
  s.add(kA, kC, kD, 2);
  EXPECT_EQ(s.pieces().count, 2u);
  s.labels[1] = kNoPiece;
  EXPECT_EQ(s.pieces().count, 1u);
  EXPECT_EQ(s.pieces().ofTriangle[1], kNoPiece);
}

TEST(Pieces, ACylinderIsNotFlattenedStepByStep) {
  // Neighbouring strips differ by less than the tolerance; a chain of them must still break.
  Surface s;
  constexpr int kStrips = 20000;
  for (int i = 0; i < kStrips; ++i) {
    const auto at = [](int k, float z) {
      const double angle = 6.283185307179586 * k / kStrips;
      return Vec3f{float(std::cos(angle)), float(std::sin(angle)), z};
    };
    s.add(at(i, 0), at(i + 1, 0), at(i + 1, 1));
    s.add(at(i, 0), at(i + 1, 1), at(i, 1));
  }
  EXPECT_GT(s.pieces().count, 1000u);
}

TEST(Pieces, ThreeTrianglesMayShareAnEdge) {
  Surface s;
  s.add(kA, kB, kC);
  s.add(kA, kB, {1, 0, 1});
  s.add(kB, kA, {0.5f, -1, 0});
  const Pieces pieces = s.pieces();
  EXPECT_EQ(pieces.count, 2u);
  EXPECT_EQ(pieces.ofTriangle[0], pieces.ofTriangle[2]);
}

}  // namespace
}  // namespace awd
