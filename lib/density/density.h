// SPDX-License-Identifier: Apache-2.0
// An adaptive density on the unit cube. Each member function is what a C function of awd/density.h
// wraps.
#pragma once

#include <memory_resource>

#include "awd/density.h"
#include "density/bases.h"
#include "density/finders.h"
#include "density/model.h"
#include "density/passes.h"
#include "density/settings.h"
#include "density/statistics.h"
#include "util/bytes.h"
#include "util/context.h"

namespace awd {

class Density final : public RefCounted {
 public:
  /// Without p: for the functions below.
  Density(Ref<Context> context, Ref<DensityBases> bases, const DensitySettings& settings);
  /// The constant density.
  static Ref<Density> make(Ref<Context> context, Ref<DensityBases> bases,
                           const DensitySettings& settings);
  static Ref<Density> fork(const Density& from);
  /// From what bytesOf() wrote.
  static Ref<Density> load(Ref<Context> context, const void* bytes, std::size_t size,
                           const Finders& find);

  const DensitySettings& settings() const { return settings_; }
  const DensityBases& bases() const { return *bases_; }
  const Model& model() const { return model_; }
  std::pmr::memory_resource* memory() const { return context_->memory(); }
  uint32_t dimensions() const { return settings_.dimensions; }
  /// Numbers that sample() takes for one point.
  uint32_t uniforms() const {
    return dimensions() + (settings_.sampler == AWD_SAMPLER_COMPONENT ? 1 : 0);
  }

  void sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
              uint32_t* components) const;
  void record(std::size_t count, const double* points, const double* pdfs,
              const uint32_t* components, const double* values);
  /// Takes over what a fork has recorded.
  void join(Density& fork);
  AWDDensityReport adapt();
  void refine(uint32_t axis);
  void setCoefficients(const double* coefficients, std::size_t count);

  Estimate estimate() const { return passes_.estimate(statistics_->sums); }
  AWDDensityInfo info() const;
  AWDDensityAxisInfo axisInfo(uint32_t axis) const;
  Coefficients coefficients(AWDCoefficientForm form) const;
  Coefficients detailEnergy() const;

  std::pmr::vector<char> statisticsBytes() const;
  /// Adds exported statistics to those there are, or takes them instead.
  void takeStatistics(const void* bytes, std::size_t size, bool instead);
  /// Everything, for load().
  std::pmr::vector<char> bytesOf() const;

 private:
  void destroy() noexcept override;

  Model gridModel(const Levels& levels, Coefficients coefficients,
                  Scale scale = Scale::toIntegral) const;
  Model treeModel(Tree tree, Coefficients coefficients, Scale scale = Scale::toIntegral) const;
  Owned<DensityStatistics> freshStatistics(const Model& model, std::size_t earlier) const;
  /// That statistics of the model go by; null unless the estimator is refit.
  Ref<NormalPattern> patternOf(const Model& model) const;
  /// Makes this the model, with no samples.
  void become(Model model, const Levels& levels);
  void needNoSamples(const char* what) const;
  /// What statistics must share to be added.
  uint64_t layout() const;
  void putModel(ByteWriter& writer, const Model& model) const;
  Model getModel(ByteReader& reader) const;

  Ref<Context> context_;
  Ref<DensityBases> bases_;
  DensitySettings settings_;
  Levels levels_{};  ///< of a grid
  Model model_;
  Owned<DensityStatistics> statistics_;
  Passes passes_;
  uint64_t learned_ = 0;
  uint64_t adapts_ = 0;
  std::pmr::string refitMessage_;  ///< of the last adapt
};

}  // namespace awd
