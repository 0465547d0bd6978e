// SPDX-License-Identifier: Apache-2.0
#include "guide/hemisphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "density/levels.h"

namespace awd {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr AWDHemisphereMap kMaps[] = {AWD_MAP_SPHERICAL, AWD_MAP_CONCENTRIC_COSINE};

Vec3f randomUnit(Uniforms& random) {
  const double z = 2.0 * random() - 1.0;
  const double phi = 2.0 * kPi * random();
  const double r = std::sqrt(1.0 - z * z);
  return {float(r * std::cos(phi)), float(r * std::sin(phi)), float(z)};
}

TEST(Frame, IsRightHandedAndOrthonormal) {
  Uniforms random(20);
  for (int i = 0; i < 1000; ++i) {
    const Vec3f axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Frame frame(i < 6 ? axes[i] : randomUnit(random));
    EXPECT_NEAR(length(frame.tangent), 1.0f, 1e-6f);
    EXPECT_NEAR(length(frame.bitangent), 1.0f, 1e-6f);
    EXPECT_NEAR(dot(frame.tangent, frame.normal), 0.0f, 1e-6f);
    EXPECT_NEAR(dot(cross(frame.tangent, frame.bitangent), frame.normal), 1.0f, 1e-6f);
    const Vec3f d = randomUnit(random);
    EXPECT_NEAR(length(frame.toWorld(frame.toLocal(d)) - d), 0.0f, 1e-6f);
  }
}

TEST(Hemisphere, RoundTrips) {
  Uniforms random(21);
  for (const AWDHemisphereMap map : kMaps) {
    for (int i = 0; i < 20000; ++i) {
      const auto u = static_cast<float>(0.001 + 0.998 * random());
      const auto v = static_cast<float>(0.001 + 0.998 * random());
      const MappedDirection mapped = mapToHemisphere(map, u, v);
      ASSERT_NEAR(length(mapped.direction), 1.0f, 1e-6f);
      ASSERT_GT(mapped.direction.z, 0.0f);
      float backU, backV;
      mapToSquare(map, mapped.direction, backU, backV);
      // Near the rim of the disk a float cosine says little about the radius; elsewhere 1e-5.
      ASSERT_NEAR(backU, u, 1e-4f) << "map " << map << " at " << u << ", " << v;
      ASSERT_NEAR(backV, v, 1e-4f) << "map " << map << " at " << u << ", " << v;
      ASSERT_NEAR(solidAngleAt(map, mapped.direction) / mapped.solidAngle, 1.0f, 1e-3f);
    }
  }
}

/// Solid angle of the image of a small square, from two triangles between its mapped corners.
TEST(Hemisphere, SolidAngleIsThatOfTheMapItself) {
  Uniforms random(22);
  constexpr double kStep = 1e-3;
  const auto direction = [](AWDHemisphereMap map, double u, double v) {
    return convert<double>(mapToHemisphere(map, float(u), float(v)).direction);
  };
  for (const AWDHemisphereMap map : kMaps) {
    for (int i = 0; i < 2000; ++i) {
      const double u = 0.05 + 0.9 * random();
      const double v = 0.05 + 0.9 * random();
      // The concentric map has a crease on the diagonals, where a square is cut in two.
      if (std::abs(std::abs(2 * u - 1) - std::abs(2 * v - 1)) < 0.01) continue;
      const Vec3d a = direction(map, u - kStep, v - kStep),
                  b = direction(map, u + kStep, v - kStep);
      const Vec3d c = direction(map, u + kStep, v + kStep),
                  d = direction(map, u - kStep, v + kStep);
      const double area = 0.5 * length(cross(c - a, d - b));
      const double expected = mapToHemisphere(map, float(u), float(v)).solidAngle;
      EXPECT_NEAR(area / (4 * kStep * kStep) / expected, 1.0, 5e-3)
          << "map " << map << " at " << u << ", " << v;
    }
  }
}

TEST(Hemisphere, EndsOfTheSquareAreSafe) {
  const float last = std::nextafter(1.0f, 0.0f);
  for (const AWDHemisphereMap map : kMaps) {
    for (const float u : {0.0f, 0.5f, last}) {
      for (const float v : {0.0f, 0.5f, last}) {
        const MappedDirection mapped = mapToHemisphere(map, u, v);
        EXPECT_TRUE(isFinite(mapped.direction));
        EXPECT_GT(mapped.direction.z, 0.0f);
        EXPECT_GT(mapped.solidAngle, 0.0f);
        EXPECT_TRUE(std::isfinite(mapped.solidAngle));
      }
    }
  }
}

TEST(Hemisphere, ConstantOnTheCosineMapIsTheCosine) {
  for (const double z : {0.1, 0.5, 0.9}) {
    const float r = static_cast<float>(std::sqrt(1 - z * z));
    const Vec3f d = {r * 0.6f, r * 0.8f, static_cast<float>(z)};
    EXPECT_NEAR(1.0 / solidAngleAt(AWD_MAP_CONCENTRIC_COSINE, d), z / kPi, 1e-6);
  }
}

}  // namespace
}  // namespace awd
