// SPDX-License-Identifier: Apache-2.0
// Tiny scenes, made and released again a million times: what they took comes back.
#include <gtest/gtest.h>

#include "support/counting_allocator.h"
#include "support/films.h"
#include "support/process.h"
#include "support/scenes.h"
#include "support/soak.h"

namespace {

using namespace awdtest;

/// A lamp over a floor, of other triangles each time.
SceneBuilder floorAndLamp(size_t number) {
  SceneBuilder scene;
  const uint32_t grey = scene.material(awdtest::grey(0.5)),
                 lamp = scene.material(awdtest::grey(0.0),
                                       awdtest::grey(1.0 + static_cast<double>(number % 7)));
  const double height = 1.0 + static_cast<double>(number % 16) / 8.0;
  scene.quad({-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, grey);
  scene.triangle({0, height, 0}, {0.5, height, 0}, {0, height, 0.5}, lamp);
  return scene;
}

void makeAndRelease(AWDDevice device, size_t number) {
  const Scene scene = floorAndLamp(number).commit(device);
  const AWDRay down = {{0.25f, 0.5f, 0.25f}, 0.0f, {0.0f, -1.0f, 0.0f}, 10.0f};
  AWDHit hit = {};
  must(awdIntersect(scene, &down, 1, &hit));
  ASSERT_FLOAT_EQ(hit.t, 0.5f);
  if (number % 64 != 0) return;
  const AWDCamera view = camera({0, 0.5, 3}, {0, 0.25, 0}, {0, 1, 0}, 0.5, 4, 4);
  const Render render = newRender(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, number));
  runPasses(render, {1, 1});
}

TEST(Scenes, AMillion) {
  const size_t scenes = soakSize(500, 1'000'000), warm = scenes / 5;
  CountingAllocator allocator;
  const AWDDeviceDesc desc = allocator.desc(2);
  Device device = newDevice(&desc);
  size_t held = 0, bytes = 0, files = 0, threads = 0;
  for (size_t number = 0; number < scenes; ++number) {
    if (number % 1000 == 999) device = newDevice(&desc);
    makeAndRelease(device, number);
    if (number == warm) {
      held = memoryHeld();
      bytes = allocator.held();
      files = filesHeld();
      threads = threadsHeld();
    }
  }
  EXPECT_EQ(allocator.held(), bytes);
  EXPECT_EQ(filesHeld(), files);
  EXPECT_LE(threadsHeld(), threads);
  // The kernel counts pages: a sample sees 10 KB lost a scene, all of them 5 bytes.
  if (!memoryIsWatched()) {
    EXPECT_LT(memoryHeld(), held + (size_t{4} << 20));
  }
  device = Device();
  EXPECT_EQ(allocator.blocks(), 0u);
}

}  // namespace
