// SPDX-License-Identifier: Apache-2.0
// The tables by which a density on the square is drawn from and evaluated: by its inverse CDF, u
// from its marginal, then v given u. In floats and in one block, as small as can be: a renderer has
// thousands of patches, and what a sample costs is the memory that it touches.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "density/axis.h"

namespace awd {

class SquareSampler {
 public:
  struct Sample {
    float u, v;  ///< in [0,1)
    double pdf;  ///< bit-equal to what pdf() says
  };

  /// Of coefficients, not negative, of a function of integral 1. Keeps a pointer to the level.
  SquareSampler(const BasisLevel& level, const std::pmr::vector<double>& coefficients);

  /// From two uniforms in [0,1); monotone in each.
  Sample sample(double first, double second) const;
  double pdf(float u, float v) const;

  /// Brings the tables nearer, for a sample soon.
  void prefetch() const;
  std::size_t bytes() const { return tables_.size() * sizeof(float); }

 private:
  /// Up to so many cells a row's masses are summed for each sample; beyond, they are stored.
  static constexpr uint32_t kMostSummed = 32;

  /// The functions alive at x. O: the order, if as many functions are alive on every cell, or 0.
  template <uint32_t O>
  void evaluate(float x, AxisValues& at) const;
  /// A coordinate, given the masses up to the ends of cells and the coefficients along the axis.
  template <uint32_t O, class MassUpTo, class Coefficient>
  float draw(double uniform, const MassUpTo& massUpTo, const Coefficient& coefficient) const;
  template <uint32_t O>
  float drawAlongV(double uniform, const AxisValues& alongU) const;
  /// Coefficient of a function along v, given the functions alive at u.
  template <uint32_t O>
  float blended(const AxisValues& alongU, uint32_t function) const;
  template <uint32_t O>
  double value(const AxisValues& alongU, const AxisValues& alongV) const;

  bool summed() const { return level_->cells <= kMostSummed; }
  /// Mass of the marginal up to the end of each cell.
  const float* prefix() const { return tables_.data(); }
  /// Coefficients of the marginal.
  const float* marginal() const { return prefix() + level_->cells; }
  /// Of a function along u.
  const float* row(uint32_t function) const {
    return marginal() + std::size_t{function + 1} * level_->count;
  }
  /// Unless summed(): mass of a function's row up to the end of each cell.
  const float* rowPrefix(uint32_t function) const {
    return row(level_->count) + std::size_t{function} * level_->cells;
  }

  const BasisLevel* level_;
  uint32_t order_;  ///< commonOrder()
  bool bernstein_;  ///< hasBernsteinPieces()
  std::pmr::vector<float> tables_;
};

}  // namespace awd
