// SPDX-License-Identifier: Apache-2.0
// Lights as a host chooses them by a field, and rays to go on with.
#include <cmath>
#include <limits>
#include <vector>

#include "awd/light.h"
#include "field/saved.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

constexpr uint32_t kLights = 4;
const float kPowers[kLights] = {4.0f, 3.0f, 2.0f, 1.0f};

class FieldLight : public testing::Test {
 protected:
  FieldLight() {
    desc_.lightCount = kLights;
    desc_.lightPowers = kPowers;
    field_ = newField(device_, &desc_);
  }
  float chance(uint32_t patch, uint32_t light) {
    float value = -1.0f;
    must(awdGetLightChance(field_, patch, light, &value));
    return value;
  }
  /// What light 0 brings to patches 0 and 1 is half as much as light 3, which patch 1 can't see.
  void shadowRays(uint32_t patch, int count, Random& random) {
    for (int i = 0; i < count; ++i) {
      uint32_t light;
      float chance;
      must(awdChooseLight(field_, patch, random.uniform(), &light, &chance, nullptr));
      const double value = light == 0 ? 1.0 : light == 3 && patch == 0 ? 2.0 : 0.0;
      must(awdRecordLight(field_, patch, light, value));
    }
  }
  Device device_ = newDevice(1u);
  AWDFieldDesc desc_ = AWD_FIELD_DESC_INIT;
  Field field_;
};

TEST_F(FieldLight, IsChosenByPowerThenByWhatItBrings) {
  for (uint32_t i = 0; i < kLights; ++i) EXPECT_NEAR(chance(7, i), 0.1 * (4.0 - i), 1e-6);
  Random random(3);
  for (int pass = 0; pass < 3; ++pass) {
    for (const uint32_t patch : {0u, 1u}) shadowRays(patch, 1000, random);
    adapt(field_);
  }
  const double trust = 0.95 * 3000.0 / 3032.0;
  EXPECT_NEAR(chance(0, 0), trust / 3.0 + (1.0 - trust) * 0.4, 1e-5);
  EXPECT_NEAR(chance(0, 3), trust * 2.0 / 3.0 + (1.0 - trust) * 0.1, 1e-5);
  EXPECT_NEAR(chance(0, 1), (1.0 - trust) * 0.3, 1e-5);
  EXPECT_NEAR(chance(1, 0), trust + (1.0 - trust) * 0.4, 1e-5);
  EXPECT_NEAR(chance(7, 0), 0.4, 1e-5) << "a patch that has learned nothing";
  float magnitude = -1.0f;
  must(awdGetPatchLight(field_, 0, &magnitude));
  EXPECT_NEAR(magnitude, 3.0f, 1e-4f);
  must(awdGetPatchLight(field_, 7, &magnitude));
  EXPECT_EQ(magnitude, 0.0f);
}

/// The sum over lights of chance times estimate is what they bring, before and after learning.
TEST_F(FieldLight, EstimatesStayTheSameInTheMean) {
  Random random(5);
  for (int pass = 0; pass < 3; ++pass) {
    double sum = 0.0;
    constexpr int kSteps = 20000;
    for (int i = 0; i < kSteps; ++i) {
      uint32_t light;
      float chance;
      double rest = -1.0;
      must(awdChooseLight(field_, 0, (i + 0.5) / kSteps, &light, &chance, &rest));
      ASSERT_TRUE(rest >= 0.0 && rest < 1.0);
      sum += (1.0 + light) / static_cast<double>(chance) / kSteps;
    }
    EXPECT_NEAR(sum, 1.0 + 2.0 + 3.0 + 4.0, 0.05);
    shadowRays(0, 200, random);
    adapt(field_);
  }
}

/// Patches whose only records are of lights are as much there as others.
TEST_F(FieldLight, IsForgottenByRevertAlone) {
  Random random(7);
  shadowRays(0, 100, random);
  must(awdMarkField(field_));
  const Bytes before = saved(field_);
  shadowRays(0, 100, random);
  shadowRays(2, 100, random);
  must(awdRevertField(field_));
  EXPECT_TRUE(saved(field_) == before);
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.patches, 1u);
  EXPECT_GT(chance(0, 3), 0.3f);
  EXPECT_NEAR(chance(2, 3), 0.1f, 1e-6f);
}

