// SPDX-License-Identifier: Apache-2.0
// Eight hosts in one process, each with a device of another number of threads, all with the bases
// of one folder: each gets the bits that it would get alone.
#include <gtest/gtest.h>

#include <thread>

#include "support/outcome.h"
#include "support/process.h"
#include "support/scenes.h"
#include "support/soak.h"

namespace {

using namespace awdtest;

constexpr uint32_t kHosts = 8;

/// Bases and seeds differ from host to host.
Outcome renderAs(uint32_t host, uint32_t threads) {
  const char* const bases[] = {"haar", "linear-bspline", "quadratic-bspline", "m2"};
  const char* const folder = AWD_BASES_FOLDER;
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.threads = threads;
  deviceDesc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  deviceDesc.basisPaths = &folder;
  deviceDesc.basisPathCount = 1;
  const Device device = newDevice(&deviceDesc);
  const Scene scene = lampRoom().commit(device);
  AWDFieldDesc learns = AWD_FIELD_DESC_INIT;
  learns.basis = bases[host % 4];
  Field field;
  must(awdNewSceneField(scene, &learns, field.out()));
  const AWDCamera view = lampRoomCamera(20);
  const Render render = newRender(scene, renderDesc(view, AWD_GUIDE_ADAPTIVE, host), field);
  runPasses(render, {1, 1, 2});
  return outcomeOf(render);
}

TEST(Hosts, EightAtOnce) {
  std::vector<Outcome> alone;
  for (uint32_t host = 0; host < kHosts; ++host) alone.push_back(renderAs(host, 1));
  const size_t files = filesHeld();
  size_t held = 0;
  const size_t rounds = soakSize(1, 200);
  for (size_t round = 0; round < rounds; ++round) {
    std::vector<Outcome> together(kHosts);
    std::vector<std::string> errors(kHosts);
    std::vector<std::thread> threads;
    for (uint32_t host = 0; host < kHosts; ++host) {
      threads.emplace_back([&, host] {
        try {
          together[host] = renderAs(host, host + 1);
        } catch (const std::exception& error) {
          errors[host] = error.what();
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (uint32_t host = 0; host < kHosts; ++host) {
      SCOPED_TRACE("host " + std::to_string(host) + ", round " + std::to_string(round));
      ASSERT_EQ(errors[host], "");
      expectSameOutcome(together[host], alone[host]);
    }
    if (round == rounds / 10) held = memoryHeld();
  }
  EXPECT_EQ(filesHeld(), files);
  // Embree and oneTBB keep threads and memory for the next device, but not more for each.
  if (wholeSoak() && !memoryIsWatched()) {
    EXPECT_LT(memoryHeld(), held + (size_t{32} << 20));
  }
}

}  // namespace
