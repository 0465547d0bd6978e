// SPDX-License-Identifier: Apache-2.0
// A pdf on the unit square, p(u,v) = sum_jk c_jk N_j(u) N_k(v) with c_jk >= 0 and integral 1: the
// two-dimensional tensor product of the paper, with the same basis on both axes. Immutable.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <optional>
#include <vector>

#include "awd/density.h"
#include "density/nodal_square.h"
#include "density/square_sampler.h"
#include "density/tensor.h"
#include "util/context.h"

namespace awd {

/// A point drawn from a density, and the component that it was drawn from.
struct SquareSample {
  float u, v;
  uint32_t component;  ///< j * n + k; AWD_INVALID_ID if drawn by the inverse CDF
  double pdf;          ///< p(u, v): bit-equal to what pdf() says
};

class SquareDensity final : public RefCounted {
 public:
  /// The constant density.
  SquareDensity(std::pmr::memory_resource* memory, const BasisLevel& level, AWDSampler sampler);
  /// From coefficients of a function with finite positive integral, no coefficient negative; they
  /// are divided by the integral sum c_jk w_j w_k, unless that has been done.
  SquareDensity(const BasisLevel& level, AWDSampler sampler, std::pmr::vector<double> coefficients,
                Scale scale = Scale::toIntegral);

  static Ref<SquareDensity> make(const BasisLevel& level, AWDSampler sampler,
                                 std::pmr::vector<double> coefficients,
                                 Scale scale = Scale::toIntegral);

  const BasisLevel& level() const { return *level_; }
  const std::pmr::vector<double>& coefficients() const { return coefficients_; }

  /// p at a point of [0,1]^2.
  double pdf(float u, float v) const;
  /// By component: draws it with probability c_jk w_j w_k (eq. 4), then u ~ p_j and v ~ p_k. Or by
  /// the inverse CDF, u from uniforms[0] and v from uniforms[1], monotone in both.
  SquareSample sample(const double uniforms[3]) const;

  /// The fast form of sample() and pdf(), if the level has one and drawing is by the inverse CDF.
  NodalSquare nodal() const {
    return nodal_.empty() ? NodalSquare() : NodalSquare(nodal_.data(), level_->cells);
  }
  /// Brings what sample() reads nearer, where nodal() is none.
  void prefetch() const {
    if (inverse_) inverse_->prefetch();
  }
  std::size_t bytes() const;

 private:
  void destroy() noexcept override;
  void normalise();
  void accumulate();
  SquareSample sampleByComponent(const double uniforms[3]) const;

  const BasisLevel* level_;
  std::pmr::vector<double> coefficients_;
  /// 1 everywhere, where the uniforms are the sample: cosine sampling on the cosine maps costs no
  /// more. Never by component.
  bool constant_ = false;
  // By component there is neither of these.
  std::optional<SquareSampler> inverse_;
  std::pmr::vector<float> nodal_;  ///< in place of the former where it fits
  /// Sums of c_jk w_j w_k up to and with each component; exactly 1 at the last.
  std::pmr::vector<double> cumulative_;
};

}  // namespace awd
