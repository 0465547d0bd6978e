// SPDX-License-Identifier: Apache-2.0
// Sums as integers in a unit that is a power of two, frozen for a pass: they come out the same
// whatever the order and the threads that add.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>

#include "util/bytes.h"

namespace awd {

/// What can be wrong with a sample: its value, or the pdf that it was drawn with.
enum class Rejection : uint32_t { kNaN, kInfinite, kNegative, kPdf };
constexpr std::size_t kRejections = 4;

/// What such sums have in common: the unit of the values, and what was wrong with values.
class FixedSums {
 public:
  /// The unit for values whose mean or maximum is of this magnitude: leaves room for 2^31 samples
  /// of that magnitude, or fewer larger ones, without overflow.
  static int unitExponentFor(double magnitude);
  /// The power of two that such a unit is for.
  static double magnitudeFor(int unitExponent) {
    return std::ldexp(1.0, unitExponent + kUsualBits);
  }

  int unitExponent() const { return unitExponent_; }
  uint64_t rejected() const;
  uint64_t rejected(Rejection reason) const {
    return rejected_[static_cast<std::size_t>(reason)].load(kOrder);
  }
  std::array<uint64_t, kRejections> rejections() const;
  void reject(Rejection reason) noexcept {
    rejected_[static_cast<std::size_t>(reason)].fetch_add(1, kOrder);
  }
  uint64_t saturated() const { return saturated_.load(kOrder); }
  /// The largest value recorded, before clamping.
  double largest() const;
  bool overflowed() const { return overflowed_.load(kOrder); }

 protected:
  static constexpr std::memory_order kOrder = std::memory_order_relaxed;
  /// One sample adds at most 2^52 units: 2^11 of the largest fit, and 2^31 of the usual ones.
  static constexpr double kLargestUnits = 0x1p52;
  static constexpr int kUsualBits = 32;

  /// Values are summed in units of 2^unitExponent.
  explicit FixedSums(int unitExponent);

  /// A value that is not finite or is negative is rejected: false.
  bool accept(double value) noexcept;
  /// Keeps the largest value, which is finite and not negative, and gives it in units.
  double measure(double value) noexcept;
  void saturate() noexcept { saturated_.fetch_add(1, kOrder); }
  /// units: not negative.
  void accumulate(std::atomic<int64_t>& sum, int64_t units) noexcept;

  void addFlaws(const FixedSums& other) noexcept;
  void clearFlaws() noexcept;
  /// After the sums, of which it tells whether one has gone past its end.
  template <class Visitor>
  void visitFlaws(Visitor& visitor) {
    visitor.overflow(overflowed_);
    visitor.maximum(largestBits_);
    for (std::atomic<uint64_t>& count : rejected_) visitor.count(count);
    visitor.count(saturated_);
  }
  void putFlaws(ByteWriter& writer) const;
  void getFlaws(ByteReader& reader);
  static void putSum(ByteWriter& writer, const std::atomic<int64_t>& sum);
  /// After getFlaws(), which tells whether a sum may have gone past its end.
  void getSum(ByteReader& reader, std::atomic<int64_t>& sum) const;

 private:
  int unitExponent_;
  double scale_;  ///< 2^-unitExponent, or 0 if that is out of range: then ldexp is used
  std::atomic<uint64_t> largestBits_{0};
  std::atomic<bool> overflowed_{false};
  std::array<std::atomic<uint64_t>, kRejections> rejected_{};
  std::atomic<uint64_t> saturated_{0};
};

inline bool FixedSums::accept(double value) noexcept {
  if (value >= 0.0 && std::isfinite(value)) return true;
  reject(std::isnan(value) ? Rejection::kNaN
         : value < 0.0     ? Rejection::kNegative
                           : Rejection::kInfinite);
  return false;
}

inline void FixedSums::accumulate(std::atomic<int64_t>& sum, int64_t units) noexcept {
  // Sums only grow: in whatever order, exactly one addition takes them past the end.
  const int64_t before = sum.fetch_add(units, kOrder);
  int64_t after;
  if (__builtin_add_overflow(before, units, &after)) overflowed_.store(true, kOrder);
}

}  // namespace awd
