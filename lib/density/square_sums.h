// SPDX-License-Identifier: Apache-2.0
// What a pass learns about one density under the estimators that go by all functions alive at a
// sample: S1_j = sum f N_j / p, S0_j = sum N_j / p and n_j = sum N_j, and for `refit` also
// A_jk = sum N_j N_k / p and sum f^2 / p. Sums of integers: the same in any order, from any thread
// without a lock.
#pragma once

#include <memory_resource>

#include "density/fixed_sums.h"
#include "density/statistics.h"

namespace awd {

class SquareSums final : public FixedSums {
 public:
  /// 1/p has the mean 1; larger ones than this are taken for it.
  static constexpr double kLargestWeight = 0x1p20;

  /// On the same level on both axes, to which a pointer is kept. pattern: null unless it is
  /// `refit`. f/p is summed in units of 2^unitExponent.
  SquareSums(std::pmr::memory_resource* memory, const BasisLevel& level, Ref<NormalPattern> pattern,
             int unitExponent);
  ~SquareSums();
  SquareSums(const SquareSums&) = delete;
  SquareSums& operator=(const SquareSums&) = delete;

  /// A sample of the value f, drawn at (u,v) in [0,1]^2 with p(u,v) >= 0; safe from any thread. An
  /// f that is not finite or is negative is rejected and counts as 0; where f/p or 1/p is too large
  /// for its unit it is clamped, and the sample counted.
  void record(float u, float v, double p, double f) noexcept;

  std::size_t components() const { return components_; }
  uint64_t samples() const;
  /// The sum of all f/p; means nothing once a sum has overflowed.
  double total() const;
  /// All sums, as the estimators want them.
  DensityStatistics statistics() const;

  /// Adds another pass's figures, of the same level and in the same unit.
  void add(const SquareSums& other) noexcept;
  /// As of SquareValues.
  template <class Visitor>
  void visit(Visitor& visitor) {
    for (std::size_t i = 0; i < size(); ++i) visitor.sum(sums_[i]);
    visitFlaws(visitor);
  }
  /// Back to no samples.
  void clear() noexcept;
  void put(ByteWriter& writer) const;
  /// Of as many sums.
  void get(ByteReader& reader);
  std::size_t bytes() const { return sizeof *this + size() * sizeof(Sum); }

 private:
  using Sum = std::atomic<int64_t>;
  /// Sums of a component.
  enum { kValue, kWeight, kAlive, kSums };
  /// Limbs of the sum of f^2 / p.
  enum { kLow, kHigh, kLimbs };

  std::size_t size() const {
    return components_ * kSums + (pattern_ ? kLimbs + pattern_->size() : 0);
  }
  Sum& sum(std::size_t component, int which) const { return sums_[component * kSums + which]; }
  Sum* energy() const { return sums_ + components_ * kSums; }
  Sum* products() const { return energy() + kLimbs; }
  void recordEnergy(double units) noexcept;
  template <uint32_t order>
  void recordAlive(const double x[2], double value, double weight) noexcept;

  std::pmr::memory_resource* memory_;
  const BasisLevel* levels_[2];
  Ref<NormalPattern> pattern_;
  std::size_t components_;
  uint32_t order_;  ///< commonOrder() of the axes
  Sum* sums_;       ///< kSums a component; for refit then kLimbs, and the entries of the pattern
};

}  // namespace awd
