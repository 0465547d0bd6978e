// SPDX-License-Identifier: Apache-2.0
// Patches that the library makes: split where samples are many, made where samples land.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "field/saved.h"
#include "field/trained.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

constexpr float kUp[3] = {0, 0, 1};

AWDFieldDesc unitBox() {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  for (float& x : desc.upper) x = 1.0f;
  desc.patchSamples = 500;
  return desc;
}

uint32_t find(AWDField field, float x, float y, float z = 0.5f, const float* normal = kUp) {
  const float position[3] = {x, y, z};
  uint32_t patch = AWD_INVALID_ID;
  must(awdFindPatch(field, position, normal, &patch));
  return patch;
}

/// A pass of samples on the plane z = 1/2: on its left half light comes from where u < 1/2, on its
/// right half from elsewhere. `reversed`: in the opposite order.
void recordPlane(AWDField field, int samples, uint64_t seed, bool reversed = false) {
  struct Item {
    uint32_t patch;
    AWDDirectionSample sample;
    double value;
  };
  std::vector<Item> items;
  Random random(seed);
  for (int i = 0; i < samples; ++i) {
    const auto x = static_cast<float>(random.uniform()), y = static_cast<float>(random.uniform());
    const uint32_t patch = find(field, x, y);
    const AWDDirectionSample s = draw(field, patch, kUp, random);
    items.push_back({patch, s, (s.square[0] < 0.5f) == (x < 0.5f) ? 1.0 : 0.0});
  }
  if (reversed) std::reverse(items.begin(), items.end());
  for (const Item& item : items) must(awdRecordField(field, item.patch, &item.sample, item.value));
}

size_t countPatches(AWDField field) {
  size_t count = 0;
  must(awdGetFieldPatches(field, nullptr, 0, &count));
  return count;
}

/// p at a place of the square.
float density(AWDField field, uint32_t patch, uint32_t column) {
  float pixels[16];
  must(awdGetPatchPdf(field, patch, 4, pixels, 0));
  return pixels[4 + column];
}

TEST(SpatialPatches, AreMadeWhereSamplesLandAndSplitWhereTheyAreMany) {
  const Device device = newDevice(1u);
  const AWDFieldDesc desc = unitBox();
  const Field field = newField(device, &desc);
  EXPECT_EQ(countPatches(field), 0u);
  recordPlane(field, 4000, 60);
  EXPECT_EQ(countPatches(field), 1u) << "one direction of normals, and nothing is split in a pass";
  adapt(field);
  // 4000 samples, at most 500 a patch, three halvings a pass of which one is across the plane.
  EXPECT_EQ(countPatches(field), 4u);
  for (uint64_t pass = 1; pass < 4; ++pass) {
    recordPlane(field, 4000, 60 + pass);
    adapt(field);
  }
  const size_t count = countPatches(field);
  EXPECT_GE(count, 32u);
  EXPECT_LE(count, 128u);
  // Each has learned its own side.
  for (const float y : {0.1f, 0.5f, 0.9f}) {
    const uint32_t left = find(field, 0.2f, y), right = find(field, 0.8f, y);
    EXPECT_GT(density(field, left, 0), 2.5f * density(field, left, 3));
    EXPECT_GT(density(field, right, 3), 2.5f * density(field, right, 0));
  }
  // Off the plane nothing is known; below it another tree looks down.
  const float down[3] = {0, 0, -1};
  EXPECT_FLOAT_EQ(density(field, find(field, 0.2f, 0.5f, 0.5f, down), 0), 1.0f);
}

/// A patch that is still too large after its three halvings of a pass, and then is met by shadow
/// rays alone: where in it samples fell is not known any more, and it stays whole until it is.
TEST(SpatialPatches, StayWholeWhenOnlyLightsAreRecorded) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = unitBox();
  desc.lightCount = 2;
  const Field field = newField(device, &desc);
  recordPlane(field, 10000, 60);
  adapt(field);
  ASSERT_EQ(countPatches(field), 4u);
  const uint32_t patch = find(field, 0.9f, 0.9f);
  must(awdRecordLight(field, patch, 1, 1.0));
  adapt(field);
  EXPECT_EQ(countPatches(field), 4u);
  EXPECT_EQ(find(field, 0.9f, 0.9f), patch);
  // What is no number could not be loaded.
  EXPECT_TRUE(sameBytes(field, loaded(device, saved(field))));
}

/// All samples of a patch in one of its halves: that half has the weight of the whole, not more by
/// a rounding, whatever that is. Weights that are no integers come with a second split.
TEST(SpatialPatches, WeighNoMoreThanTheWhole) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = unitBox();
  desc.lightCount = 2;
  desc.patchSamples = 50;
  for (uint32_t n = 0; n < 40; ++n) {
    const Field field = newField(device, &desc);
    Random random(n);
    for (const double width : {1.0, 0.2, 0.0, 0.0}) {
      for (uint32_t i = 0; i < 170 + n; ++i) {
        const auto x = static_cast<float>(0.1 + width * random.uniform());
        const uint32_t patch = find(field, x, 0.1f);
        const AWDDirectionSample sample = draw(field, patch, kUp, random);
        must(awdRecordField(field, patch, &sample, 1.0));
        must(awdRecordLight(field, patch, 1, 1.0));
      }
      adapt(field);
    }
    ASSERT_TRUE(sameBytes(field, loaded(device, saved(field)))) << n;
  }
}

