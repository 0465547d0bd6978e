// SPDX-License-Identifier: Apache-2.0
// Drawing a point of one leaf of a tree by its inverse CDF. Leaves are many and small, so that
// marginals are summed when they are needed and no table is kept.
#pragma once

#include "density/point.h"

namespace awd {

class LeafSampler {
 public:
  LeafSampler(const BasisLevel* const* levels, const Shape& shape);

  /// t in [0,1)^d from d uniforms, of the density of a leaf's coefficients: not negative, not all
  /// 0.
  void sample(const double* coefficients, const double* uniforms, double* t) const;

  /// A leaf of more coefficients than this is refused.
  static constexpr std::size_t kMostCoefficients = 1024;

 private:
  const BasisLevel* const* levels_;
  Shape shape_;
};

}  // namespace awd
