// SPDX-License-Identifier: Apache-2.0
// Settings that no call can take: numbers outside of enumerations and ranges, cameras that see
// nothing, schedules without samples, bases that are not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>

#include "input/objects.h"

namespace {

using namespace awdtest;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr AWDResult kInvalid = AWD_ERROR_INVALID_ARGUMENT;

using Settings = Arguments;

TEST_F(Settings, UnknownEnumerators) {
  for (const int32_t bad : {-1, 5, 77}) {
    AWDRenderDesc desc = desc_;
    desc.guide = bad;
    expectNoRender(desc, {"guide", std::to_string(bad)});
    desc = desc_;
    desc.direct = bad;
    expectNoRender(desc, {"direct", std::to_string(bad)});
    desc = desc_;
    desc.roulette = bad;
    expectNoRender(desc, {"roulette", std::to_string(bad)});
    desc = desc_;
    desc.combination = bad;
    expectNoRender(desc, {"combination", std::to_string(bad)});
    desc = desc_;
    desc.lights = bad;
    expectNoRender(desc, {"lights", std::to_string(bad)});
    desc = desc_;
    desc.preset = bad;
    expectNoRender(desc, {"preset", std::to_string(bad)});
    AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.preset = bad;
    AWDField field;
    expectFailure(awdNewField(device_, &fieldDesc, &field), kInvalid,
                  {"preset", std::to_string(bad)});
    fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.map = bad;
    expectFailure(awdNewField(device_, &fieldDesc, &field), kInvalid, {"map", std::to_string(bad)});
    fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.target = bad;
    expectFailure(awdNewField(device_, &fieldDesc, &field), kInvalid,
                  {"target", std::to_string(bad)});
    fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.patches = bad;
    expectFailure(awdNewField(device_, &fieldDesc, &field), kInvalid,
                  {"patches", std::to_string(bad)});
    expectFailure(awdReadFilm(render_, bad, floats_, 0, 0), kInvalid,
                  {"layer", std::to_string(bad)});
  }
  expectFailure(awdReadFilm(render_, 0, floats_, 0, 0), kInvalid, {"layer"});
  AWDRenderDesc desc = desc_;  // known, but not of a render
  desc.combination = AWD_COMBINE_CROSS_VARIANCE;
  expectNoRender(desc, {"combination"});
}

TEST_F(Settings, LightsAndSplittingThatCannotBe) {
  AWDRenderDesc desc = desc_;
  desc.maxSplit = 65;
  expectNoRender(desc, {"maxSplit", "65", "64"});
  desc = desc_;
  desc.lights = AWD_LIGHTS_LEARNED;
  desc.guide = AWD_GUIDE_COSINE;
  expectNoRender(desc, {"lights", "AWD_GUIDE_ADAPTIVE"});
  // A field that knows of other lights than the scene has.
  desc.guide = AWD_GUIDE_ADAPTIVE;
  AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
  fieldDesc.lightCount = 7;
  Field field;
  must(awdNewSceneField(scene_, &fieldDesc, field.out()));
  AWDRender render;
  expectFailure(awdNewRender(scene_, field, &desc, &render), kInvalid, {"lights", "lightCount 7"});
  // By default such a field is of use for all else.
  desc.lights = AWD_LIGHTS_DEFAULT;
  must(awdNewRender(scene_, field, &desc, &render));
  must(awdRenderPass(render, 2, nullptr));
  awdReleaseRender(render);
  // Before a commit there are no lights to know of.
  Scene empty;
  must(awdNewScene(device_, empty.out()));
  expectFailure(awdNewSceneField(empty, nullptr, field.out()), AWD_ERROR_INVALID_OPERATION,
                {"commit"});
}

TEST_F(Settings, StructsOfAnotherVersion) {
  AWDRenderDesc desc = desc_;
  desc.structSize = 0;
  expectNoRender(desc, {"structSize", "AWD_RENDER_DESC_INIT"});

  struct Longer {
    AWDRenderDesc known;
    uint64_t later;
  } longer = {desc_, 0};
  longer.known.structSize = sizeof longer;
  Render render;
  must(awdNewRender(scene_, nullptr, &longer.known, render.out()));
  longer.later = 1;
  expectNoRender(longer.known, {std::to_string(sizeof(AWDRenderDesc))});

  // An output as a former version knew it: what lies behind is not written.
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  info.structSize = offsetof(AWDSceneInfo, lights);
  info.lights = 12345;
  must(awdGetSceneInfo(scene_, &info));
  EXPECT_GT(info.triangles, 0u);
  EXPECT_EQ(info.lights, 12345u);
}

TEST_F(Settings, DegenerateCameras) {
  const auto spoil = [&](const std::function<void(AWDCamera&)>& change, const std::string& name) {
    AWDCamera camera = camera_;
    change(camera);
    AWDRenderDesc desc = desc_;
    desc.camera = &camera;
    expectNoRender(desc, {name});
  };
  for (const float bad : {kNaN, kInfinity}) {
    spoil([&](AWDCamera& c) { c.eye[1] = bad; }, "eye");
    spoil([&](AWDCamera& c) { c.lookDir[2] = bad; }, "lookDir");
    spoil([&](AWDCamera& c) { c.up[0] = bad; }, "up");
  }
  spoil([](AWDCamera& c) { c.eye[2] = 3e38f; }, "eye");  // Embree would end the program
  spoil([](AWDCamera& c) { c.lookDir[0] = c.lookDir[1] = c.lookDir[2] = 0.0f; }, "lookDir");
  spoil([](AWDCamera& c) { c.up[0] = c.up[1] = c.up[2] = 0.0f; }, "up");
  spoil([](AWDCamera& c) { std::copy(c.lookDir, c.lookDir + 3, c.up); }, "up");
  spoil(
      [](AWDCamera& c) {
        for (size_t i = 0; i < 3; ++i) c.up[i] = -7.0f * c.lookDir[i];
      },
      "up");
  for (const float bad : {0.0f, -0.5f, kNaN, kInfinity}) {
    spoil([&](AWDCamera& c) { c.tanHalfFovX = bad; }, "tanHalfFovX");
  }
  for (const uint32_t bad : {0u, 65537u, 0xFFFFFFFFu}) {
    spoil([&](AWDCamera& c) { c.width = bad; }, std::to_string(bad) + " x 4");
    spoil([&](AWDCamera& c) { c.height = bad; }, "4 x " + std::to_string(bad));
  }
  spoil([](AWDCamera& c) { c.structSize = 1; }, "structSize");
  AWDRenderDesc desc = desc_;
  desc.camera = nullptr;
  expectNoRender(desc, {"camera", "NULL"});
}

/// Long vectors and a slanted up are fine.
TEST_F(Settings, CamerasAreMadeOrthonormal) {
  AWDCamera sloppy = camera_;
  const Film exact = renderFilm(scene_, desc_, {4});
  for (size_t i = 0; i < 3; ++i) {
    sloppy.up[i] = 1024.0f * sloppy.up[i];
    sloppy.lookDir[i] *= 0x1p-30f;
  }
  AWDRenderDesc desc = desc_;
  desc.camera = &sloppy;
  const Film film = renderFilm(scene_, desc, {4});
  for (size_t i = 0; i < film.radiance.size(); ++i) {
    EXPECT_NEAR(film.radiance[i], exact.radiance[i], 1e-3f + 1e-3f * exact.radiance[i]);
  }
}

TEST_F(Settings, RenderSettingsOutOfRange) {
  AWDRenderDesc desc = desc_;
  desc.shadowRays = 1025;
  expectNoRender(desc, {"shadowRays", "1025", "1024"});
  desc.shadowRays = 1024;
  Render render;
  must(awdNewRender(scene_, nullptr, &desc, render.out()));
}

TEST_F(Settings, OnlyAnAdaptiveRenderHasAField) {
  AWDField field = field_;
  desc_.guide = AWD_GUIDE_COSINE;
  must(awdGetRenderField(newRender(scene_, desc_, field_), &field));
  EXPECT_EQ(field, nullptr);
  must(awdGetRenderField(render_, &field));
  EXPECT_EQ(field, field_);
  awdReleaseField(field);
}

TEST_F(Settings, Seeds) {
  for (const uint64_t seed : {uint64_t{0}, ~uint64_t{0}, uint64_t{1} << 63}) {
    desc_.seed = seed;
    const Film film = renderFilm(scene_, desc_, {2, 2});
    EXPECT_EQ(film.samplesPerPixel, 4u);
    for (const float value : film.radiance) EXPECT_TRUE(std::isfinite(value) && value >= 0.0f);
  }
}

TEST_F(Settings, SchedulesWithoutSamples) {
  expectFailure(awdRenderPass(render_, 0, nullptr), kInvalid, {"samplesPerPixel", "0"});
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  const uint32_t passes[] = {1, 0, 1};
  schedule.samplesPerPass = passes;
  schedule.passCount = 3;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"samplesPerPass[1]"});
  schedule.passCount = 0;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"passCount"});
  schedule = AWD_SCHEDULE_INIT;
  schedule.passCount = 3;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"samplesPerPass"});
  for (const double bad : {-1.0, HUGE_VAL, std::nan("")}) {
    schedule = AWD_SCHEDULE_INIT;
    schedule.seconds = bad;
    expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"seconds"});
    schedule = AWD_SCHEDULE_INIT;
    schedule.error = bad;
    expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"error"});
  }
  schedule = AWD_SCHEDULE_INIT;
  schedule.seconds = 1.0;
  schedule.samplesPerPass = passes;
  schedule.passCount = 1;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"seconds", "samplesPerPass"});
  schedule.seconds = 0.0;
  schedule.error = 0.1;
  expectFailure(awdRenderPasses(render_, &schedule), kInvalid, {"error", "samplesPerPass"});
  uint32_t count = 77;
  must(awdGetPassCount(render_, &count));
  EXPECT_EQ(count, 0u) << "a refused schedule runs nothing";
  AWDPassStatistics figures = AWD_PASS_STATISTICS_INIT;
  expectFailure(awdGetPassStatistics(render_, 0, &figures), kInvalid, {"index", "0"});
  AWDRenderError error = AWD_RENDER_ERROR_INIT;
  expectFailure(awdGetRenderError(render_, &error), AWD_ERROR_INVALID_OPERATION, {"0 samples"});
  expectFailure(awdGetPixelPatch(render_, 4, 0, &count), kInvalid, {"(4, 0)", "4 x 4"});
  expectFailure(awdGetPixelPatch(render_, 0, 4, &count), kInvalid, {"(0, 4)", "4 x 4"});
}

