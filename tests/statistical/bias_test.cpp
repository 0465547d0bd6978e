// SPDX-License-Identifier: Apache-2.0
// No way of sampling changes the image in the mean. Each configuration is compared with a long
// cosine reference in 8 x 8 blocks of pixels and in the whole image, each channel.
//
// Null hypothesis: equal means in all blocks and in the image. The threshold shares a false-alarm
// rate of 0.5 % among all scores of all configurations (Bonferroni); bias_pairs_test.cpp has as
// much.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 32, kBlock = 8;
constexpr size_t kScores = 3 * ((kSize / kBlock) * (kSize / kBlock) + 1);
const std::vector<uint32_t> kPasses = {16, 32, 64, 144};

struct Config {
  const char* name;
  AWDGuide guide;
  AWDPreset preset = AWD_PRESET_DEFAULT;
  AWDDirectLight direct = AWD_DIRECT_DEFAULT;
  AWDRoulette roulette = AWD_ROULETTE_DEFAULT;
  uint32_t shadowRays = 0;
  AWDEstimator estimator = AWD_ESTIMATOR_DEFAULT;
  const char* basis = nullptr;
  AWDHemisphereMap map = AWD_MAP_DEFAULT;
  AWDPatches patches = AWD_PATCHES_DEFAULT;
  AWDCombination combination = AWD_COMBINE_DEFAULT;
  AWDPoints points = AWD_POINTS_DEFAULT;
};

constexpr Config randomPoints(const char* name, AWDGuide guide) {
  Config config = {name, guide};
  config.points = AWD_POINTS_RANDOM;
  return config;
}

/// Guided, with a field of its own kind.
constexpr Config fieldOf(const char* name, const char* basis, AWDHemisphereMap map,
                         AWDPatches patches = AWD_PATCHES_DEFAULT,
                         AWDCombination combination = AWD_COMBINE_DEFAULT) {
  Config config = {name, AWD_GUIDE_ADAPTIVE};
  config.basis = basis;
  config.map = map;
  config.patches = patches;
  config.combination = combination;
  return config;
}

const Config kConfigs[] = {
    {"adaptive", AWD_GUIDE_ADAPTIVE},
    {"adaptivePaper", AWD_GUIDE_ADAPTIVE, AWD_PRESET_PAPER},
    {"uniform", AWD_GUIDE_UNIFORM},
    {"uniformPaper", AWD_GUIDE_UNIFORM, AWD_PRESET_PAPER},
    {"cosine", AWD_GUIDE_COSINE},
    {"cosinePaper", AWD_GUIDE_COSINE, AWD_PRESET_PAPER},
    {"areaAlbedo", AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT, AWD_DIRECT_AREA, AWD_ROULETTE_ALBEDO},
    {"areaThroughput", AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT, AWD_DIRECT_AREA,
     AWD_ROULETTE_THROUGHPUT},
    {"weightedAlbedo", AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT, AWD_DIRECT_WEIGHTED,
     AWD_ROULETTE_ALBEDO},
    {"weightedThroughputOneShadowRay", AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT, AWD_DIRECT_WEIGHTED,
     AWD_ROULETTE_THROUGHPUT, 1},
    {"uniformWeightedAlbedo", AWD_GUIDE_UNIFORM, AWD_PRESET_DEFAULT, AWD_DIRECT_WEIGHTED,
     AWD_ROULETTE_ALBEDO},
    {"ratio", AWD_GUIDE_ADAPTIVE, AWD_PRESET_PAPER, AWD_DIRECT_DEFAULT, AWD_ROULETTE_DEFAULT, 0,
     AWD_ESTIMATOR_RATIO},
    fieldOf("spherical", "linear-bspline", AWD_MAP_SPHERICAL),
    fieldOf("cylindrical", "quadratic-bspline", AWD_MAP_CYLINDRICAL),
    fieldOf("cosineMap", "haar", AWD_MAP_COSINE),
    fieldOf("hostPatches", "m2", AWD_MAP_CONCENTRIC_COSINE, AWD_PATCHES_HOST),
    fieldOf("byCount", "linear-bspline", AWD_MAP_CONCENTRIC_COSINE, AWD_PATCHES_SPATIAL,
            AWD_COMBINE_COUNT),
    randomPoints("randomPoints", AWD_GUIDE_ADAPTIVE),
    randomPoints("cosineRandomPoints", AWD_GUIDE_COSINE),
    {"quasi", AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT, AWD_DIRECT_DEFAULT, AWD_ROULETTE_DEFAULT, 0,
     AWD_ESTIMATOR_QUASI},
#ifdef AWD_TEST_REFIT
    {"refit", AWD_GUIDE_ADAPTIVE, AWD_PRESET_DEFAULT, AWD_DIRECT_DEFAULT, AWD_ROULETTE_DEFAULT, 0,
     AWD_ESTIMATOR_REFIT},
#endif
};
constexpr size_t kComparisons = std::size(kConfigs) + 6;  // the lamps below: two scenes, 3 guides

