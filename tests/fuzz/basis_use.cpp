// SPDX-License-Identifier: Apache-2.0
#include "basis_use.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "awd/awd.h"
#include "basis_table.h"

namespace fuzz {

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s; last message: %s\n", what, awdGetLastErrorMessage());
  std::abort();
}

/// Draws, looks and learns, with values over many magnitudes.
void useField(AWDField field) {
  const float up[3] = {0.0f, 0.0f, 1.0f};
  const double edges[] = {0.0, 0.5, 0.3, 1.0 - 0x1p-53};
  for (int pass = 0; pass < 3; ++pass) {
    for (int i = 0; i < 64; ++i) {
      const double uniforms[3] = {edges[i % 4], edges[i / 4 % 4], edges[i / 16 % 4]};
      AWDDirectionSample sample = {};
      require(awdSampleField(field, 0, up, uniforms, &sample) == AWD_SUCCESS, "no sample");
      require(std::isfinite(sample.pdf) && sample.pdf >= 0.0f, "the pdf of a sample is none");
      require(sample.square[0] >= 0.0f && sample.square[0] <= 1.0f && sample.square[1] >= 0.0f &&
                  sample.square[1] <= 1.0f,
              "a sample lies outside the square");
      float pdf = -1.0f;
      require(awdGetFieldPdf(field, 0, up, sample.direction, &pdf) == AWD_SUCCESS, "no pdf");
      require(std::isfinite(pdf) && pdf >= 0.0f, "a pdf is none");
      require(awdRecordField(field, 0, &sample, std::ldexp(1.0, i % 60 - 30)) == AWD_SUCCESS,
              "no record");
    }
    require(awdAdaptField(field, nullptr) == AWD_SUCCESS, "no adapt");
  }
  float pixels[16];
  require(awdGetPatchPdf(field, 0, 4, pixels, 0) == AWD_SUCCESS, "no image");
  for (const float pixel : pixels) {
    require(std::isfinite(pixel) && pixel >= 0.0f, "a pixel is none");
  }
}

}  // namespace

Outcome tryTable(const uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const BasisTable table(bytes);
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.threads = 1;
  deviceDesc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
  AWDDevice device = nullptr;
  require(awdNewDevice(&deviceDesc, &device) == AWD_SUCCESS, "no device");

  Outcome outcome = {table.honest(), false, false};
  const AWDResult result = awdRegisterBasisModule(device, &table.module());
  outcome.accepted = result == AWD_SUCCESS;
  if (!outcome.accepted) {
    require(result == AWD_ERROR_PLUGIN_SELF_TEST, "refused by another code");
    require(std::strlen(awdGetLastErrorMessage()) > std::strlen("awdRegisterBasisModule: "),
            "refused without a word");
  } else {
    AWDFieldDesc fieldDesc = AWD_FIELD_DESC_INIT;
    fieldDesc.basis = table.family().name;
    AWDField field = nullptr;
    outcome.used = awdNewField(device, &fieldDesc, &field) == AWD_SUCCESS;
    require(outcome.used, "a family was accepted, but no field can be made with it");
    useField(field);
    awdReleaseField(field);
  }
  awdReleaseDevice(device);
  return outcome;
}

}  // namespace fuzz
