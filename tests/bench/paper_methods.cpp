// SPDX-License-Identifier: Apache-2.0
#include "paper_methods.h"

namespace bench::paper {
namespace {

/// Only the pdf differs: shadow rays, roulette and numbers are those of the preset.
void unguided(Settings& with, AWDGuide guide) {
  with.render.preset = AWD_PRESET_PAPER;
  with.render.guide = guide;
}

}  // namespace

Settings paperSettings(const char* basis) {
  Settings settings;
  settings.field.preset = settings.render.preset = AWD_PRESET_PAPER;
  settings.field.basis = basis;
  return settings;
}

const std::vector<Method>& methods() {
  static const std::vector<Method> all = {
      {"uniform", [](Settings& with) { unguided(with, AWD_GUIDE_UNIFORM); }, 0.0982, false, false},
      {"cosine", [](Settings& with) { unguided(with, AWD_GUIDE_COSINE); }, 0.0812, false, false},
      {"linear-bspline", [](Settings& with) { with = paperSettings("linear-bspline"); }, 0.0696,
       true, false},
      {"haar", [](Settings& with) { with = paperSettings("haar"); }, 0.0607, true, false},
      {"our defaults", [](Settings&) {}, std::nullopt, true, true},
  };
  return all;
}

Settings settingsOf(const Method& method) {
  Settings settings;
  method.change(settings);
  return settings;
}

}  // namespace bench::paper
