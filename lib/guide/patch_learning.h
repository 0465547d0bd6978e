// SPDX-License-Identifier: Apache-2.0
// How a patch's samples become its next density: estimate, add to what was known, refine where
// that is due, mix with the constant.
#pragma once

#include "density/normal_pattern.h"
#include "guide/field_settings.h"
#include "guide/patch.h"

namespace awd {

class PatchLearning {
 public:
  PatchLearning(std::pmr::memory_resource* memory, const FieldSettings& settings,
                Ref<DensityBases> bases);

  const Family& family() const { return bases_->family(0); }
  const BasisLevel& startLevel() const { return family().level(settings_.startLevel); }
  Owned<PatchStatistics> freshStatistics(const BasisLevel& level, PatchUnits units) const;

  /// How the lights are chosen where nothing is known; null: the field chooses none.
  const LightChoice* lights() const { return settings_.lights.get(); }
  const LightChoice* lights(const PatchKnowledge& known) const {
    return known.lights ? known.lights.get() : lights();
  }

  /// What a patch with a density on `level` knows after a pass; `known` with the new samples but
  /// the former density if they were of no use for one.
  PatchKnowledge learn(const PatchKnowledge& known, const BasisLevel& level,
                       const PatchStatistics& statistics, bool mayRefine, const Refitter& refitter,
                       RefitReport& report) const;

  /// Of a patch on a level, without its lights: what it takes on the next one more.
  std::size_t bytesToRefine(const BasisLevel& level) const;
  std::size_t bytes() const;

 private:
  /// The coefficients that the estimator makes of a pass, on the same level; empty if it can't.
  Coefficients estimate(const PatchStatistics& statistics, const BasisLevel& level,
                        const Refitter& refitter, RefitReport& report) const;
  Coefficients lumped(const SquareValues& values, const BasisLevel& level, double samples) const;
  /// Adds to coefficients of E[f], or E[f^2], of a pass those of the passes before.
  void pool(const PatchKnowledge& known, double samples, Coefficients& coefficients) const;
  bool learnsSquares() const { return settings_.target == AWD_TARGET_RMS; }
  /// Share of the constant in a density made of so many samples.
  double alphaFor(double samples) const;
  bool finerIsDue(uint32_t level, double samples, const Coefficients& c) const;

  std::pmr::memory_resource* memory_;
  const FieldSettings& settings_;
  Ref<DensityBases> bases_;
  std::pmr::vector<Ref<NormalPattern>> patterns_;  ///< one a level from the start on, for refit
};

}  // namespace awd
