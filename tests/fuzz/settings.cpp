// SPDX-License-Identifier: Apache-2.0
// Cameras, renders, schedules, fields, densities and queries with any settings. What is accepted
// must work.
#include <algorithm>
#include <cmath>

#include "bounded_device.h"
#include "field_use.h"
#include "random_structs.h"
#include "render_use.h"
#include "require.h"
#include "support/random.h"
#include "support/scenes.h"
#include "target.h"

namespace fuzz {

namespace {

using awdtest::Field;
using awdtest::Render;
using awdtest::Scene;

AWDScene scene(uint32_t number) {
  AWDDevice device = BoundedDevice::shared().get();
  static const Scene scenes[] = {awdtest::lampRoom().commit(device),
                                 awdtest::sevenLampRoom().commit(device),
                                 awdtest::SceneBuilder().commit(device)};
  return scenes[number % 3];
}

std::initializer_list<AWDResult> refusals() {
  static constexpr std::initializer_list<AWDResult> kAll = {
      AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_UNSUPPORTED};
  return kAll;
}

/// Within a few samples a pixel.
AWDSchedule readSchedule(Bytes& bytes, uint32_t* passes) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.structSize = structSize(bytes, sizeof schedule);
  const uint32_t what = bytes.byte();
  schedule.totalSamples = what & 1 ? bytes.below(20) : 0;
  for (int i = 0; i < 4; ++i) passes[i] = bytes.below(4);
  if (what & 2) schedule.samplesPerPass = passes;
  if (what & 4) schedule.passCount = bytes.below(5);
  if (what & 8) schedule.error = bytes.real();
  if (what & 16) schedule.seconds = bytes.below(4) ? 1e-3 : bytes.real();
  schedule.resume = choice(bytes, 2);
  if (what & 32) schedule.maxPasses = bytes.integer();
  return schedule;
}

void tryRender(const Bounds&, Bytes& bytes) {
  const uint32_t which = bytes.byte();
  float powers[AWD_MOST_FIELD_LIGHTS];
  Field field;
  if (which & 4) {
    const AWDFieldDesc desc = readFieldDesc(bytes, powers);
    if (!oneOf(awdNewSceneField(scene(which), &desc, field.out()), refusals(), "field")) return;
  }
  const AWDCamera camera = readCamera(bytes);
  const AWDRenderDesc desc = readRenderDesc(bytes, &camera);
  Render render;
  if (!oneOf(awdNewRender(scene(which), field, &desc, render.out()), refusals(), "render")) return;
  uint32_t passes[4];
  const AWDSchedule schedule = readSchedule(bytes, passes);
  uint32_t width = 0, height = 0, samples = 0;
  require(awdGetFilmInfo(render, &width, &height, nullptr) == AWD_SUCCESS, "no size");
  const std::initializer_list<AWDResult> ends = {AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_CANCELLED,
                                                 AWD_ERROR_OUT_OF_MEMORY,
                                                 AWD_ERROR_INVALID_OPERATION};
  if (uint64_t{width} * height > 4096) return;
  oneOf(awdRenderPass(render, bytes.below(3), nullptr), ends, "pass");
  oneOf(awdRenderPasses(render, &schedule), ends, "passes");
  oneOf(awdRenderPassPart(render, &schedule, bytes.integer(), bytes.integer(), &samples), ends,
        "part");
  lookAt(render);
}

/// Queries with any numbers: each is answered with sense, or refused.
void query(AWDField field, Bytes& bytes) {
  const uint32_t patch = bytes.below(4) ? bytes.below(4) : bytes.integer();
  const float normal[3] = {real32(bytes), real32(bytes), real32(bytes)};
  const double uniforms[3] = {bytes.real(), bytes.real(), bytes.real()};
  AWDDirectionSample sample = {};
  const std::initializer_list<AWDResult> wrong = {
      AWD_ERROR_INVALID_ARGUMENT, AWD_ERROR_INVALID_OPERATION, AWD_ERROR_OUT_OF_MEMORY};
  if (oneOf(awdSampleField(field, patch, normal, uniforms, &sample), wrong, "sample")) {
    require(isDensity(sample.pdf), "the pdf of a sample is none");
  }
  float value = 0.0f, chance = 0.0f;
  double rest = 0.0;
  uint32_t light = 0, found = 0;
  if (oneOf(awdGetFieldPdf(field, patch, normal, normal, &value), wrong, "pdf")) {
    require(isDensity(value), "a pdf is none");
  }
  oneOf(awdFindPatch(field, normal, sample.direction, &found), wrong, "find");
  if (bytes.below(2)) {
    sample = {{real32(bytes), real32(bytes), real32(bytes)},
              real32(bytes),
              {real32(bytes), real32(bytes)},
              bytes.below(2) ? AWD_INVALID_ID : bytes.integer(),
              real32(bytes)};
  }
  oneOf(awdRecordField(field, patch, &sample, bytes.real()), wrong, "record");
  if (oneOf(awdMapDirection(field, patch, normal, sample.direction, &sample), wrong, "map")) {
    require(isDensity(sample.pdf), "the pdf of a direction is none");
  }
  AWDPathVertex vertices[2] = {};
  for (AWDPathVertex& vertex : vertices) {
    vertex.patch = bytes.below(4) ? patch : bytes.integer();
    vertex.continuation = real32(bytes);
    vertex.sample = sample;
    vertex.emitted[0] = real32(bytes);
    vertex.direct[1] = real32(bytes);
    vertex.scattering[2] = real32(bytes);
  }
  float radiance[3];
  oneOf(awdRecordFieldPath(field, 2, vertices, normal, radiance), wrong, "path");
  if (oneOf(awdChooseLight(field, patch, uniforms[0], &light, &chance, &rest), wrong, "choose")) {
    require(chance > 0.0f && chance <= 1.0f && rest >= 0.0 && rest < 1.0, "a choice is none");
  }
  light = bytes.integer();
  if (oneOf(awdGetLightChance(field, patch, light, &chance), wrong, "chance")) {
    require(chance >= 0.0f && chance <= 1.0f, "a chance is none");
  }
  oneOf(awdRecordLight(field, patch, light, bytes.real()), wrong, "light");
  if (oneOf(awdGetContinuation(field, patch, real32(bytes), real32(bytes), bytes.integer(), &value),
            wrong, "continuation")) {
    require(value == -1.0f || (value > 0.0f && value <= 64.0f), "a number of rays is none");
  }
  oneOf(awdSetFieldScale(field, bytes.real()), wrong, "scale");
}

void tryField(const Bounds& bounds, Bytes& bytes) {
  float powers[AWD_MOST_FIELD_LIGHTS];
  const AWDFieldDesc desc = readFieldDesc(bytes, powers);
  Field field;
  if (!oneOf(awdNewField(bounds.device(), &desc, field.out()), refusals(), "field")) return;
  for (int i = 0; i < 4 && !bytes.empty(); ++i) query(field, bytes);
  useField(bounds, field);
}

void tryDensity(const Bounds& bounds, Bytes& bytes) {
  AWDDensityAxis axes[AWD_MAX_DIMENSIONS] = {};
  const AWDDensityDesc desc = readDensityDesc(bytes, axes);
  AWDDensity density = nullptr;
  if (!oneOf(awdNewDensity(bounds.device(), &desc, &density), refusals(), "density")) return;
  AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
  require(awdGetDensityInfo(density, &info) == AWD_SUCCESS, "no info");
  const std::initializer_list<AWDResult> wrong = {AWD_ERROR_INVALID_ARGUMENT,
                                                  AWD_ERROR_INVALID_OPERATION,
                                                  AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_CANCELLED};
  awdtest::Random random(2);
  for (int pass = 0; pass < 2; ++pass) {
    constexpr size_t kCount = 8;
    double uniforms[kCount * (AWD_MAX_DIMENSIONS + 1)], points[kCount * AWD_MAX_DIMENSIONS];
    double pdfs[kCount], values[kCount];
    uint32_t components[kCount];
    for (double& u : uniforms) u = random.uniform();
    if (pass) uniforms[0] = bytes.real();
    if (oneOf(awdSampleDensity(density, kCount, uniforms, points, pdfs, components), wrong,
              "sample")) {
      for (const double pdf : pdfs) require(isDensity(pdf) && pdf > 0.0, "a pdf is none");
      for (double& value : values) value = bytes.real();
      if (pass) pdfs[0] = bytes.real(), points[1] = bytes.real(), components[2] = bytes.integer();
      oneOf(awdRecordDensity(density, kCount, points, pdfs,
                             info.sampler == AWD_SAMPLER_COMPONENT ? components : nullptr, values),
            wrong, "record");
    }
    if (bytes.below(4) == 0) oneOf(awdRefineDensity(density, bytes.integer()), wrong, "refine");
    oneOf(awdAdaptDensity(density, nullptr), wrong, "adapt");
    double integral = 1.0;
    oneOf(awdGetDensityIntegral(density, nullptr, nullptr, &integral), {AWD_ERROR_OUT_OF_MEMORY},
          "integral");
    require(std::abs(integral - 1.0) < 1e-6, "p does not integrate to 1");
  }
  awdReleaseDensity(density);
}

void run(const uint8_t* data, std::size_t size) {
  scene(0);
  // A pass of any size is cut short.
  const Bounds bounds(std::size_t{64} << 20, 40);
  Bytes bytes(data, size);
  switch (bytes.below(3)) {
    case 0:
      tryRender(bounds, bytes);
      break;
    case 1:
      tryField(bounds, bytes);
      break;
    default:
      tryDensity(bounds, bytes);
  }
}

std::vector<Input> seeds() {
  std::vector<Input> result;
  awdtest::Random random(7);
  for (uint8_t i = 0; i < 36; ++i) {
    Input input(20 + random.bits() % 120);
    for (uint8_t& byte : input) byte = static_cast<uint8_t>(random.bits() % (i % 2 ? 256 : 40));
    input[0] = i;
    result.push_back(std::move(input));
  }
  return result;
}

}  // namespace

const Target kSettings = {"settings", run, seeds};

}  // namespace fuzz
