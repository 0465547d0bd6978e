// SPDX-License-Identifier: Apache-2.0
#include "guide/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "density/levels.h"
#include "util/error.h"

namespace awd {
namespace {

Ref<Context> context(uint32_t threads = 1) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = threads;
  return Context::make(desc);
}

Ref<Field> makeField(AWDFieldDesc desc, const char* name = "haar") {
  return Field::make(context(), table(name),
                     settle(std::pmr::get_default_resource(), desc, table(name)));
}

/// One pass: value(u, v) on the square is recorded for samples of patch `number`.
template <class Value>
void run(Field& field, uint32_t number, int samples, uint64_t seed, Value&& value) {
  Uniforms random(seed);
  for (int i = 0; i < samples; ++i) {
    const double u[3] = {random(), random(), random()};
    const AWDDirectionSample s = field.sample(number, {0, 0, 1}, u);
    field.record(number, s, value(s.square[0], s.square[1]) / double(s.solidAngle));
  }
}

double bump(float u, float v) { return u < 0.25f && v < 0.25f ? 10.0 : 0.1; }

TEST(FieldSettings, PresetsFillWhatIsOpen) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  const FieldSettings standard = settle(std::pmr::get_default_resource(), desc, haarTable());
  EXPECT_EQ(standard.map, AWD_MAP_CONCENTRIC_COSINE);
  EXPECT_LT(standard.learning.tau, 0.0);
  EXPECT_EQ(standard.alpha, 0.1);
  EXPECT_EQ(standard.patches, AWD_PATCHES_HOST) << "without a box";
  EXPECT_EQ(standard.learning.estimator, AWD_ESTIMATOR_LUMPED);
  EXPECT_EQ(standard.startLevel, 3u);
  EXPECT_EQ(standard.maxLevel, 4u);
  desc.preset = AWD_PRESET_PAPER;
  const FieldSettings paper = settle(std::pmr::get_default_resource(), desc, haarTable());
  EXPECT_EQ(paper.map, AWD_MAP_SPHERICAL);
  EXPECT_EQ(paper.startLevel, 2u);
  EXPECT_EQ(paper.maxLevel, 4u);
  EXPECT_EQ(paper.learning.tau, 0.05);
  desc.maxLevel = AWD_LEVEL(1);
  EXPECT_EQ(settle(std::pmr::get_default_resource(), desc, haarTable()).startLevel, 1u);
  desc.startLevel = AWD_LEVEL(3);
  EXPECT_THROW(settle(std::pmr::get_default_resource(), desc, haarTable()), Error);
  desc.maxLevel = AWD_LEVEL(40);
  EXPECT_THROW(settle(std::pmr::get_default_resource(), desc, haarTable()), Error);
}

TEST(Field, LearnsWhereTheLightIs) {
  for (const char* name : kFamilies) {
    const Ref<Field> field = makeField(AWD_FIELD_DESC_INIT, name);
    run(*field, 7, 4000, 30, bump);
    const AWDFieldStatistics figures = field->adapt();
    EXPECT_EQ(figures.patches, 1u);
    EXPECT_EQ(figures.samples, 4000u);
    EXPECT_EQ(figures.kept, 0u);
    // On a periodic axis the corner is shared with the dark far side.
    EXPECT_GT(field->density(7).pdf(0.1f, 0.1f), 3.0) << name;
    EXPECT_LT(field->density(7).pdf(0.8f, 0.8f), 1.0) << name;
    EXPECT_NEAR(field->density(8).pdf(0.1f, 0.1f), 1.0, 1e-12) << "an unseen patch";
    EXPECT_EQ(field->patchInfo(7).learned, 4000u);
  }
}

TEST(Field, PaperRefinesEachPassUpToItsLevel) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.preset = AWD_PRESET_PAPER;
  const Ref<Field> field = makeField(desc);
  for (const uint32_t level : {3u, 4u, 4u}) {
    run(*field, 1, 100, level, bump);
    field->adapt();
    EXPECT_EQ(field->patchInfo(1).level, level);
  }
}

