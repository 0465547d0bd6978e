// SPDX-License-Identifier: Apache-2.0
// Drawing points of a tensor product by its inverse CDF, axis by axis: the marginal of the first,
// then each one's conditional given those before. Takes one uniform an axis and is monotone in it,
// so that stratified uniforms give stratified points.
#pragma once

#include <memory_resource>
#include <vector>

#include "density/blended_row.h"
#include "density/block.h"
#include "density/point.h"
#include "density/tensor.h"

namespace awd {

class InverseCdf {
 public:
  /// `coefficients`: not negative, of positive integral. Keeps pointers to the levels.
  InverseCdf(std::pmr::memory_resource* memory, const BasisLevel* const* levels, const Shape& shape,
             const Coefficients& coefficients);

  /// `count` points, each from D uniforms in [0,1), and if pdfs is not null p there, with the bits
  /// of contract(); coefficients as before.
  template <uint32_t D>
  void sample(const Coefficients& coefficients, std::size_t count, const double* uniforms,
              double* points, double* pdfs) const;

  /// A point in one way for all bases, and the functions alive at it: what sample() is tested
  /// against, bit by bit.
  template <uint32_t D>
  void sampleAny(const Coefficients& coefficients, const double* uniforms, double* x,
                 AxisValues* at) const;

  std::size_t bytes() const;

 private:
  /// Axes A and after, given the rows of those before. O: the order of all axes, or 0.
  template <uint32_t D, uint32_t O, uint32_t A>
  void sampleFrom(const Coefficients& coefficients, const double* uniforms, const BlendedRow* rows,
                  std::size_t count, double* x, AxisValues* at) const;
  /// The same from axis a on for a block of samples with R rows each.
  template <uint32_t O, std::size_t R, std::size_t N>
  void sampleBlock(uint32_t a, const Coefficients& coefficients, std::size_t count,
                   const double* uniforms, const BlockRows<R, N>& rows, double* points,
                   double* pdfs) const;
  template <uint32_t D, uint32_t O>
  void sampleOfOrder(const Coefficients& coefficients, std::size_t count, const double* uniforms,
                     double* points, double* pdfs) const;

  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  std::size_t strides_[kMaxDimensions] = {};
  uint32_t order_;                       ///< commonOrder()
  bool bernstein_[kMaxDimensions] = {};  ///< hasBernsteinPieces()
  /// Axis a: coefficients of the marginal density of axes 0 .. a; the last axis needs none.
  const double* marginalOf(uint32_t a) const { return tables_.data() + marginalBegin_[a]; }
  /// Axis a: for each function of the axes before, the mass of its row up to the end of each cell.
  const double* prefixOf(uint32_t a) const { return tables_.data() + prefixBegin_[a]; }

  std::size_t marginalBegin_[kMaxDimensions] = {};
  std::size_t prefixBegin_[kMaxDimensions] = {};
  Coefficients tables_;  ///< all in one, in the order in which they are read
};

}  // namespace awd
