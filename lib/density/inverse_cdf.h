// SPDX-License-Identifier: Apache-2.0
// Drawing points of a tensor product by its inverse CDF, axis by axis: the marginal of the first,
// then each one's conditional given those before. Takes one uniform an axis and is monotone in it,
// so that stratified uniforms give stratified points.
#pragma once

#include <memory_resource>
#include <vector>

#include "density/blended_row.h"
#include "density/point.h"
#include "density/tensor.h"

namespace awd {

class InverseCdf {
 public:
  /// Rows that drawing the last coordinate blends: functions alive on the axes before it.
  static std::size_t rowsOf(const BasisLevel* const* levels, uint32_t dimensions);

  /// `coefficients`: not negative, of positive integral. Keeps pointers to the levels.
  InverseCdf(std::pmr::memory_resource* memory, const BasisLevel* const* levels, const Shape& shape,
             const Coefficients& coefficients);

  /// A point from D uniforms in [0,1), and the functions alive at it; coefficients as before.
  template <uint32_t D>
  void sample(const Coefficients& coefficients, const double* uniforms, double* x,
              AxisValues* at) const;

  std::size_t bytes() const;

 private:
  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  /// Axis a: coefficients of the marginal density of axes 0 .. a; the last axis needs none.
  std::pmr::vector<Coefficients> marginals_;
  /// Axis a: for each function of the axes before, the mass of its row up to the end of each cell.
  std::pmr::vector<Coefficients> prefixes_;
};

}  // namespace awd
