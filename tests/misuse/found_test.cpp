// SPDX-License-Identifier: Apache-2.0
// What the sequences have found, as calls in C.
#include <gtest/gtest.h>

#include <limits>

#include "misuse/world.h"
#include "support/expect.h"

namespace {

using namespace awdmisuse;
using awdtest::expectFailure;

class Found : public testing::Test {
 protected:
  World world_;
};

/// Embree ends the program for such a ray where it has assertions, and else it meets what it should
/// not.
TEST_F(Found, RaysThatBeginBehindTheirOrigin) {
  AWDRay ray = {{0.5f, 0.25f, 1.0f}, -1.0f, {0.0f, 0.0f, -1.0f}, 10.0f};
  AWDHit hit = {};
  uint8_t occluded = 0;
  for (const float bad : {-1.0f, -1e-30f, std::numeric_limits<float>::infinity()}) {
    ray.tnear = bad;
    const AWDResult kInvalid = AWD_ERROR_INVALID_ARGUMENT;
    expectFailure(awdIntersect(world_.scenes[0], &ray, 1, &hit), kInvalid, {"rays[0]", "tnear"});
    expectFailure(awdOccluded(world_.scenes[0], &ray, 1, &occluded), kInvalid, {"tnear"});
  }
}

/// A ray without a length meets nothing; it was said to be occluded.
TEST_F(Found, RaysThatEndBeforeTheyBegin) {
  for (const float end : {-1.0f, 0.5f, -std::numeric_limits<float>::infinity()}) {
    const AWDRay ray = {{0.5f, 0.25f, 1.0f}, 0.75f, {0.0f, 0.0f, -1.0f}, end};
    AWDHit hit = {};
    uint8_t occluded = 7;
    ASSERT_EQ(awdIntersect(world_.scenes[0], &ray, 1, &hit), AWD_SUCCESS);
    ASSERT_EQ(awdOccluded(world_.scenes[0], &ray, 1, &occluded), AWD_SUCCESS);
    EXPECT_EQ(hit.mesh, AWD_INVALID_ID) << end;
    EXPECT_EQ(occluded, 0) << end;
  }
}

/// A name of the host's in a message could begin a line of its own, or steer a terminal.
TEST_F(Found, MessagesHaveOneLine) {
  float pixels[12];
  expectFailure(awdGetImageChannel(world_.images[0], "a\nb\x1b[2J", pixels, 0, 0),
                AWD_ERROR_INVALID_ARGUMENT, {"\"a?b?[2J\""});
}

/// No version of a struct ends within a word: a pointer would be taken from half of its bytes.
TEST_F(Found, StructsThatEndWithinAWord) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.structSize = offsetof(AWDDeviceDesc, allocUser) + 3;
  AWDDevice device = nullptr;
  expectFailure(awdNewDevice(&desc, &device), AWD_ERROR_INVALID_ARGUMENT, {"structSize is 67"});
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  info.structSize -= 4;
  expectFailure(awdGetSceneInfo(world_.scenes[0], &info), AWD_ERROR_INVALID_ARGUMENT,
                {"info->structSize"});
}

/// It took over bases and device, and gave its own memory back to the wrong allocator.
TEST_F(Found, AForkOfAnotherDeviceIsNotJoined) {
  SmallMemory own;
  const AWDDeviceDesc desc = own.desc(1);
  AWDDevice device = nullptr;
  ASSERT_EQ(awdNewDevice(&desc, &device), AWD_SUCCESS);
  AWDDensityDesc densityDesc = AWD_DENSITY_DESC_INIT;
  densityDesc.dimensions = 2;
  AWDDensity stranger = nullptr;
  ASSERT_EQ(awdNewDensity(device, &densityDesc, &stranger), AWD_SUCCESS);
  awdReleaseDevice(device);
  expectFailure(awdJoinDensity(world_.densities[0], stranger), AWD_ERROR_INVALID_ARGUMENT,
                {"another device"});
  awdReleaseDensity(stranger);
  EXPECT_EQ(own.blocks(), 0u);
}

}  // namespace