TEST(Field, DefaultRefinesWhenSamplesSuffice) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.startLevel = AWD_LEVEL(2);
  const Ref<Field> field = makeField(desc);
  run(*field, 1, 40, 31, bump);
  run(*field, 2, 40000, 32, bump);
  field->adapt();
  EXPECT_EQ(field->patchInfo(1).level, 2u);
  EXPECT_EQ(field->patchInfo(2).level, 3u);
}

TEST(Field, KeepsItsDensityWhenNothingCame) {
  const Ref<Field> field = makeField(AWD_FIELD_DESC_INIT);
  run(*field, 1, 1000, 33, bump);
  field->adapt();
  const double before = field->density(1).pdf(0.1f, 0.1f);
  run(*field, 1, 1000, 34, [](float, float) { return 0.0; });
  EXPECT_EQ(field->adapt().kept, 1u);
  EXPECT_EQ(field->density(1).pdf(0.1f, 0.1f), before);
  run(*field, 1, 10, 35, [](float, float) { return std::nan(""); });
  const AWDFieldStatistics figures = field->adapt();
  EXPECT_EQ(figures.rejected, 10u);
  EXPECT_EQ(field->density(1).pdf(0.1f, 0.1f), before);
}

TEST(Field, FindsTheScaleOfAnyRadiance) {
  for (const double scale : {1e-300, 1e-30, 1e30, 1e300}) {
    const Ref<Field> field = makeField(AWD_FIELD_DESC_INIT);
    // Unless told, it takes one pass to find out how bright the world is.
    for (int pass = 0; pass < 2; ++pass) {
      run(*field, 1, 1000, 36, [&](float u, float v) { return bump(u, v) * scale; });
      field->adapt();
    }
    EXPECT_GT(field->density(1).pdf(0.1f, 0.1f), 4.0) << scale;
  }
}

TEST(Field, RevertForgetsWhatCameAfterTheMark) {
  const Ref<Field> plain = makeField(AWD_FIELD_DESC_INIT);
  const Ref<Field> marked = makeField(AWD_FIELD_DESC_INIT);
  run(*plain, 1, 500, 37, bump);
  run(*marked, 1, 500, 37, bump);
  marked->mark();
  run(*marked, 1, 300, 38, [](float, float) { return 99.0; });
  run(*marked, 2, 300, 39, bump);
  marked->revert();
  EXPECT_EQ(marked->statistics().patches, 1u);
  EXPECT_EQ(marked->patchInfo(1).samples, 500u);
  // After the mark work goes on; a second mark takes it in.
  run(*plain, 1, 200, 40, bump);
  run(*marked, 1, 200, 40, bump);
  marked->mark();
  run(*marked, 1, 50, 41, bump);
  marked->revert();
  plain->adapt();
  marked->adapt();
  EXPECT_EQ(plain->density(1).coefficients(), marked->density(1).coefficients());
}

/// Room was made for a record that never came, since there was none for the next one.
TEST(Field, ForgetsPatchesThatWereNotRecordedIn) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.patches = AWD_PATCHES_SPATIAL;
  desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
  const auto use = [&](const std::function<void(Field&)>& between) {
    const Ref<Field> field = makeField(desc);
    const uint32_t seen = field->findPatch({0.5f, 0.5f, 0.5f}, {0, 0, 1});
    const uint32_t unseen = field->findPatch({0.5f, 0.5f, 0.5f}, {1, 0, 0});
    field->makeRoom(unseen);
    run(*field, seen, 100, 46, bump);
    field->adapt();
    EXPECT_FALSE(field->view(unseen).statistics);
    between(*field);
    run(*field, unseen, 100, 47, bump);
    EXPECT_EQ(field->patchInfo(unseen).samples, 100u);
    field->adapt();
    EXPECT_GT(field->density(unseen).pdf(0.1f, 0.1f), 1.5);
  };
  use([](Field& field) { field.setScale(2.0); });
  use([](Field& field) { field.revert(); });
  use([](Field&) {});
}

