// SPDX-License-Identifier: Apache-2.0
// Direct light of an unoccluded polygon against Lambert's closed form: irradiance
//   E = L/2 sum_i gamma_i n . (v_i x v_{i+1}) / |v_i x v_{i+1}|
// over the edges as seen from the point, gamma_i the angle that an edge subtends; polygons that
// reach below the receiver's horizon are clipped at it. The receiver reflects a E / pi.
//
// The camera sees a spot of 1e-4 of the distance. Each case takes the samples that bring the
// standard error below a quarter of the tolerance of 0.1 %, and must also agree within 4 standard
// errors (false alarm 6e-5 a case).
#include <gtest/gtest.h>

#include <cstdio>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr double kPi = 3.14159265358979323846;
constexpr double kAlbedo = 0.6, kRadiance = 5.0;

/// The part of a polygon above the plane z = 0.
std::vector<Vec3> aboveHorizon(const std::vector<Vec3>& polygon) {
  std::vector<Vec3> result;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a.z >= 0.0) result.push_back(a);
    if ((a.z < 0.0) != (b.z < 0.0)) result.push_back(a + (a.z / (a.z - b.z)) * (b - a));
  }
  return result;
}

/// Irradiance at the origin on the plane z = 0 from above, by light of radiance 1.
double lambert(const std::vector<Vec3>& light) {
  const std::vector<Vec3> polygon = aboveHorizon(light);
  double sum = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = normalise(polygon[i]), b = normalise(polygon[(i + 1) % polygon.size()]);
    const Vec3 edge = cross(a, b);
    if (length(edge) > 0.0) {
      sum += std::atan2(length(edge), dot(a, b)) * edge.z / length(edge);
    }
  }
  return 0.5 * std::fabs(sum);
}

TEST(Lambert, ClosedFormOfASquareAboveItsMiddle) {
  // Four times the corner configuration of two parallel squares, a/c = 1 (any textbook on heat).
  const double corner = 2.0 / std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) / (2.0 * kPi);
  EXPECT_NEAR(lambert({{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}), 4.0 * corner * kPi, 1e-12);
}

struct Case {
  const char* name;
  std::vector<Vec3> light;  // in either sense of rotation
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

const Case kCases[] = {
    {"squareAbove", {{-0.25, -0.25, 1}, {-0.25, 0.25, 1}, {0.25, 0.25, 1}, {0.25, -0.25, 1}}},
    {"triangleAbove", {{-0.5, -0.25, 1.5}, {0.125, 0.5, 1.5}, {0.5, -0.125, 1.5}}},
    {"tiltedQuad", {{0.5, -0.5, 1}, {0.5, 0.5, 1}, {1, 0.5, 1.25}, {1, -0.5, 1.25}}},
    {"tiltedTriangle", {{-0.5, 0.5, 1}, {0.25, 1, 1.25}, {0, 0.75, 0.5}}},
    {"grazing", {{2, -0.5, 0.0625}, {2, 0.5, 0.0625}, {2, 0.5, 0.375}, {2, -0.5, 0.375}}},
    {"partlyBelowHorizon", {{2, -0.5, -0.25}, {2, 0.5, -0.25}, {2, 0.5, 0.5}, {2, -0.5, 0.5}}},
    {"pentagonOfThreeTriangles",
     {{-0.5, -0.5, 2}, {-0.75, 0.25, 2}, {0, 0.75, 2}, {0.75, 0.25, 2}, {0.5, -0.5, 2}}},
};

/// One light of connected triangles that shows the receiver at the origin its front or its back,
/// in black surroundings.
Scene receiverAnd(Device& device, const std::vector<Vec3>& light, bool back) {
  const Vec3 normal = cross(light[1] - light[0], light[2] - light[0]);
  const bool reversed = (dot(normal, light[0]) > 0.0) != back;
  SceneBuilder builder;
  const uint32_t receiver = builder.material(grey(kAlbedo)),
                 lamp = builder.material(grey(0.0), grey(kRadiance));
  builder.quad({-0.25, -0.25, 0}, {0.25, -0.25, 0}, {0.25, 0.25, 0}, {-0.25, 0.25, 0}, receiver);
  for (size_t i = 1; i + 1 < light.size(); ++i) {
    builder.triangle(light[0], light[reversed ? i + 1 : i], light[reversed ? i : i + 1], lamp);
  }
  return builder.commit(device);
}

/// The rare indirect ray that meets the light makes most of the noise of the weighted estimate:
/// there many samples help, shadow rays don't.
Estimate measure(AWDScene scene, AWDDirectLight direct, uint32_t samples) {
  // From beside all the lights.
  const AWDCamera view = camera({-1, -0.5, 0.75}, {0, 0, 0}, {0, 0, 1}, 1e-4, 4, 4);
  AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_COSINE, 11);
  desc.direct = direct;
  desc.shadowRays = direct == AWD_DIRECT_AREA ? 16 : 4;
  return imageMean(renderFilm(scene, desc, {samples}), 1);
}

class LambertCase : public testing::TestWithParam<std::tuple<Case, AWDDirectLight>> {};
INSTANTIATE_TEST_SUITE_P(Lights, LambertCase,
                         testing::Combine(testing::ValuesIn(kCases),
                                          testing::Values(AWD_DIRECT_AREA, AWD_DIRECT_WEIGHTED)));

TEST_P(LambertCase, AgreesWithinATenthOfAPercentSlow) {
  const auto& [c, direct] = GetParam();
  Device device = newDevice();
  const Scene scene = receiverAnd(device, c.light, false);
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  EXPECT_EQ(info.lights, 1u);

  const uint32_t samples = direct == AWD_DIRECT_AREA ? 16384 : 196608;
  const Estimate found = measure(scene, direct, samples);
  const double truth = kAlbedo / kPi * kRadiance * lambert(c.light);
  std::printf("  %s: 16 x %u samples: %.6f, truth %.6f, standard error %.2g of it\n", c.name,
              samples, found.mean, truth, found.error / truth);
  EXPECT_LT(found.error, 0.25e-3 * truth) << "too few samples to tell";
  EXPECT_NEAR(found.mean, truth, 1e-3 * truth);
  EXPECT_NEAR(found.mean, truth, 4.0 * found.error);
}

TEST_P(LambertCase, TheBackOfALightIsBlack) {
  const auto& [c, direct] = GetParam();
  Device device = newDevice();
  const Scene scene = receiverAnd(device, c.light, true);
  EXPECT_EQ(measure(scene, direct, 64).mean, 0.0);
}

}  // namespace
