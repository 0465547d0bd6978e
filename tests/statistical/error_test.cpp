// SPDX-License-Identifier: Apache-2.0
// What a film says of its own error is true as often as it claims.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <vector>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 24;
constexpr uint64_t kRenders = 100;

class Error : public testing::TestWithParam<AWDGuide> {};
INSTANTIATE_TEST_SUITE_P(Guides, Error, testing::Values(AWD_GUIDE_ADAPTIVE, AWD_GUIDE_COSINE));

// Null hypothesis: the true error lies in each render's interval with probability 0.95 or more. Of
// 100 renders 84 or more then do, but for 2e-5. The truth is the mean of all renders, which takes
// from each error a two-hundredth.
TEST_P(Error, LiesInItsIntervalAsOftenAsThatClaimsSlow) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  std::vector<std::vector<float>> images;
  std::vector<AWDRenderError> said;
  std::vector<double> truth(3 * kSize * kSize, 0.0);
  for (uint64_t seed = 0; seed < kRenders; ++seed) {
    const Render render = newRender(scene, renderDesc(view, GetParam(), 3000 + seed));
    AWDSchedule schedule = AWD_SCHEDULE_INIT;
    schedule.totalSamples = 17;
    must(awdRenderPasses(render, &schedule));
    AWDRenderError error = AWD_RENDER_ERROR_INIT;
    must(awdGetRenderError(render, &error));
    said.push_back(error);
    images.emplace_back(truth.size());
    must(awdReadFilm(render, AWD_FILM_RADIANCE, images.back().data(), 0, 0));
    for (size_t i = 0; i < truth.size(); ++i) {
      truth[i] += static_cast<double>(images.back()[i]) / kRenders;
    }
  }
  double brightness = 0.0;
  for (const double x : truth) brightness += x / static_cast<double>(truth.size());
  int inside = 0;
  double ratio = 0.0;
  for (size_t r = 0; r < images.size(); ++r) {
    double squared = 0.0;
    for (size_t i = 0; i < truth.size(); ++i) {
      squared += std::pow(static_cast<double>(images[r][i]) - truth[i], 2);
    }
    const double error = std::sqrt(squared / static_cast<double>(truth.size())) / brightness;
    inside += error >= said[r].lower && error <= said[r].upper;
    ratio += said[r].error / error / kRenders;
    EXPECT_LT(said[r].upper, 2.0 * said[r].error) << "an interval that says nothing";
  }
  std::printf("  %d of %d in the interval; said / true %.3f\n", inside, int(kRenders), ratio);
  EXPECT_GE(inside, 84);
  EXPECT_NEAR(ratio, 1.0, 0.05);
}

TEST_P(Error, IsABudgetSlow) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  const AWDRenderDesc desc = renderDesc(view, GetParam(), 4000);
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  uint64_t before = 0;
  for (const double target : {0.1, 0.05, 0.03}) {
    schedule.error = target;
    const Render render = newRender(scene, desc);
    must(awdRenderPasses(render, &schedule));
    AWDRenderError error = AWD_RENDER_ERROR_INIT;
    must(awdGetRenderError(render, &error));
    EXPECT_LE(error.upper, target);
    EXPECT_GT(error.upper, 0.5 * target) << "far more samples than it took";
    uint64_t samples = 0;
    must(awdGetFilmInfo(render, nullptr, nullptr, &samples));
    EXPECT_GT(samples, before);
    before = samples;
  }
  const auto samplesOf = [&] {
    const Render render = newRender(scene, desc);
    must(awdRenderPasses(render, &schedule));
    uint64_t samples = 0;
    must(awdGetFilmInfo(render, nullptr, nullptr, &samples));
    return samples;
  };
  schedule.totalSamples = 4;
  EXPECT_EQ(samplesOf(), 4u) << "the other limit holds too";
  schedule = AWD_SCHEDULE_INIT;
  schedule.error = 1e6;
  EXPECT_EQ(samplesOf(), 17u) << "1, 1, 1, 2, 2, 2, 4, 4: an error is believed from 16 on";
}

}  // namespace
