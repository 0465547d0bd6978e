// SPDX-License-Identifier: Apache-2.0
// The field: a density per patch. Each member function is what a C function of awd/field.h wraps;
// our renderer uses nothing else.
#pragma once

#include <memory_resource>
#include <vector>

#include "awd/field.h"
#include "density/bases.h"
#include "density/learning.h"
#include "guide/hemisphere.h"
#include "guide/patch.h"
#include "guide/patch_table.h"
#include "util/context.h"

namespace awd {

/// The settings of a field with every default settled.
struct FieldSettings {
  AWDPreset preset = AWD_PRESET_DEFAULT;
  AWDHemisphereMap map = AWD_MAP_DEFAULT;
  uint32_t startLevel = 0;
  uint32_t maxLevel = 0;
  LearningSettings learning;  ///< estimator, tau, shrinkage and solver
};

/// Settles what `desc` leaves open, within the levels that the family has. AWD_ERROR_... for what
/// can't be.
FieldSettings settle(const AWDFieldDesc& desc, const AWDBasisFamily& family);

class Field final : public RefCounted {
 public:
  static Ref<Field> make(Ref<Context> context, const AWDBasisFamily& family,
                         const FieldSettings& settings);
  Field(Ref<Context> context, const AWDBasisFamily& family, const FieldSettings& settings);

  Context& context() const { return *context_; }
  const FieldSettings& settings() const { return settings_; }
  const Family& family() const { return bases_->family(0); }

  AWDDirectionSample sample(uint32_t patch, Vec3f normal, const double uniforms[3]) const;
  float pdf(uint32_t patch, Vec3f normal, Vec3f direction) const;
  void record(uint32_t patch, const AWDDirectionSample& sample, double value);

  void setScale(double magnitude);
  AWDFieldStatistics adapt();
  AWDFieldStatistics statistics() const;
  /// What has been recorded so far is kept apart, so that revert() can drop what comes after.
  void mark();
  void revert();

  AWDPatchInfo patchInfo(uint32_t patch) const;
  /// The density of a patch, or the start density.
  const SquareDensity& density(uint32_t patch) const;
  std::pmr::vector<uint32_t> patches() const;
  /// p at the middles of n x n pixels: u to the right, v downwards; rows rowStride bytes apart.
  void pdfImage(uint32_t patch, uint32_t n, float* pixels, std::size_t rowStride) const;

 private:
  void destroy() noexcept override;

  /// What a patch becomes at the end of a pass.
  struct Successor {
    Patch* patch;
    Owned<SquareDensity> density;  ///< null: as it was
    Owned<PatchStatistics> statistics;
    uint64_t samples, rejected, saturated;
    AWDRefitStatus refitStatus;
    uint32_t refitIterations;
  };
  Successor succeed(Patch& patch, const Refitter& refitter) const;
  /// The density made of a pass's samples; null if they are of no use.
  Owned<SquareDensity> learn(const PatchStatistics& statistics, const BasisLevel& level,
                             const Refitter& refitter, RefitReport& report) const;
  /// The coefficients that the estimator makes of them, on the same level; empty if it can't.
  Coefficients estimate(const PatchStatistics& statistics, const BasisLevel& level,
                        const Refitter& refitter, RefitReport& report) const;
  bool finerIsDue(uint32_t level, uint64_t samples) const;
  Owned<PatchStatistics> freshStatistics(const BasisLevel& level, int unitExponent) const;
  const SquareDensity& density(const Patch& patch) const {
    return patch.density ? *patch.density : start_;
  }
  Patch& touch(uint32_t patch);

  Ref<Context> context_;
  FieldSettings settings_;
  Ref<DensityBases> bases_;
  std::pmr::vector<Ref<NormalPattern>> patterns_;  ///< one a level from the start on, for refit
  SquareDensity start_;
  int unitExponent_;
  AWDFieldStatistics lastPass_;  ///< of the last adapt: all but patches, coefficients and bytes
  PatchTable<Patch> table_;
};

}  // namespace awd
