// SPDX-License-Identifier: Apache-2.0
#include "basis_use.h"

#include <algorithm>
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
  for (int pass = 0; pass < 2; ++pass) {
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

/// In two dimensions; what was drawn is bit for bit what the pdf says.
void useDensity(AWDDevice device, const AWDDensityAxis& axis, AWDDensityStructure structure,
                AWDSampler sampler) {
  const AWDDensityAxis axes[] = {axis, axis};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 2;
  desc.structure = structure;
  desc.axes = axes;
  desc.sampler = sampler;
  AWDDensity density = nullptr;
  require(awdNewDensity(device, &desc, &density) == AWD_SUCCESS,
          "a family was accepted, but no density can be made with it");
  const double edges[] = {0.0, 0.5, 0.3, 1.0 - 0x1p-53};
  constexpr std::size_t kCount = 64;
  double uniforms[3 * kCount], points[2 * kCount], pdfs[kCount], again[kCount], values[kCount];
  uint32_t components[kCount];
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t each = sampler == AWD_SAMPLER_COMPONENT ? 3 : 2;
    for (std::size_t i = 0; i < kCount; ++i) {
      for (std::size_t k = 0; k < each; ++k) uniforms[i * each + k] = edges[i >> 2 * k & 3];
      values[i] = std::ldexp(1.0, static_cast<int>(i % 60) - 30);
    }
    require(awdSampleDensity(density, kCount, uniforms, points, pdfs, components) == AWD_SUCCESS,
            "no points");
    for (const double x : points) require(x >= 0.0 && x < 1.0, "a point lies outside");
    for (const double pdf : pdfs) require(std::isfinite(pdf) && pdf > 0.0, "a density is none");
    require(awdGetDensityPdf(density, kCount, points, again) == AWD_SUCCESS, "no densities");
    require(std::memcmp(pdfs, again, sizeof pdfs) == 0, "two densities at one point");
    require(awdRecordDensity(density, kCount, points, pdfs,
                             sampler == AWD_SAMPLER_COMPONENT ? components : nullptr,
                             values) == AWD_SUCCESS,
            "no record");
    require(awdAdaptDensity(density, nullptr) == AWD_SUCCESS, "no adapt");
    double integral = 0.0;
    require(awdGetDensityIntegral(density, nullptr, nullptr, &integral) == AWD_SUCCESS,
            "no integral");
    require(std::abs(integral - 1.0) < 1e-6, "the density does not integrate to 1");
  }
  awdReleaseDensity(density);
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
    // Coefficients of a level go by the square of its functions.
    fieldDesc.startLevel = AWD_LEVEL(table.family().minLevel);
    fieldDesc.maxLevel = AWD_LEVEL(std::min(table.family().maxLevel, table.family().minLevel + 2));
    AWDField field = nullptr;
    if (table.family().count(table.family().minLevel) > 256) {
      awdReleaseDevice(device);
      return outcome;
    }
    outcome.used = awdNewField(device, &fieldDesc, &field) == AWD_SUCCESS;
    require(outcome.used, "a family was accepted, but no field can be made with it");
    useField(field);
    awdReleaseField(field);
    const AWDDensityAxis axis = {fieldDesc.basis, fieldDesc.startLevel, fieldDesc.maxLevel};
    useDensity(device, axis, AWD_STRUCTURE_GRID, AWD_SAMPLER_INVERSE_CDF);
    useDensity(device, axis, AWD_STRUCTURE_GRID, AWD_SAMPLER_COMPONENT);
    if (table.family().flags & AWD_BASIS_NESTED) {
      useDensity(device, axis, AWD_STRUCTURE_TREE, AWD_SAMPLER_INVERSE_CDF);
    }
  }
  awdReleaseDevice(device);
  return outcome;
}

}  // namespace fuzz
