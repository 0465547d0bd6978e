// SPDX-License-Identifier: Apache-2.0
// The same seed gives the same bits: film, densities and figures, for any number of threads and
// any order in which work is done.
#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

/// All that a render leaves behind, but times.
struct Outcome {
  Film film;
  std::vector<uint32_t> patches;
  std::vector<std::vector<double>> coefficients;  // a patch each
  std::vector<uint64_t> figures;                  // of each pass in turn
};

std::vector<double> coefficientsOf(AWDField field, uint32_t patch) {
  AWDPatchInfo info = AWD_PATCH_INFO_INIT;
  must(awdGetPatchInfo(field, patch, &info));
  std::vector<double> result(size_t{info.axisCount} * info.axisCount);
  must(awdGetPatchCoefficients(field, patch, result.data(), result.size()));
  return result;
}

Outcome outcomeOf(const AWDDeviceDesc& deviceDesc, uint64_t seed,
                  AWDPreset preset = AWD_PRESET_DEFAULT, uint32_t width = 29) {
  const Device device = newDevice(&deviceDesc);
  const Scene scene = sevenLampRoom().commit(device);
  AWDCamera view = lampRoomCamera(19);
  view.width = width;  // not a multiple of any tile
  AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_ADAPTIVE, seed);
  desc.preset = preset;
  const Render render = newRender(scene, desc);
  runPasses(render, {3, 5, 8});

  Outcome result;
  result.film = readFilm(render);
  Field field;
  must(awdGetRenderField(render, field.out()));
  size_t count = 0;
  must(awdGetFieldPatches(field, nullptr, 0, &count));
  result.patches.resize(count);
  must(awdGetFieldPatches(field, result.patches.data(), count, &count));
  for (const uint32_t patch : result.patches) {
    result.coefficients.push_back(coefficientsOf(field, patch));
  }
  for (uint32_t pass = 0; pass < 3; ++pass) {
    AWDPassStatistics s = AWD_PASS_STATISTICS_INIT;
    must(awdGetPassStatistics(render, pass, &s));
    result.figures.insert(result.figures.end(),
                          {s.samplesPerPixel, s.samples, s.rays, s.shadowRays, s.patches,
                           s.coefficients, s.bytes, s.rejectedSamples});
  }
  return result;
}

AWDDeviceDesc threads(uint32_t count) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = count;
  return desc;
}

void expectSame(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.film.radiance, b.film.radiance);
  EXPECT_EQ(a.film.variance, b.film.variance);
  EXPECT_EQ(a.patches, b.patches);
  EXPECT_EQ(a.coefficients, b.coefficients);
  EXPECT_EQ(a.figures, b.figures);
}

TEST(Determinism, AnyNumberOfThreads) {
  const Outcome one = outcomeOf(threads(1), 42);
  EXPECT_GT(one.patches.size(), 6u);
  EXPECT_GT(*std::max_element(one.film.radiance.begin(), one.film.radiance.end()), 0.0f);
  for (const uint32_t count : {1u, 2u, 5u, 0u}) {
    SCOPED_TRACE(count);
    expectSame(one, outcomeOf(threads(count), 42));
  }
}

TEST(Determinism, ThePaperToo) {
  const Outcome one = outcomeOf(threads(1), 9, AWD_PRESET_PAPER);
  expectSame(one, outcomeOf(threads(3), 9, AWD_PRESET_PAPER));
}

void backwards(void* calls, size_t count, AWDTaskFn task, void* taskData) {
  ++*static_cast<int*>(calls);
  for (size_t i = count; i-- > 0;) task(taskData, i);
}

/// Each index on a thread of its own, the odd ones first.
void scattered(void* calls, size_t count, AWDTaskFn task, void* taskData) {
  ++*static_cast<int*>(calls);
  for (const size_t parity : {1u, 0u}) {
    std::vector<std::thread> helpers;
    for (size_t i = parity; i < count; i += 2) helpers.emplace_back(task, taskData, i);
    for (std::thread& helper : helpers) helper.join();
  }
}

TEST(Determinism, TheHostsSchedulerInAnyOrder) {
  const Outcome one = outcomeOf(threads(1), 42);
  for (const AWDParallelForFn parallelFor : {&backwards, &scattered}) {
    int calls = 0;
    AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
    desc.parallelFor = parallelFor;
    desc.parallelForUser = &calls;
    expectSame(one, outcomeOf(desc, 42));
    EXPECT_GT(calls, 0);
  }
}

TEST(Determinism, SeedsDiffer) {
  const Outcome one = outcomeOf(threads(1), 0);
  for (const uint64_t seed : {uint64_t{1}, uint64_t{1} << 32, ~uint64_t{0}}) {
    const Outcome other = outcomeOf(threads(1), seed);
    size_t same = 0;
    for (size_t i = 0; i < one.film.radiance.size(); ++i) {
      same += one.film.radiance[i] == other.film.radiance[i];
    }
    EXPECT_LT(same, one.film.radiance.size() / 20) << seed;
  }
}

/// Passes one by one, with the host's own adapt, are what awdRenderPasses does.
TEST(Determinism, PassesOneByOne) {
  const Device device = newDevice(2u);
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(16);
  const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_ADAPTIVE, 5);
  const Film atOnce = renderFilm(scene, desc, {4, 6, 10});

  // The scene's box makes the field as the render makes its own.
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
  std::copy(info.lower, info.lower + 3, fieldDesc.lower);
  std::copy(info.upper, info.upper + 3, fieldDesc.upper);
  const Field field = newField(device, &fieldDesc);
  const Render render = newRender(scene, desc, field);
  for (const uint32_t samples : {4u, 6u, 10u}) {
    must(awdRenderPass(render, samples, nullptr));
    if (samples != 10u) must(awdAdaptField(field, nullptr));
  }
  const Film stepwise = readFilm(render);
  EXPECT_EQ(atOnce.radiance, stepwise.radiance);
  EXPECT_EQ(atOnce.variance, stepwise.variance);
  EXPECT_EQ(stepwise.samplesPerPixel, 20u);
}

/// Without adapting, a pass of 10 is the film of passes of 4 and 6 only in the mean: passes draw
/// numbers of their own.
TEST(Determinism, PassesDrawNewNumbers) {
  const Device device = newDevice(2u);
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(16);
  const Render render = newRender(scene, renderDesc(view, AWD_GUIDE_COSINE, 5));
  must(awdRenderPass(render, 4, nullptr));
  const Film first = readFilm(render);
  must(awdRenderPass(render, 4, nullptr));
  const Film both = readFilm(render);
  EXPECT_NE(first.radiance, both.radiance);
}

}  // namespace
