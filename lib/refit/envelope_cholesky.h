// SPDX-License-Identifier: Apache-2.0
// Direct solution of (A + E)_FF x = r for a set F of free unknowns and a diagonal E >= 0. A factor
// fills nothing outside of its rows' envelopes (the stretch from the first entry to the diagonal).
// These are short for trees, whose leaves are blocks of their own, and for grids in the order that
// they have, except where an axis is periodic or the slowest one the shortest: there in that of
// Cuthill and McKee.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "refit/quadratic.h"

namespace awd {

class EnvelopeCholesky {
 public:
  /// Finds the better of two orders; the quadratic must outlive this.
  explicit EnvelopeCholesky(const Quadratic& quadratic);

  /// Multiplications and numbers of a factor with every unknown free.
  double operations() const { return operations_; }
  uint64_t entries() const { return entries_; }

  /// Throws Cancelled if the host wants no more. What is not positive definite to rounding is made
  /// so: the factors are then those of another matrix, whose solutions still point downhill.
  void factor(const std::vector<uint8_t>& isFree, const std::vector<double>& extra,
              double fraction);

  /// Overwrites r by x; elements that are not free remain.
  void solve(std::vector<double>& r) const;

 private:
  /// Rows are taken four at a time, which share an envelope: four by four products of rows keep
  /// their operands in registers. Past the last unknown come rows of the unit matrix.
  static constexpr uint32_t kGroup = 4;

  struct Group {
    uint32_t first;  ///< column where the envelope begins, a multiple of kGroup
    uint32_t width;
    uint64_t begin;  ///< of the first row in factor_
  };

  uint32_t groups() const { return static_cast<uint32_t>(groups_.size()); }
  /// The end of some rows without those past the last unknown.
  uint32_t unpadded(uint32_t end) const {
    return std::min(end, static_cast<uint32_t>(free_.size()));
  }
  /// Indexed by column, from the envelope's first on.
  double* rowOf(uint32_t i) { return factor_.data() + offset(i); }
  const double* rowOf(uint32_t i) const { return factor_.data() + offset(i); }
  std::ptrdiff_t offset(uint32_t i) const {
    const Group& g = groups_[i / kGroup];
    return static_cast<std::ptrdiff_t>(g.begin + std::uint64_t{i % kGroup} * g.width) - g.first;
  }

  void count();
  void findEnvelope(const std::vector<uint8_t>& isFree);
  void fillIn(uint32_t group, const std::vector<double>& extra);
  void eliminate(uint32_t group, uint32_t other);
  void factorDiagonal(uint32_t group, const std::vector<double>& extra);

  const Quadratic& quadratic_;
  std::vector<uint32_t> order_;     ///< all unknowns
  std::vector<uint32_t> free_;      ///< the free ones in that order: the factor's rows
  std::vector<uint32_t> position_;  ///< of an unknown in free_
  std::vector<Group> groups_;
  std::vector<double> factor_;
  double operations_ = 0.0;
  uint64_t entries_ = 0;
};

}  // namespace awd
