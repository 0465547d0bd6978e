// SPDX-License-Identifier: Apache-2.0
#include "render/lights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "density/levels.h"

namespace awd {
namespace {

Lights twoLights() {
  Lights lights(std::pmr::get_default_resource());
  // A quad of unequal halves with area 2, and a triangle with area 0.5 that is 12 times as bright.
  lights.add({0, 0, 1}, {1, 1, 1},
             {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, {2, 1, 0}, {0, 1, 0}});
  lights.add({0, 0, 1}, {12, 12, 12}, {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  lights.finish();
  return lights;
}

TEST(Lights, KnowTheirAreaAndShare) {
  const Lights lights = twoLights();
  ASSERT_EQ(lights.size(), 2u);
  EXPECT_FLOAT_EQ(lights[0].area, 2.0f);
  EXPECT_FLOAT_EQ(lights[1].area, 0.5f);
  EXPECT_FLOAT_EQ(lights[0].choice, 0.25f);
  EXPECT_FLOAT_EQ(lights[1].choice, 0.75f);
  EXPECT_EQ(lights.choose(0.0), 0u);
  EXPECT_EQ(lights.choose(0.249), 0u);
  EXPECT_EQ(lights.choose(0.251), 1u);
  EXPECT_EQ(lights.choose(1.0 - 0x1p-53), 1u);
  EXPECT_FLOAT_EQ(lights.brightest(), 12.0f);
}

/// Luminance as a float would be 0, and their share of it no number.
TEST(Lights, ThatAreNextToDarkShareAllThereIs) {
  Lights lights(std::pmr::get_default_resource());
  lights.add({0, 0, 1}, {0, 0, 1e-45f}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  lights.add({0, 0, 1}, {0, 0, 1e-45f}, {{5, 0, 0}, {8, 0, 0}, {5, 1, 0}});
  lights.finish();
  EXPECT_FLOAT_EQ(lights[0].choice, 0.25f);
  EXPECT_FLOAT_EQ(lights[1].choice, 0.75f);
}

Lights rowOfLights(int count) {
  Lights lights(std::pmr::get_default_resource());
  for (int i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    const float bright = i == 2 ? 100.0f : 1.0f + static_cast<float>(i % 3);
    lights.add({0, 0, 1}, {bright, bright, bright}, {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}});
  }
  lights.finish();
  return lights;
}

TEST(Lights, EachIsItsOwnGroupWhileThereAreFew) {
  EXPECT_EQ(rowOfLights(0).groups(), 0u);
  const Lights lights = rowOfLights(16);
  ASSERT_EQ(lights.groups(), 16u);
  for (uint32_t i = 0; i < 16; ++i) {
    EXPECT_FLOAT_EQ(lights.groupChance(i), lights[i].choice);
    EXPECT_EQ(lights.chooseIn(i, 0.0), i);
    EXPECT_EQ(lights.chooseIn(i, 1.0 - 0x1p-53), i);
  }
}

/// The chance of a light within its group, times that of the group, is that of choose().
TEST(Lights, ManyMakeGroupsOfNeighbours) {
  const Lights lights = rowOfLights(500);
  ASSERT_GT(lights.groups(), 8u);
  ASSERT_LE(lights.groups(), Lights::kMostGroups);
  std::vector<double> chances(lights.size());
  double all = 0.0;
  uint32_t least = 0;
  for (uint32_t g = 0; g < lights.groups(); ++g) {
    const double chance = double(lights.groupChance(g));
    all += chance;
    uint32_t last = least;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      last = lights.chooseIn(g, (i + 0.5) / kSteps);
      ASSERT_GE(last, least) << "groups are runs";
      chances[last] += chance / kSteps;
    }
    least = last + 1;
  }
  EXPECT_NEAR(all, 1.0, 1e-6);
  EXPECT_EQ(least, lights.size());
  for (uint32_t i = 0; i < lights.size(); ++i) {
    EXPECT_NEAR(chances[i], double(lights[i].choice), 1e-5) << i;
  }
}

// Null hypothesis: points are uniform over the quad. 8 x 4 bins of equal area, 31 degrees of
// freedom; chi-square above 75 has probability 2e-5. Fixed seed.
TEST(Lights, SampleUniformlyByArea) {
  const Lights lights = twoLights();
  Uniforms random(50);
  int counts[32] = {};
  constexpr int kSamples = 64000;
  for (int i = 0; i < kSamples; ++i) {
    const Vec3f p = lights.sample(lights[0], random(), random());
    ASSERT_TRUE(p.x >= 0 && p.x <= 2 && p.y >= 0 && p.y <= 1);
    ++counts[std::min(int(p.x * 4), 7) * 4 + std::min(int(p.y * 4), 3)];
  }
  double chi2 = 0.0;
  for (const int count : counts) chi2 += (count - 2000.0) * (count - 2000.0) / 2000.0;
  EXPECT_LT(chi2, 75.0);
}

TEST(Lights, EndsOfTheUniformsStayOnTheLight) {
  const Lights lights = twoLights();
  const double last = 1.0 - 0x1p-53;
  for (const double u : {0.0, last}) {
    for (const double v : {0.0, last}) {
      const Vec3f p = lights.sample(lights[0], u, v);
      EXPECT_TRUE(p.x >= 0 && p.x <= 2 && p.y >= 0 && p.y <= 1);
    }
  }
}

}  // namespace
}  // namespace awd
