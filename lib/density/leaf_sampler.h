// SPDX-License-Identifier: Apache-2.0
// Drawing points of one leaf of a tree by its inverse CDF, from the marginals of its coefficients.
#pragma once

#include "density/point.h"
#include "density/tensor.h"

namespace awd {

/// A leaf of more coefficients than this is refused.
constexpr std::size_t kMostLeafCoefficients = 1024;

class LeafSampler {
 public:
  LeafSampler() = default;
  LeafSampler(const BasisLevel* const* levels, const Shape& shape);

  /// Coefficients of all marginals but the last, which are the leaf's own: of axis 0, of axes 0
  /// and 1, and so on.
  std::size_t marginalSize() const { return marginalSize_; }
  void marginals(const double* coefficients, double* out) const;

  /// t in [0,1)^D from D uniforms, of the density of a leaf's coefficients: not negative, not all
  /// 0.
  template <uint32_t D>
  void sample(const double* coefficients, const double* marginals, const double* uniforms,
              double* t) const;

 private:
  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  std::size_t marginalSize_ = 0;
  bool bernstein_[kMaxDimensions] = {};  ///< per axis: one polynomial in Bernstein form
};

}  // namespace awd