TEST_F(Settings, QualitiesThatAreNone) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  for (const AWDQuality bad : {-1, 0, 5, 77}) {
    expectFailure(awdGetQualitySchedule(bad, &schedule), kInvalid,
                  {"quality", std::to_string(bad)});
  }
  expectFailure(awdGetQualitySchedule(AWD_QUALITY_DRAFT, nullptr), kInvalid, {"schedule", "NULL"});
  schedule.structSize = 0;
  expectFailure(awdGetQualitySchedule(AWD_QUALITY_DRAFT, &schedule), kInvalid,
                {"structSize", "AWD_SCHEDULE_INIT"});
}

/// 0 stands for the preset's schedule; a total is divided without loss.
TEST_F(Settings, SchedulesByTheLibrary) {
  AWDRenderDesc desc = desc_;
  desc.preset = AWD_PRESET_PAPER;
  const Render paper = newRender(scene_, desc);
  must(awdRenderPasses(paper, nullptr));
  uint64_t samples = 0;
  must(awdGetFilmInfo(paper, nullptr, nullptr, &samples));
  EXPECT_EQ(samples, 100u);
  uint32_t count = 0;
  must(awdGetPassCount(paper, &count));
  EXPECT_EQ(count, 4u);
  for (const uint32_t total : {1u, 2u, 3u, 7u, 100u, 1000u}) {
    for (const AWDPreset preset : {AWD_PRESET_DEFAULT, AWD_PRESET_PAPER}) {
      desc.preset = preset;
      const Render render = newRender(scene_, desc);
      AWDSchedule schedule = AWD_SCHEDULE_INIT;
      schedule.totalSamples = total;
      must(awdRenderPasses(render, &schedule));
      must(awdGetFilmInfo(render, nullptr, nullptr, &samples));
      EXPECT_EQ(samples, total);
    }
  }
}

