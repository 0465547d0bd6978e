// SPDX-License-Identifier: Apache-2.0
#include "render/embree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "density/levels.h"
#include "render/rooms.h"

namespace awd {
namespace {

std::pmr::vector<Vec3f> soup(int triangles, uint64_t seed) {
  Uniforms random(seed);
  const auto point = [&] { return Vec3f{float(random()), float(random()), float(random())}; };
  std::pmr::vector<Vec3f> corners;
  for (int i = 0; i < triangles; ++i) {
    const Vec3f p = point();
    corners.insert(corners.end(), {p, p + point() * 0.3f, p + point() * 0.3f});
  }
  return corners;
}

/// Moeller and Trumbore's test in double precision: t, or infinity.
double hitBruteForce(const Vec3f* corner, Vec3f origin, Vec3f direction) {
  const Vec3d a = convert<double>(corner[0]);
  const Vec3d e1 = convert<double>(corner[1]) - a, e2 = convert<double>(corner[2]) - a;
  const Vec3d d = convert<double>(direction), s = convert<double>(origin) - a;
  const Vec3d p = cross(d, e2), q = cross(s, e1);
  const double det = dot(e1, p);
  const double u = dot(s, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 ? t : std::numeric_limits<double>::infinity();
}

TEST(Embree, AgreesWithBruteForce) {
  const Ref<Device> owner = device();
  const auto corners = soup(200, 60);
  Progress progress(owner->context(), "commit", nullptr, 1);
  const Embree embree(owner->context(), corners, progress);
  Uniforms random(61);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3f o = {float(random()), float(random()), -1.0f};
    const Vec3f d = normalized(Vec3f{float(random()) - 0.5f, float(random()) - 0.5f, 1.0f});
    double nearest = kFar;
    for (uint32_t t = 0; t < 200; ++t) {
      nearest = std::min(nearest, hitBruteForce(&corners[3 * t], o, d));
    }
    RayHit hit;
    ASSERT_EQ(embree.intersect(o, d, 0.0f, kFar, hit), std::isfinite(nearest));
    EXPECT_EQ(embree.occluded(o, d, 0.0f, kFar), std::isfinite(nearest));
    if (!std::isfinite(nearest)) continue;
    ++hits;
    EXPECT_NEAR(hit.t, nearest, 1e-5);
    EXPECT_FALSE(embree.occluded(o, d, 0.0f, hit.t * 0.999f));
  }
  EXPECT_GT(hits, 500);
}

TEST(Embree, FindsTheNearestTriangle) {
  const Ref<Device> owner = device();
  const auto corners = soup(200, 62);
  Progress progress(owner->context(), "commit", nullptr, 1);
  const Embree embree(owner->context(), corners, progress);
  Uniforms random(63);
  for (int i = 0; i < 100; ++i) {
    const Vec3f p = {float(random()), float(random()), float(random())};
    // Brute force over a fine grid on each triangle.
    const auto distance = [&](uint32_t t) {
      float best = kFar;
      for (int a = 0; a <= 20; ++a) {
        for (int b = 0; a + b <= 20; ++b) {
          const Vec3f* c = &corners[3 * t];
          const Vec3f q = c[0] + (c[1] - c[0]) * (float(a) / 20) + (c[2] - c[0]) * (float(b) / 20);
          best = std::min(best, length(p - q));
        }
      }
      return best;
    };
    float best = kFar;
    for (uint32_t t = 0; t < 200; ++t) best = std::min(best, distance(t));
    EXPECT_LT(distance(embree.nearest(p)), best + 0.03f);
  }
}

TEST(Embree, AnEmptySceneIsEmpty) {
  const Ref<Device> owner = device();
  Progress progress(owner->context(), "commit", nullptr, 1);
  const Embree embree(owner->context(), {}, progress);
  RayHit hit;
  EXPECT_FALSE(embree.intersect({0, 0, 0}, {0, 0, 1}, 0.0f, kFar, hit));
  EXPECT_FALSE(embree.occluded({0, 0, 0}, {0, 0, 1}, 0.0f, kFar));
  EXPECT_EQ(embree.nearest({0, 0, 0}), 0xFFFFFFFFu);
}

}  // namespace
}  // namespace awd