/// Halves of a patch that was split begin with what it knew.
TEST_F(FieldLight, IsInheritedWhenPatchesSplit) {
  AWDFieldDesc desc = spatialDesc();
  desc.lightCount = 2;
  const Field field = newField(device_, &desc);
  Random random(9);
  const float up[3] = {0, 0, 1};
  const auto patchAt = [&](float x) {
    const float position[3] = {x, 0.5f, 0.5f};
    uint32_t patch;
    must(awdFindPatch(field, position, up, &patch));
    return patch;
  };
  for (int i = 0; i < 1000; ++i) {
    const uint32_t patch = patchAt(static_cast<float>(random.uniform()));
    const AWDDirectionSample sample = draw(field, patch, up, random);
    must(awdRecordField(field, patch, &sample, 1.0));
    must(awdRecordLight(field, patch, 1, 1.0));
  }
  adapt(field);
  ASSERT_NE(patchAt(0.01f) / 8, patchAt(0.99f) / 8);
  for (const float x : {0.01f, 0.4f, 0.99f}) {
    float chance;
    must(awdGetLightChance(field, patchAt(x), 1, &chance));
    EXPECT_GT(chance, 0.9f);
  }
}

TEST_F(FieldLight, BadInputIsRefused) {
  uint32_t light;
  float chance;
  expectFailure(awdChooseLight(field_, 0, 1.0, &light, &chance, nullptr),
                AWD_ERROR_INVALID_ARGUMENT, {"uniform is 1"});
  expectFailure(awdChooseLight(field_, 0, std::nan(""), &light, &chance, nullptr),
                AWD_ERROR_INVALID_ARGUMENT, {"uniform"});
  expectFailure(awdGetLightChance(field_, 0, kLights, &chance), AWD_ERROR_INVALID_ARGUMENT,
                {"light is 4: the field has 4"});
  expectFailure(awdRecordLight(field_, 0, kLights, 1.0), AWD_ERROR_INVALID_ARGUMENT,
                {"light is 4"});
  must(awdRecordLight(field_, 0, 0, std::nan("")));
  must(awdRecordLight(field_, 0, 0, -1.0));
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.rejectedNaN, 1u);
  EXPECT_EQ(figures.rejectedNegative, 1u);

  const Field none = newField(device_, nullptr);
  expectFailure(awdChooseLight(none, 0, 0.5, &light, &chance, nullptr), AWD_ERROR_INVALID_OPERATION,
                {"lightCount is 0"});
  const auto make = [&](uint32_t count, std::vector<float> powers) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.lightCount = count;
    desc.lightPowers = powers.empty() ? nullptr : powers.data();
    Field field;
    return awdNewField(device_, &desc, field.out());
  };
  expectFailure(make(65, {}), AWD_ERROR_INVALID_ARGUMENT, {"at most 64"});
  expectFailure(make(2, {1.0f, NAN}), AWD_ERROR_INVALID_ARGUMENT, {"lightPowers[1]"});
  expectFailure(make(2, {-1.0f, 1.0f}), AWD_ERROR_INVALID_ARGUMENT, {"lightPowers[0]"});
  expectFailure(make(2, {0.0f, 0.0f}), AWD_ERROR_INVALID_ARGUMENT, {"all 0"});
}

TEST_F(FieldLight, ContinuationGoesByTheMean) {
  float rays = 0.0f;
  must(awdGetContinuation(field_, 5u, 1.0f, 1.0f, 0, &rays));
  EXPECT_EQ(rays, -1.0f) << "nothing is known";
  Random random(11);
  recordPass(field_, 5u, 1000, random, [](double, double) { return 2.0; });
  adapt(field_);
  const auto raysFor = [&](float throughput, float expected, uint32_t most) {
    must(awdGetContinuation(field_, 5u, throughput, expected, most, &rays));
    return rays;
  };
  EXPECT_NEAR(raysFor(1.0f, 20.0f, 0), 0.3f, 1e-3f);
  EXPECT_EQ(raysFor(1.0f, 4.0f, 0), 1.0f);
  EXPECT_NEAR(raysFor(2.0f, 1.0f, 0), 4.0f, 1e-2f);
  EXPECT_EQ(raysFor(20.0f, 1.0f, 0), 8.0f);
  EXPECT_EQ(raysFor(20.0f, 1.0f, 1), 1.0f);
  expectFailure(awdGetContinuation(field_, 0, 1.0f, 0.0f, 0, &rays), AWD_ERROR_INVALID_ARGUMENT,
                {"expected is 0"});
  expectFailure(awdGetContinuation(field_, 0, NAN, 1.0f, 0, &rays), AWD_ERROR_INVALID_ARGUMENT,
                {"throughput is nan"});
  expectFailure(awdGetContinuation(field_, 0, 1.0f, 1.0f, 65, &rays), AWD_ERROR_INVALID_ARGUMENT,
                {"maxSplit is 65"});
}

}  // namespace
