// SPDX-License-Identifier: Apache-2.0
// What `awd render` takes from the command line.
#pragma once

#include <CLI/App.hpp>
#include <optional>
#include <string>
#include <vector>

#include "device.h"
#include "pdf_request.h"
#include "schedule.h"

namespace command {

struct RenderOptions {
  std::string scene, output;
  std::optional<std::string> camera, json, basis, spp, refitSolver, fieldIn, fieldOut, quality,
      checkpoint;
  std::optional<uint32_t> width, height, level, passes, samples;
  std::optional<double> seconds, error, memory;
  std::string guide = "adaptive", preset = "default", estimator = "default";
  std::string points = "default", direct = "default", lights = "default";
  uint64_t seed = 0;
  uint32_t shadowRays = 0;  // 0: the preset's
  uint32_t maxSplit = 0;    // likewise
  std::vector<std::string> pdfTexts;
  DeviceOptions device;

  /// Made of the texts above by finish().
  Schedule schedule;
  std::vector<PdfRequest> pdfs;

  void describe(CLI::App& command);
  /// Checks what concerns several options. Throws a UsageError.
  void finish();

  bool isAdaptive() const { return guide == "adaptive"; }
  AWDGuide guideValue() const;
  AWDPreset presetValue() const;
  AWDEstimator estimatorValue() const;
  AWDPoints pointsValue() const;
  AWDDirectLight directValue() const;
  AWDLightChoice lightsValue() const;
};

}  // namespace command
