// SPDX-License-Identifier: Apache-2.0
// The furnace: in a closed box where every wall has albedo a and emits E = (1 - a) L, every
// radiance is L, whatever a is from wall to wall.
//
// Each case says how many samples it takes and what standard error they leave; that must be below
// a quarter of the tolerance, and the mean must agree with L within the tolerance and within 4
// standard errors (false alarm: 6e-5 a case if the film's error estimate is honest, which
// variance_test.cpp checks).
#include <gtest/gtest.h>

#include <cstdio>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 32;

/// Mean over all pixels and channels; channels of a grey scene are one estimate, not three.
Estimate measure(AWDScene scene, AWDGuide guide, AWDDirectLight direct,
                 const std::vector<uint32_t>& passes, AWDField field = nullptr) {
  const AWDCamera view = camera({0.4, 0.55, 0.35}, {0.9, 0.3, 0.8}, {0, 1, 0}, 0.8, kSize, kSize);
  AWDRenderDesc desc = renderDesc(view, guide, 7);
  desc.direct = direct;
  desc.shadowRays = 1;
  desc.maxLights = 8;  // each wall is a light
  const Render render = newRender(scene, desc, field);
  runPasses(render, passes);
  const Film film = readFilm(render);
  const Estimate result = imageMean(film, 1);
  std::printf("  %llu samples a pixel, %llu in all: mean %.6f, standard error %.6f\n",
              static_cast<unsigned long long>(film.samplesPerPixel),
              static_cast<unsigned long long>(film.samplesPerPixel * kSize * kSize), result.mean,
              result.error);
  return result;
}

Scene uniformBox(Device& device, double albedo, double emission) {
  SceneBuilder builder;
  builder.box({0, 0, 0}, {1, 1, 1}, true, {builder.material(grey(albedo), grey(emission))});
  return builder.commit(device);
}

void expectRadiance(Estimate found, double truth, double relative) {
  const double tolerance = relative * truth;
  EXPECT_LT(found.error, 0.25 * tolerance) << "too few samples to tell";
  EXPECT_NEAR(found.mean, truth, tolerance);
  EXPECT_NEAR(found.mean, truth, 4.0 * found.error);
}

class Furnace : public testing::TestWithParam<AWDGuide> {};
INSTANTIATE_TEST_SUITE_P(Guides, Furnace,
                         testing::Values(AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE, AWD_GUIDE_UNIFORM));

TEST_P(Furnace, HalfAlbedoGivesTwiceTheEmissionSlow) {
  Device device = newDevice();
  const Scene scene = uniformBox(device, 0.5, 1.0);
  const uint32_t last = GetParam() == AWD_GUIDE_UNIFORM ? 5500 : 3700;
  expectRadiance(measure(scene, GetParam(), AWD_DIRECT_DEFAULT, {200, 400, last}), 2.0, 1e-3);
}

/// Shadow rays alone have infinite variance where walls meet: the figure is recorded, not judged
/// beyond what no furnace may give.
TEST_P(Furnace, PlainAreaSamplingIsRecordedSlow) {
  Device device = newDevice();
  const Scene scene = uniformBox(device, 0.5, 1.0);
  const Estimate found = measure(scene, GetParam(), AWD_DIRECT_AREA, {50, 100, 250});
  RecordProperty("radiance_of_2_by_area", std::to_string(found.mean));
  EXPECT_NEAR(found.mean, 2.0, 0.2);
}

class BrightFurnace : public Furnace {};
INSTANTIATE_TEST_SUITE_P(Guides, BrightFurnace,
                         testing::Values(AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE));

TEST_P(BrightFurnace, HighAlbedoIsWithinHalfAPercentSlow) {
  Device device = newDevice();
  const Scene scene = uniformBox(device, 0.9, 0.1);
  expectRadiance(measure(scene, GetParam(), AWD_DIRECT_DEFAULT, {50, 100, 350}), 1.0, 5e-3);
}

#ifdef AWD_TEST_REFIT
TEST(RefitFurnace, HalfAlbedoIsWithinHalfAPercentSlow) {
  Device device = newDevice();
  const Scene scene = uniformBox(device, 0.5, 1.0);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "linear-bspline";
  desc.estimator = AWD_ESTIMATOR_REFIT;
  const Field field = newField(device, &desc);
  const std::vector<uint32_t> passes = {50, 100, 200};
  expectRadiance(measure(scene, AWD_GUIDE_ADAPTIVE, AWD_DIRECT_DEFAULT, passes, field), 2.0, 5e-3);
}
#endif

/// 24 panels of four albedos with the emission that keeps L = 2: more lights than maxLights, so
/// that shadow rays choose among them by power.
TEST_P(Furnace, ManyLightsOfUnequalPowerSlow) {
  SceneBuilder builder;
  std::vector<uint32_t> materials;
  for (const double albedo : {0.5, 0.2, 0.8, 0.65}) {
    materials.push_back(builder.material(grey(albedo), grey(2.0 * (1.0 - albedo))));
  }
  builder.box({0, 0, 0}, {1, 1, 1}, true, materials, 2);
  Device device = newDevice();
  const Scene scene = builder.commit(device);
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  ASSERT_EQ(info.lights, 24u);
  expectRadiance(measure(scene, GetParam(), AWD_DIRECT_DEFAULT, {100, 200, 700}), 2.0, 4e-3);
}

}  // namespace
