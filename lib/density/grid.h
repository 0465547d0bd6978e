// SPDX-License-Identifier: Apache-2.0
// A grid density: p(x) = sum_j c_j N_j(x), the tensor product of one basis per axis, with c_j >= 0
// and integral 1. Immutable, and shared by those who draw from it.
#pragma once

#include <memory_resource>
#include <optional>
#include <vector>

#include "density/component.h"
#include "density/inverse_cdf.h"
#include "density/statistics.h"
#include "util/context.h"

namespace awd {

class GridDensity final : public RefCounted {
 public:
  /// Of coefficients that are not negative and have a finite positive integral, which is 1 already
  /// if they are asIs; else they are divided by it. Keeps pointers to the levels, one an axis.
  static Ref<GridDensity> make(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                               uint32_t dimensions, AWDSampler sampler, Coefficients coefficients,
                               Scale scale);
  GridDensity(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
              uint32_t dimensions, AWDSampler sampler, Coefficients coefficients, Scale scale);

  const Shape& shape() const { return shape_; }
  const BasisLevel* const* levels() const { return levels_; }
  const Coefficients& coefficients() const { return coefficients_; }

  /// As the C functions of these names have it.
  void pdf(std::size_t count, const double* points, double* pdfs) const;
  void sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
              uint32_t* components) const;

  /// Adds samples to the statistics of a pass; pdfs may be null: this density's own. components
  /// not null: as the estimator `paper` wants it.
  void record(std::size_t count, const double* points, const double* pdfs,
              const uint32_t* components, const double* values, AWDTarget target,
              DensityStatistics& statistics) const;

  /// int of p over a box.
  double mass(const double* lower, const double* upper) const;
  std::size_t bytes() const;

 private:
  void destroy() noexcept override;
  void normalise();

  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  std::size_t strides_[kMaxDimensions] = {};
  uint32_t order_;  ///< commonOrder() of the axes
  Coefficients coefficients_;
  std::optional<InverseCdf> inverse_;  ///< one of the two, as the sampler has it
  std::optional<ComponentTable> component_;
};

}  // namespace awd