TEST_F(Settings, FieldSettingsOutOfRange) {
  AWDField field;
  const auto refused = [&](const AWDFieldDesc& desc, const std::vector<std::string>& parts) {
    expectFailure(awdNewField(device_, &desc, &field), kInvalid, parts);
  };
  for (const double bad : {1.5, std::nan(""), HUGE_VAL}) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.tau = bad;
    refused(desc, {"tau"});
  }
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.startLevel = AWD_LEVEL(4);
  desc.maxLevel = AWD_LEVEL(3);
  refused(desc, {"startLevel", "maxLevel"});
  desc.maxLevel = desc.startLevel = AWD_LEVEL(60);
  refused(desc, {"evel"});
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    expectFailure(awdSetFieldScale(field_, bad), kInvalid, {"magnitude"});
  }
  for (const uint32_t bad : {0u, 16385u}) {
    expectFailure(awdGetPatchPdf(field_, 0, bad, floats_, 0), kInvalid, {"n", "16384"});
    AWDImage image;
    expectFailure(awdNewPatchImage(field_, 0, bad, &image), kInvalid, {"n", "16384"});
  }
  double one;
  expectFailure(awdGetPatchCoefficients(field_, 0, &one, 1), kInvalid, {"capacity", "1"});
}

TEST_F(Settings, UnknownBasisNamesThePathsTried) {
  const char* folder = "/nonexistent/bases";
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.basisPaths = &folder;
  deviceDesc.basisPathCount = 1;
  const Device device = newDevice(&deviceDesc);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "nonesuch";
  AWDField field;
  expectFailure(awdNewField(device, &desc, &field), AWD_ERROR_UNSUPPORTED,
                {"nonesuch", "/nonexistent/bases", "awd/bases-1", "haar"});
  for (const char* odd : {"", "Haar", "../haar", "haar "}) {
    desc.basis = odd;
    EXPECT_NE(awdNewField(device, &desc, &field), AWD_SUCCESS) << odd;
  }
}

