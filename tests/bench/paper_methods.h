// SPDX-License-Identifier: Apache-2.0
// The four pdfs of the paper's table 1, and what it says of them.
#pragma once

#include <optional>
#include <vector>

#include "render_shots.h"

namespace bench::paper {

struct Method {
  const char* name;
  void (*change)(Settings& with);   ///< from the defaults
  std::optional<double> published;  ///< L1 in table 1 of Pietrek and Peter 1999
  bool learns;
  bool ownSchedule;  ///< passes are the library's, not the paper's
};

/// In the order of table 1; what we add comes last.
const std::vector<Method>& methods();
Settings settingsOf(const Method& method);
/// The preset paper with a basis.
Settings paperSettings(const char* basis);

/// Place in methods() of what others are compared with, and of the paper's best.
constexpr std::size_t kUniform = 0, kCosine = 1, kLinear = 2, kHaar = 3;

/// "up to 17 % smaller errors" by "Haar", and "f_r cos needs up to 41 % more time": ibidem.
constexpr double kPublishedErrorGain = 0.17, kPublishedTimeLoss = 0.41;

/// Its schedule: three passes of 10 samples, then 70.
constexpr uint32_t kLearningPasses = 3, kLearningSamples = 10, kTableSamples = 100;

}  // namespace bench::paper
