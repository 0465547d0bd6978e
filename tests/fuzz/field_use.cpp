// SPDX-License-Identifier: Apache-2.0
#include "field_use.h"

#include <cmath>

#include "require.h"
#include "support/random.h"

namespace fuzz {

using awdtest::Field;
using awdtest::Random;

Input savedField(AWDField field) {
  size_t size = 0;
  require(awdSaveField(field, nullptr, 0, &size) == AWD_SUCCESS, "a field can't be saved");
  Input bytes(size);
  require(awdSaveField(field, bytes.data(), size, &size) == AWD_SUCCESS, "a field can't be saved");
  return bytes;
}

void recordField(AWDField field, int samples, uint64_t seed) {
  Random random(seed);
  const double edges[] = {0.0, 0.5, 1.0 - 0x1p-53};
  for (int i = 0; i < samples; ++i) {
    const float normal[3] = {0.0f, 0.0f, i % 2 ? 1.0f : -1.0f};
    const float position[3] = {static_cast<float>(random.uniform()),
                               static_cast<float>(random.uniform()), 0.25f};
    uint32_t patch = static_cast<uint32_t>(random.bits() % 3);
    uint32_t found = 0;
    if (oneOf(awdFindPatch(field, position, normal, &found), {AWD_ERROR_INVALID_OPERATION},
              "find")) {
      patch = found;
    }
    double uniforms[3];
    for (double& u : uniforms) {
      u = random.bits() % 8 ? random.uniform() : edges[random.bits() % 3];
    }
    AWDDirectionSample sample = {};
    require(awdSampleField(field, patch, normal, uniforms, &sample) == AWD_SUCCESS, "no sample");
    require(isDensity(sample.pdf) && sample.pdf > 0.0f, "the pdf of a sample is none");
    for (const float x : sample.square) require(x >= 0.0f && x <= 1.0f, "outside the square");
    float pdf = -1.0f;
    require(awdGetFieldPdf(field, patch, normal, sample.direction, &pdf) == AWD_SUCCESS, "no pdf");
    require(isDensity(pdf), "a pdf is none");
    if (!oneOf(awdRecordField(field, patch, &sample, std::ldexp(random.uniform(), i % 20 - 10)),
               {AWD_ERROR_OUT_OF_MEMORY}, "record")) {
      return;
    }
    float mean = 0.0f, rays = 0.0f, chance = 0.0f, magnitude = 0.0f;
    require(awdGetPatchMean(field, patch, &mean) == AWD_SUCCESS && !std::isnan(mean), "no mean");
    require(
        awdGetContinuation(field, patch, 0.5f, 1.0f, 0, &rays) == AWD_SUCCESS && !std::isnan(rays),
        "no continuation");
    uint32_t light = 0;
    double rest = 0.0;
    if (!oneOf(awdChooseLight(field, patch, uniforms[2], &light, &chance, &rest),
               {AWD_ERROR_INVALID_OPERATION}, "choose")) {
      continue;
    }
    require(chance > 0.0f && chance <= 1.0f && rest >= 0.0 && rest < 1.0, "a choice is none");
    require(awdRecordLight(field, patch, light, uniforms[0]) == AWD_SUCCESS, "no light record");
    require(awdGetPatchLight(field, patch, &magnitude) == AWD_SUCCESS && !std::isnan(magnitude),
            "no magnitude");
  }
}

void useField(const Bounds& bounds, AWDField field) {
  const auto loaded = [&](Field& copy) {
    const Input bytes = savedField(field);
    if (!oneOf(awdLoadField(bounds.device(), bytes.data(), bytes.size(), copy.out()),
               {AWD_ERROR_OUT_OF_MEMORY}, "what was saved")) {
      return false;
    }
    require(savedField(copy) == bytes, "saved again it is another");
    return true;
  };
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  require(awdGetFieldStatistics(field, &figures) == AWD_SUCCESS, "no statistics");
  Field copy;
  if (loaded(copy)) {
    recordField(copy, 12, 3);
    oneOf(awdMergeField(field, copy), {AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_INVALID_ARGUMENT},
          "merge");
    oneOf(awdSetFieldScale(copy, 3.0), {AWD_ERROR_OUT_OF_MEMORY}, "scale");
    recordField(copy, 12, 4);
    require(awdRevertField(copy) == AWD_SUCCESS, "no way back");
    recordField(copy, 12, 5);
    copy = Field();
  }
  for (int pass = 0; pass < 2; ++pass) {
    recordField(field, 24, 7);
    require(awdMarkField(field) == AWD_SUCCESS, "no mark");
    recordField(field, 4, 9);
    if (pass) require(awdRevertField(field) == AWD_SUCCESS, "no way back");
    if (!oneOf(awdAdaptField(field, nullptr), {AWD_ERROR_OUT_OF_MEMORY, AWD_ERROR_CANCELLED},
               "adapt")) {
      break;
    }
  }
  uint32_t patch = 0;
  size_t count = 0;
  require(awdGetFieldPatches(field, nullptr, 0, &count) == AWD_SUCCESS, "no patches");
  if (count > 0) awdGetFieldPatches(field, &patch, 1, &count);
  float pixels[16];
  require(awdGetPatchPdf(field, patch, 4, pixels, 0) == AWD_SUCCESS, "no picture");
  for (const float pixel : pixels) require(isDensity(pixel), "a pixel is none");
  loaded(copy);
}

}  // namespace fuzz
