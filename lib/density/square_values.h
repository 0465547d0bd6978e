// SPDX-License-Identifier: Apache-2.0
// What a pass learns about one density under the estimator `lumped`: S1_j = sum f N_j / p and no
// more, a fourth of what the other sums cost. Sums of integers: the same in any order, from any
// thread without a lock.
#pragma once

#include <memory_resource>

#include "basis/family.h"
#include "density/fixed_sums.h"
#include "density/nodal_square.h"

namespace awd {

class SquareValues final : public FixedSums {
 public:
  /// On the same level on both axes, to which a pointer is kept. f/p is summed in units of
  /// 2^unitExponent.
  SquareValues(std::pmr::memory_resource* memory, const BasisLevel& level, int unitExponent);
  ~SquareValues();
  SquareValues(const SquareValues&) = delete;
  SquareValues& operator=(const SquareValues&) = delete;

  /// A sample of the value f, drawn at (u,v) in [0,1]^2 with p(u,v) >= 0; safe from any thread. An
  /// f that is not finite or is negative is rejected and counts as 0; where f/p is too large for
  /// its unit it is clamped, and the sample counted.
  void record(float u, float v, double p, double f) noexcept;

  /// Brings nearer what record() will add to, where that is known without a search.
  void prefetch(float u, float v) const {
    if (!nodal_) return;
    const uint32_t cells = levels_[0]->cells;
    const Sum* below = sums_ + std::size_t{NodalSquare::placeOf(u, cells).cell} * (cells + 1) +
                       NodalSquare::placeOf(v, cells).cell;
    __builtin_prefetch(below, 1);
    __builtin_prefetch(below + cells + 1, 1);
  }

  std::size_t components() const { return components_; }
  /// S1_j; means nothing once a sum has overflowed.
  double sum(std::size_t component) const;
  /// The sum of all f/p.
  double total() const;

  /// Adds another pass's figures, of the same level and in the same unit.
  void add(const SquareValues& other) noexcept;
  /// Shows all numbers to one who knows sums, counts, flaws and maxima apart.
  template <class Visitor>
  void visit(Visitor& visitor) {
    for (std::size_t i = 0; i < components_; ++i) visitor.sum(sums_[i]);
    visitFlaws(visitor);
  }
  /// Back to no samples.
  void clear() noexcept;
  void put(ByteWriter& writer) const;
  /// Of as many sums.
  void get(ByteReader& reader);
  std::size_t bytes() const { return sizeof *this + components_ * sizeof(Sum); }

 private:
  using Sum = std::atomic<int64_t>;
  void recordNodes(float u, float v, double value) noexcept;
  template <uint32_t order>
  void recordAlive(const double x[2], double value) noexcept;

  std::pmr::memory_resource* memory_;
  const BasisLevel* levels_[2];
  std::size_t components_;
  uint32_t order_;  ///< commonOrder() of the axes
  bool nodal_;      ///< NodalSquare::fits()
  Sum* sums_;
};

}  // namespace awd
