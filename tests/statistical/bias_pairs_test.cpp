// SPDX-License-Identifier: Apache-2.0
// No combination of settings changes the image in the mean: every basis on every map of the
// hemisphere with either kind of patches, and every roulette with every way of finding light, of
// combining passes, of drawing points and of dividing samples; and where there are several lights,
// every way of choosing among them with and without splitting.
//
// Null hypothesis: equal means in all blocks of 16 x 16 pixels and in the image, each channel, of a
// long cosine reference and of each configuration. The threshold shares a false-alarm rate of 0.5 %
// among all scores (Bonferroni). In smaller blocks the rare bright paths of the worst pairs, m3 on
// a polar map, make sums of 4,096 samples that are not normal enough: their z reached 5.06, while
// the mean of 40 images was off by 0.2 (1) %.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 32, kBlock = 16;
const char* const kBases[] = {"haar", "linear-bspline", "quadratic-bspline", "f2", "m2", "m3"};
const AWDHemisphereMap kMaps[] = {AWD_MAP_SPHERICAL, AWD_MAP_CYLINDRICAL, AWD_MAP_COSINE,
                                  AWD_MAP_CONCENTRIC_COSINE};
const std::vector<uint32_t> kSchedules[] = {{1, 1, 2, 4, 8, 16, 32}, {64}, {32, 32}};

struct Config {
  std::string name;
  AWDFieldDesc field = AWD_FIELD_DESC_INIT;
  AWDRenderDesc render = AWD_RENDER_DESC_INIT;
  std::vector<uint32_t> passes = kSchedules[0];
};

std::vector<Config> fields() {
  std::vector<Config> all;
  for (const char* basis : kBases) {
    for (const AWDHemisphereMap map : kMaps) {
      for (const AWDPatches patches : {AWD_PATCHES_HOST, AWD_PATCHES_SPATIAL}) {
        Config& config = all.emplace_back();
        config.name = std::string(basis) + ", map " + std::to_string(map) + ", patches " +
                      std::to_string(patches);
        config.field.basis = basis;
        config.field.map = map;
        config.field.patches = patches;
        config.field.patchSamples = 500;
      }
    }
  }
  return all;
}

/// With every estimator that learns from all samples, the other target.
std::vector<Config> targets() {
  std::vector<Config> all;
  for (const AWDEstimator estimator : {AWD_ESTIMATOR_LUMPED, AWD_ESTIMATOR_QUASI}) {
    for (const char* basis : kBases) {
      Config& config = all.emplace_back();
      config.name =
          std::string(basis) + ", root mean square, estimator " + std::to_string(estimator);
      config.field.basis = basis;
      config.field.estimator = estimator;
      config.field.target = AWD_TARGET_RMS;
    }
  }
  return all;
}

std::vector<Config> renders() {
  std::vector<Config> all;
  for (const AWDRoulette roulette :
       {AWD_ROULETTE_ALBEDO, AWD_ROULETTE_THROUGHPUT, AWD_ROULETTE_ADJOINT}) {
    for (const AWDDirectLight direct : {AWD_DIRECT_AREA, AWD_DIRECT_WEIGHTED}) {
      for (const AWDCombination combination : {AWD_COMBINE_COUNT, AWD_COMBINE_EXPERIENCE}) {
        for (const AWDPoints points : {AWD_POINTS_RANDOM, AWD_POINTS_SOBOL}) {
          for (const std::vector<uint32_t>& passes : kSchedules) {
            Config& config = all.emplace_back();
            config.name = "roulette " + std::to_string(roulette) + ", direct " +
                          std::to_string(direct) + ", combination " + std::to_string(combination) +
                          ", points " + std::to_string(points) + ", " +
                          std::to_string(passes.size()) + " passes";
            config.render.roulette = roulette;
            config.render.direct = direct;
            config.render.combination = combination;
            config.render.points = points;
            config.passes = passes;
          }
        }
      }
    }
  }
  return all;
}

std::vector<Config> lights() {
  std::vector<Config> all;
  for (const AWDLightChoice lights : {AWD_LIGHTS_POWER, AWD_LIGHTS_LEARNED}) {
    for (const uint32_t split : {1u, 2u, 8u, 64u}) {
      for (const uint32_t shadowRays : {1u, 3u}) {
        for (const std::vector<uint32_t>& passes : kSchedules) {
          Config& config = all.emplace_back();
          config.name = "lights " + std::to_string(lights) + ", split " + std::to_string(split) +
                        ", " + std::to_string(shadowRays) + " shadow rays, " +
                        std::to_string(passes.size()) + " passes";
          config.render.lights = lights;
          config.render.maxSplit = split;
          config.render.shadowRays = shadowRays;
          config.passes = passes;
        }
      }
    }
  }
  return all;
}

/// Half of the false alarms are for each of the two rooms.
void compareAll(const SceneBuilder& room, std::vector<Config> all, uint64_t seed) {
  const Device device = newDevice();
  const Scene scene = room.commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  const Film reference = renderFilm(scene, renderDesc(view, AWD_GUIDE_COSINE, 5000), {1024});

  constexpr size_t kScores = 3 * ((kSize / kBlock) * (kSize / kBlock) + 1);
  const double limit = familyThreshold(0.0025, all.size() * kScores);
  double worst = 0.0;
  for (Config& config : all) {
    SCOPED_TRACE(config.name);
    config.render.camera = &view;
    config.render.seed = seed++;
    Field field;
    must(awdNewSceneField(scene, &config.field, field.out()));
    const Render render = newRender(scene, config.render, field);
    runPasses(render, config.passes);
    const Film film = readFilm(render);
    std::vector<double> scores = blockScores(film, reference, kBlock);
    for (const double whole : blockScores(film, reference, kSize)) scores.push_back(whole);
    ASSERT_EQ(scores.size(), kScores);
    EXPECT_LT(largest(scores), limit);
    worst = std::max(worst, largest(scores));
  }
  std::printf("  %zu configurations; largest |z| %.2f, limit %.2f\n", all.size(), worst, limit);
}

TEST(BiasPairs, NoPairDiffersFromTheReferenceSlow) {
  std::vector<Config> all = fields();
  for (Config& config : targets()) all.push_back(std::move(config));
  for (Config& config : renders()) all.push_back(std::move(config));
  compareAll(lampRoom(), std::move(all), 6000);
}

TEST(BiasPairs, NoChoiceOfLightsDiffersFromTheReferenceSlow) {
  compareAll(sevenLampRoom(), lights(), 7000);
}

}  // namespace