TEST(Field, SettingTheScaleReachesPatchesThatHaveViews) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.patches = AWD_PATCHES_SPATIAL;
  desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
  const Ref<Field> field = makeField(desc);
  const uint32_t patch = field->findPatch({0.5f, 0.5f, 0.5f}, {0, 0, 1});
  field->adapt();
  field->makeRoom(patch);
  field->setScale(1e-9);
  run(*field, patch, 100, 48, [](float u, float v) { return 1e-9 * bump(u, v); });
  field->adapt();
  EXPECT_GT(field->density(patch).pdf(0.1f, 0.1f), 1.5);
}

TEST(Field, PatchesOfAHostAreBelowTheirEnd) {
  const Ref<Field> field = makeField(AWD_FIELD_DESC_INIT);
  field->checkPatch(0x7ffffffeu);
  field->checkPatch(0xfffffffeu);
  EXPECT_THROW(field->checkPatch(0x7fffffffu), Error);
  EXPECT_THROW(field->checkPatch(AWD_INVALID_ID), Error);
}

TEST(Field, PdfAgreesWithSample) {
  Uniforms random(42);
  for (const AWDHemisphereMap map : {AWD_MAP_SPHERICAL, AWD_MAP_CONCENTRIC_COSINE}) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.map = map;
    const Ref<Field> field = makeField(desc, "test-linear");
    run(*field, 1, 5000, 43, bump);
    field->adapt();
    const Vec3f normal = normalized(Vec3f{0.3f, -0.5f, -0.8f});
    for (int i = 0; i < 2000; ++i) {
      const double u[3] = {random(), random(), random()};
      const AWDDirectionSample s = field->sample(1, normal, u);
      EXPECT_GT(dot(load(s.direction), normal), 0.0f);
      EXPECT_NEAR(field->pdf(1, normal, load(s.direction)) / s.pdf, 1.0, 2e-2);
    }
    EXPECT_EQ(field->pdf(1, normal, -normal), 0.0f);
  }
}

TEST(Field, RefusesAComponentThatIsNone) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.estimator = AWD_ESTIMATOR_PAPER;
  const Ref<Field> field = makeField(desc);
  const AWDDirectionSample sample = {{0, 0, 1}, 1.0f, {0.5f, 0.5f}, 64, 1.0f};
  EXPECT_THROW(field->record(1, sample, 1.0), Error);
}

// The paper's fixed point: if f has a component's shape, the adapted pdf is proportional to f and
// the estimate of eq. 1 has no variance left.
TEST(Field, PerfectDensityHasNoVariance) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.startLevel = desc.maxLevel = AWD_LEVEL(2);
  desc.tau = 1e-6;
  desc.alpha = -1.0;
  desc.estimator = AWD_ESTIMATOR_PAPER;
  const Ref<Field> field = makeField(desc);
  const auto steps = [](float u, float v) { return 1.0 + int(u * 4) + 4 * int(v * 4); };
  run(*field, 1, 5000, 44, steps);
  field->adapt();
  Uniforms random(45);
  for (int i = 0; i < 1000; ++i) {
    const double u[3] = {random(), random(), random()};
    const AWDDirectionSample s = field->sample(1, {0, 0, 1}, u);
    const double p = field->density(1).pdf(s.square[0], s.square[1]);
    EXPECT_NEAR(steps(s.square[0], s.square[1]) / p, 8.5, 1e-6);
  }
}

/// Where light comes evenly a finer level would tell nothing; nor would one of few samples.
TEST(Field, RefinesPatchesOfContrastAndSamples) {
  constexpr uint32_t kEven = 1, kPeaked = 2, kFew = 3;
  const Ref<Field> field = makeField(AWD_FIELD_DESC_INIT, "haar");
  for (int pass = 0; pass < 3; ++pass) {
    const uint64_t seed = 90 + 10 * static_cast<uint64_t>(pass);
    run(*field, kEven, 4000, seed, [](float u, float) { return 1.0 + double(u); });
    run(*field, kPeaked, 4000, seed + 1, bump);
    run(*field, kFew, 100, seed + 2, bump);
    field->adapt();
  }
  EXPECT_EQ(field->patchInfo(kEven).level, 3u);
  EXPECT_EQ(field->patchInfo(kPeaked).level, 4u);
  EXPECT_EQ(field->patchInfo(kFew).level, 3u);
}

}  // namespace
}  // namespace awd
