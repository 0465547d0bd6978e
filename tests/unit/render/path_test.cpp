// SPDX-License-Identifier: Apache-2.0
// Light transport itself is tested against closed forms in tests/statistical; here the parts that
// only show from inside.
#include "render/path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/rooms.h"
#include "util/error.h"

namespace awd {
namespace {

TEST(PathSettings, PresetsFillWhatIsOpen) {
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  EXPECT_EQ(settle(desc).direct, AWD_DIRECT_WEIGHTED);
  EXPECT_EQ(settle(desc).roulette, AWD_ROULETTE_ADJOINT);
  EXPECT_EQ(settle(desc).shadowRays, 1u);
  EXPECT_EQ(settle(desc).maxSplit, 8u);
  EXPECT_TRUE(settle(desc).learnLights);
  desc.roulette = AWD_ROULETTE_ADJOINT;
  desc.guide = AWD_GUIDE_COSINE;
  EXPECT_THROW(settle(desc), Error) << "nothing is learned";
  desc.roulette = AWD_ROULETTE_DEFAULT;
  EXPECT_EQ(settle(desc).roulette, AWD_ROULETTE_ALBEDO);
  desc.guide = AWD_GUIDE_UNIFORM;
  EXPECT_EQ(settle(desc).roulette, AWD_ROULETTE_THROUGHPUT);
  desc.preset = AWD_PRESET_PAPER;
  EXPECT_EQ(settle(desc).direct, AWD_DIRECT_AREA);
  EXPECT_EQ(settle(desc).roulette, AWD_ROULETTE_ALBEDO);
  EXPECT_EQ(settle(desc).shadowRays, 4u);
  EXPECT_FALSE(settle(desc).learnLights);
  desc.shadowRays = 2000;
  EXPECT_THROW(settle(desc), Error);
}

TEST(PathTracer, SeesALampAsItIs) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Geometry& g = scene->geometry();
  PathTracer tracer(g, nullptr, PathSettings());
  PathPoints points(1, 0, 0, 0, false, 0);
  EXPECT_EQ(tracer.trace(g.toFrame({0, 0, 0.5f}), {0, 0, 1}, points), (Rgb{10, 10, 10}));
  EXPECT_EQ(tracer.trace(g.toFrame({0, 0, 2.0f}), {0, 0, -1}, points), Rgb()) << "its back";
  EXPECT_EQ(tracer.trace(g.toFrame({5, 5, 5}), {0, 0, 1}, points), Rgb()) << "nothing there";
  EXPECT_EQ(tracer.shadowRays(), 0u);
}

// The balance heuristic: what shadow rays and indirect rays count of a lamp adds up, so that the
// weighted estimate and those by either alone agree in the mean. 40,000 paths each; each |z| < 4.5
// fails with probability 7e-6.
TEST(PathTracer, WeightsAddUpToOne) {
  const Ref<Scene> scene = sceneOf(floorAndLamp());
  const Geometry& g = scene->geometry();
  double mean[3], error[3];
  const AWDDirectLight ways[] = {AWD_DIRECT_AREA, AWD_DIRECT_WEIGHTED, AWD_DIRECT_NONE};
  for (int i = 0; i < 3; ++i) {
    PathSettings settings;
    settings.guide = AWD_GUIDE_COSINE;
    settings.direct = ways[i];
    PathTracer tracer(g, nullptr, settings);
    double sum = 0.0, squares = 0.0;
    constexpr int kPaths = 40000;
    for (int s = 0; s < kPaths; ++s) {
      PathPoints points(2, i, 0, s, false, 0);
      const double x = tracer.trace(g.toFrame({0.3f, 0.2f, 0.5f}), {0, 0, -1}, points).x;
      sum += x;
      squares += x * x;
    }
    mean[i] = sum / kPaths;
    error[i] = std::sqrt((squares / kPaths - mean[i] * mean[i]) / kPaths);
  }
  for (const int i : {1, 2}) {
    EXPECT_LT(std::abs(mean[0] - mean[i]), 4.5 * std::hypot(error[0], error[i]));
  }
  EXPECT_GT(mean[0], 0.1);
}

}  // namespace
}  // namespace awd