/// Where a fourth of the samples brings f/p = 12 and the others nothing, the mean is 3.
TEST(SpatialPatches, TellWhatTheyReflect) {
  const Device device = newDevice();
  const AWDFieldDesc desc = unitBox();
  const Field field = newField(device, &desc);
  const uint32_t patch = find(field, 0.3f, 0.3f);
  float mean = 0.0f;
  must(awdGetPatchMean(field, patch, &mean));
  EXPECT_EQ(mean, -1.0f) << "nothing is known";
  Random random(60);
  for (int i = 0; i < 400; ++i) {
    const AWDDirectionSample s = draw(field, patch, kUp, random);
    must(awdRecordField(field, patch, &s, i % 4 == 0 ? 12.0 * static_cast<double>(s.pdf) : 0.0));
  }
  must(awdGetPatchMean(field, patch, &mean));
  EXPECT_EQ(mean, -1.0f) << "not before the field adapts";
  must(awdAdaptField(field, nullptr));
  must(awdGetPatchMean(field, find(field, 0.3f, 0.3f), &mean));
  EXPECT_NEAR(mean, 3.0f, 1e-4f);
  EXPECT_EQ(awdGetPatchMean(field, patch, nullptr), AWD_ERROR_INVALID_ARGUMENT);
}

TEST(SpatialPatches, GiveTheSameBitsInAnyOrder) {
  const Device device = newDevice(1u);
  const AWDFieldDesc desc = unitBox();
  Field fields[2] = {newField(device, &desc), newField(device, &desc)};
  for (uint64_t pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < 2; ++i) {
      recordPlane(fields[i], 3000, 70 + pass, i == 1);
      adapt(fields[i]);
    }
  }
  ASSERT_EQ(countPatches(fields[0]), countPatches(fields[1]));
  for (float x = 0.05f; x < 1.0f; x += 0.1f) {
    const uint32_t patch = find(fields[0], x, 0.4f);
    EXPECT_EQ(find(fields[1], x, 0.4f), patch);
    EXPECT_EQ(coefficientsOf(fields[0], patch).c, coefficientsOf(fields[1], patch).c);
  }
}

/// A pass that is given up leaves no trace, not even the patches that it made.
TEST(SpatialPatches, ForgetAPassThatIsReverted) {
  const Device device = newDevice(1u);
  const AWDFieldDesc desc = unitBox();
  const float down[3] = {0, 0, -1};
  std::vector<double> outcome[2];
  for (const bool disturbed : {false, true}) {
    const Field field = newField(device, &desc);
    recordPlane(field, 3000, 75);
    adapt(field);
    if (disturbed) {
      must(awdMarkField(field));
      recordPlane(field, 2000, 76);
      Random random(77);
      for (int i = 0; i < 500; ++i) {  // where there is no patch yet: off the plane, and below
        for (const float z : {0.1f, 0.9f}) {
          for (const float* normal : {kUp, down}) {
            const uint32_t patch =
                find(field, static_cast<float>(random.uniform()), 0.3f, z, normal);
            const AWDDirectionSample s = draw(field, patch, normal, random);
            must(awdRecordField(field, patch, &s, 7.0));
          }
        }
      }
      must(awdRevertField(field));
    }
    for (uint64_t pass = 0; pass < 2; ++pass) {
      recordPlane(field, 3000, 78 + pass);
      adapt(field);
    }
    for (const float z : {0.1f, 0.5f, 0.9f}) {
      for (float x = 0.05f; x < 1.0f; x += 0.1f) {
        const auto c = coefficientsOf(field, find(field, x, 0.3f, z)).c;
        outcome[disturbed].insert(outcome[disturbed].end(), c.begin(), c.end());
      }
    }
  }
  EXPECT_EQ(outcome[0], outcome[1]);
}

TEST(SpatialPatches, StopAtTheMemoryAllowedAndSaySo) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = unitBox();
  desc.maxBytes = 60000;
  const Field field = newField(device, &desc);
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  for (uint64_t pass = 0; pass < 5; ++pass) {
    recordPlane(field, 8000, 80 + pass);
    must(awdAdaptField(field, &figures));
  }
  EXPECT_GT(figures.capped, 0u);
  EXPECT_GT(figures.patches, 2u);
  EXPECT_LT(figures.bytes, 70000u) << "but for the table by which patches are found";
  // It goes on learning.
  EXPECT_GT(density(field, find(field, 0.1f, 0.5f), 0), density(field, find(field, 0.1f, 0.5f), 3));
}

TEST(SpatialPatches, RefuseWhatTheyCannotPlace) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.patches = AWD_PATCHES_SPATIAL;
  AWDField none = nullptr;
  expectFailure(awdNewField(device, &desc, &none), AWD_ERROR_INVALID_ARGUMENT, {"desc->lower"});
  desc.upper[0] = NAN;
  expectFailure(awdNewField(device, &desc, &none), AWD_ERROR_INVALID_ARGUMENT, {"desc->upper"});
  desc = unitBox();
  const Field field = newField(device, &desc);
  const float nowhere[3] = {0, INFINITY, 0}, position[3] = {0, 0, 0}, shortNormal[3] = {0, 0, 0.5f};
  uint32_t patch = 0;
  expectFailure(awdFindPatch(field, nowhere, kUp, &patch), AWD_ERROR_INVALID_ARGUMENT,
                {"position"});
  expectFailure(awdFindPatch(field, position, shortNormal, &patch), AWD_ERROR_INVALID_ARGUMENT,
                {"normal"});
  Random random(90);
  const AWDDirectionSample s = draw(field, find(field, 0.1f, 0.1f), kUp, random);
  expectFailure(awdRecordField(field, 1000000u, &s, 1.0), AWD_ERROR_INVALID_ARGUMENT, {"1000000"});
  const Field host = newField(device, nullptr);
  expectFailure(awdFindPatch(host, position, kUp, &patch), AWD_ERROR_INVALID_OPERATION, {"host"});
}

}  // namespace
