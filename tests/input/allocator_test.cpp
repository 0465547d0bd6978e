// SPDX-License-Identifier: Apache-2.0
// The host's allocator: all of it comes back, and running out of it is an error like any other.
#include <gtest/gtest.h>

#include "support/counting_allocator.h"
#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

/// All that a host does in a short life; the first error ends it.
AWDResult live(const AWDDeviceDesc& deviceDesc) {
  AWDDevice device = nullptr;
  AWDScene scene = nullptr;
  AWDRender render = nullptr;
  AWDField field = nullptr;
  AWDImage image = nullptr;
  const auto step = [&](AWDResult result, const void* output) {
    if (result != AWD_SUCCESS) {
      EXPECT_EQ(output, nullptr);
    }
    return result;
  };
  const auto run = [&]() -> AWDResult {
    const SceneBuilder room = lampRoom();
    const AWDMeshDesc mesh = room.mesh();
    const AWDCamera view = lampRoomCamera(9);
    const AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_ADAPTIVE, 1);
    const AWDRay ray = {{2, 1, 3}, 0.0f, {0, 0, -1}, 100.0f};
    AWDHit hit;
    std::vector<float> film(9 * 9 * 3);
    const uint32_t passes[] = {1, 2};
    AWDSchedule schedule = AWD_SCHEDULE_INIT;
    schedule.samplesPerPass = passes;
    schedule.passCount = 2;
    AWDResult r;
    if ((r = step(awdNewDevice(&deviceDesc, &device), device))) return r;
    if ((r = step(awdNewScene(device, &scene), scene))) return r;
    for (const Rgb light : {Rgb{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {9, 9, 9}}) {
      const AWDMaterialDesc material = {
          sizeof material, {0.5f, 0.5f, 0.5f}, {light[0], light[1], light[2]}};
      if ((r = awdAddMaterial(scene, &material, nullptr))) return r;
    }
    if ((r = awdAddMesh(scene, &mesh, nullptr))) return r;
    if ((r = awdCommitScene(scene))) return r;
    if ((r = awdIntersect(scene, &ray, 1, &hit))) return r;
    if ((r = step(awdNewRender(scene, nullptr, &desc, &render), render))) return r;
    if ((r = awdRenderPasses(render, &schedule))) return r;
    if ((r = awdReadFilm(render, AWD_FILM_VARIANCE, film.data(), 0, 0))) return r;
    if ((r = step(awdGetRenderField(render, &field), field))) return r;
    if ((r = awdAdaptField(field, nullptr))) return r;
    if ((r = step(awdNewFilmImage(render, &image), image))) return r;
    return AWD_SUCCESS;
  };
  const AWDResult result = run();
  awdReleaseDevice(device);  // parents first: children keep them alive
  awdReleaseScene(scene);
  awdReleaseRender(render);
  awdReleaseField(field);
  awdReleaseImage(image);
  return result;
}

class Allocator : public testing::TestWithParam<uint32_t> {};
INSTANTIATE_TEST_SUITE_P(Threads, Allocator, testing::Values(1u, 2u));

TEST_P(Allocator, EverythingComesBack) {
  CountingAllocator allocator;
  must(live(allocator.desc(GetParam())));
  EXPECT_EQ(allocator.blocks(), 0u);
  EXPECT_GT(allocator.calls(), 10u);
  EXPECT_GT(allocator.bytes(), 9u * 9 * 3 * sizeof(float));
}

/// One refusal, or no memory from then on: at each of the first calls, then in growing steps.
TEST_P(Allocator, RefusalIsOutOfMemory) {
  CountingAllocator counter;
  must(live(counter.desc(GetParam())));
  for (const bool allLater : {false, true}) {
    size_t failures = 0, steps = 0;
    for (size_t n = 1; n <= counter.calls(); n += 1 + n / 40, ++steps) {
      SCOPED_TRACE(n);
      CountingAllocator allocator;
      allocator.refuse(n, allLater);
      const AWDResult result = live(allocator.desc(GetParam()));
      if (result != AWD_SUCCESS) {
        ++failures;
        EXPECT_EQ(result, AWD_ERROR_OUT_OF_MEMORY) << awdGetLastErrorMessage();
        EXPECT_STRNE(awdGetLastErrorMessage(), "");
      }
      EXPECT_EQ(allocator.blocks(), 0u) << "leaked";
    }
    EXPECT_GT(failures, steps / 2);
  }
}

}  // namespace
