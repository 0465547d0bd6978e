// SPDX-License-Identifier: Apache-2.0
// Sums that come out the same in any order. The exponents of all doubles are divided into bins of
// 32; a value is cut into the slices that fall into each bin, and bins are summed as integers.
// Only the three topmost bins of the largest value are kept: slices below are dropped, whether
// before or after they were added, so that addition is associative and commutative to the bit
// (after Demmel and Nguyen, Parallel Reproducible Summation, 2015). At least 53 bits below the
// largest value count.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace awd {

/// A number value * 2^exponent: has no overflow or underflow on the way.
struct Scaled {
  double value;
  int exponent;
};

/// value in [0.5, 1) in magnitude, or 0; exact.
inline Scaled splitExponent(double number) {
  uint64_t bits;
  std::memcpy(&bits, &number, sizeof bits);
  const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
  Scaled out;
  if (biased == 0 || biased == 0x7ff) {
    out.value = std::frexp(number, &out.exponent);
    return out;
  }
  bits = (bits & ~(uint64_t{0x7ff} << 52)) | uint64_t{1022} << 52;
  std::memcpy(&out.value, &bits, sizeof bits);
  out.exponent = biased - 1022;
  return out;
}

class BinnedSum {
 public:
  /// That many values can be added without overflow.
  static constexpr uint64_t kMostValues = (uint64_t{1} << 31) - 1;
  static constexpr int kBins = 3;
  static constexpr int32_t kEmpty = std::numeric_limits<int32_t>::min();

  BinnedSum() = default;
  /// As bins() and top() gave them.
  BinnedSum(const int64_t bins[kBins], int32_t top) : top_(top) {
    std::memcpy(bins_, bins, sizeof bins_);
  }

  /// Adds value * 2^exponent; value is finite.
  void add(double value, int exponent) {
    uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    const auto biased = static_cast<int>(bits >> 52 & 0x7ff);
    uint64_t mantissa = bits & 0xfffffffffffffu;
    if (biased > 0) mantissa |= uint64_t{1} << 52;
    if (mantissa == 0) return;
    // value = mantissa 2^position, position = 32 bin + shift
    const int position = (biased > 0 ? biased : 1) - 1075 + exponent;
    const int shift = position & 31;
    const int32_t top = (position >> 5) + 2;
    const auto negative = static_cast<int64_t>(bits >> 63);
    const uint64_t low = mantissa << shift;
    const uint64_t high = mantissa >> 32 >> (32 - shift);
    const int64_t slices[kBins] = {
        (static_cast<int64_t>(high) ^ -negative) + negative,
        (static_cast<int64_t>(low >> 32) ^ -negative) + negative,
        (static_cast<int64_t>(low & 0xffffffffu) ^ -negative) + negative};
    accumulate(slices, top);
  }
  void add(const BinnedSum& other) {
    if (other.top_ != kEmpty) accumulate(other.bins_, other.top_);
  }

  bool zero() const { return bins_[0] == 0 && bins_[1] == 0 && bins_[2] == 0; }
  /// The sum, rounded to a double once.
  Scaled scaled() const;
  /// The sum times 2^-exponent.
  double plain(int exponent) const {
    const Scaled sum = scaled();
    return std::ldexp(sum.value, sum.exponent - exponent);
  }
  /// The sum with 64 bits of mantissa.
  long double value() const;

  const int64_t* bins() const { return bins_; }
  int32_t top() const { return top_; }

 private:
  void accumulate(const int64_t slices[kBins], int32_t top) {
    if (top > top_) raise(top);
    const auto below = static_cast<uint32_t>(top_) - static_cast<uint32_t>(top);
    if (below == 0) {  // almost always
      for (int i = 0; i < kBins; ++i) bins_[i] = plus(bins_[i], slices[i]);
    } else {
      for (uint32_t i = below; i < kBins; ++i) bins_[i] = plus(bins_[i], slices[i - below]);
    }
  }
  /// Wraps around: sums that came as bytes may be anything.
  static int64_t plus(int64_t a, int64_t b) {
    return static_cast<int64_t>(static_cast<uint64_t>(a) + static_cast<uint64_t>(b));
  }
  void raise(int32_t top);

  int64_t bins_[kBins] = {0, 0, 0};  ///< multiples of 2^(32 top), 2^(32 (top - 1)), ..
  int32_t top_ = kEmpty;
};

}  // namespace awd