void expectUnbiased(const Film& film, const Film& reference) {
  std::vector<double> scores = blockScores(film, reference, kBlock);
  for (const double whole : blockScores(film, reference, kSize)) scores.push_back(whole);
  ASSERT_EQ(scores.size(), kScores);
  const double limit = familyThreshold(0.005, kComparisons * kScores);
  const Estimate mean = imageMean(film, 1);
  std::printf("  largest |z| %.2f, limit %.2f; whole image: z %.2f, standard error %.2g %%\n",
              largest(scores), limit, zScore(mean, imageMean(reference, 1)),
              100.0 * mean.error / mean.mean);
  EXPECT_LT(largest(scores), limit);
}

TEST(Bias, NoConfigurationDiffersFromTheReferenceSlow) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  const Film reference = renderFilm(scene, renderDesc(view, AWD_GUIDE_COSINE, 1000), {1024});
  for (const Config& config : kConfigs) {
    SCOPED_TRACE(config.name);
    std::printf("  %s\n", config.name);
    AWDRenderDesc desc = renderDesc(view, config.guide, 2000);
    desc.preset = config.preset;
    desc.direct = config.direct;
    desc.roulette = config.roulette;
    desc.shadowRays = config.shadowRays;
    desc.combination = config.combination;
    desc.points = config.points;
    Field field;
    if (config.estimator != AWD_ESTIMATOR_DEFAULT || config.basis) {
      AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
      fieldDesc.preset = config.preset;
      fieldDesc.basis = config.basis ? config.basis : "linear-bspline";
      fieldDesc.estimator = config.estimator;
      fieldDesc.map = config.map;
      fieldDesc.patches = config.patches;
      for (float& x : fieldDesc.upper) x = 4.0f;
      field = newField(device, &fieldDesc);
    }
    const Render render = newRender(scene, desc, field);
    runPasses(render, kPasses);
    expectUnbiased(readFilm(render), reference);
  }
}

/// Thirteen lamps of unequal power and size, and a screen that hides some of them.
SceneBuilder manyLamps() {
  SceneBuilder room;
  room.box({0, 0, 0}, {4, 3, 4}, true, {room.material(grey(0.6))});
  for (uint32_t i = 0; i < 13; ++i) {
    const double size = i % 3 == 0 ? 0.5 : 0.125, x = 0.25 + 0.875 * (i % 4),
                 z = 0.25 + 0.875 * (i / 4);
    const uint32_t lamp = room.material(grey(0.2), grey(1.0 + 3.0 * (i % 5)));
    room.quad({x, 2.75, z}, {x + size, 2.75, z}, {x + size, 2.75, z + size}, {x, 2.75, z + size},
              lamp);
  }
  const uint32_t screen = room.material(grey(0.3));
  room.quad({1, 0, 2}, {3, 0, 2}, {3, 2.5, 2}, {1, 2.5, 2}, screen);
  return room;
}

class ManyLights : public testing::TestWithParam<AWDGuide> {};
INSTANTIATE_TEST_SUITE_P(Guides, ManyLights,
                         testing::Values(AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE, AWD_GUIDE_UNIFORM));

/// With 13 lights above maxLights = 8 the shadow rays choose by power; maxLights = 64 samples each.
TEST_P(ManyLights, ChoosingByPowerIsAsGoodInTheMeanSlow) {
  const Device device = newDevice();
  const Scene scene = manyLamps().commit(device);
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  ASSERT_EQ(info.lights, 13u);
  const AWDCamera view = lampRoomCamera(kSize);
  AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_COSINE, 3000);
  desc.maxLights = 64;
  desc.shadowRays = 1;
  const Film reference = renderFilm(scene, desc, {256});
  for (const AWDDirectLight direct : {AWD_DIRECT_AREA, AWD_DIRECT_WEIGHTED}) {
    desc = renderDesc(view, GetParam(), 4000);
    desc.direct = direct;
    expectUnbiased(renderFilm(scene, desc, kPasses), reference);
  }
}

}  // namespace