TEST_F(Settings, ModulesThatAreNone) {
  expectFailure(awdLoadBasisModule(device_, "/nonexistent/module.so"), AWD_ERROR_PLUGIN_LOAD,
                {"/nonexistent/module.so"});
  expectFailure(awdLoadBasisModule(device_, "relative/module.so"), kInvalid, {"absolute"});
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  const char* relative = "relative";
  desc.basisPaths = &relative;
  desc.basisPathCount = 1;
  AWDDevice device;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"basisPaths", "relative"});
  desc.basisPaths = nullptr;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"basisPaths"});
  size_t count = 0;
  must(awdGetBasisCount(device_, &count));
  AWDBasisInfo info = AWD_BASIS_INFO_INIT;
  expectFailure(awdGetBasisInfo(device_, count, &info), kInvalid, {"index"});
}

TEST_F(Settings, HalfAnAllocator) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.alloc = [](void*, size_t, size_t) -> void* { return nullptr; };
  AWDDevice device;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"free"});
  desc = AWD_DEVICE_DESC_INIT;
  desc.free = [](void*, void*, size_t, size_t) {};
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"alloc"});
  desc = AWD_DEVICE_DESC_INIT;
  desc.flags = 0x100u;
  expectFailure(awdNewDevice(&desc, &device), kInvalid, {"flags"});
}

TEST_F(Settings, ResultsHaveNames) {
  for (AWDResult code = AWD_SUCCESS; code >= AWD_ERROR_PLUGIN_SELF_TEST; --code) {
    EXPECT_STRNE(awdGetResultString(code), "") << code;
  }
  EXPECT_NE(awdGetResultString(12345), nullptr);
  EXPECT_NE(awdGetResultString(-12345), nullptr);
}

}  // namespace
