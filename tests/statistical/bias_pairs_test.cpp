// SPDX-License-Identifier: Apache-2.0
// No combination of settings changes the image in the mean: every basis on every map of the
// hemisphere with either kind of patches, and every roulette with every way of finding light, of
// combining passes, of drawing points and of dividing samples.
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

TEST(BiasPairs, NoPairDiffersFromTheReferenceSlow) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  const Film reference = renderFilm(scene, renderDesc(view, AWD_GUIDE_COSINE, 5000), {1024});
  std::vector<Config> all = fields();
  for (Config& config : renders()) all.push_back(std::move(config));

  constexpr size_t kScores = 3 * ((kSize / kBlock) * (kSize / kBlock) + 1);
  const double limit = familyThreshold(0.005, all.size() * kScores);
  double worst = 0.0;
  uint64_t seed = 6000;
  for (Config& config : all) {
    SCOPED_TRACE(config.name);
    for (float& x : config.field.upper) x = 4.0f;
    config.render.camera = &view;
    config.render.seed = seed++;
    const Field field = newField(device, &config.field);
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

}  // namespace
