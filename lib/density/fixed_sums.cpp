// SPDX-License-Identifier: Apache-2.0
#include "density/fixed_sums.h"

#include <algorithm>
#include <cstring>

namespace awd {

namespace {

// Non-negative doubles are ordered as their bits are, so that their maximum can be had with integer
// atomics.
uint64_t bitsOf(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

FixedSums::FixedSums(int unitExponent)
    : unitExponent_(unitExponent),
      scale_(unitExponent > -1023 && unitExponent < 1023 ? std::ldexp(1.0, -unitExponent) : 0.0) {}

int FixedSums::unitExponentFor(double magnitude) {
  if (!(magnitude > 0.0) || !std::isfinite(magnitude)) magnitude = 1.0;
  return std::ilogb(magnitude) - kUsualBits;
}

uint64_t FixedSums::rejected() const {
  uint64_t sum = 0;
  for (const std::atomic<uint64_t>& count : rejected_) sum += count.load(kOrder);
  return sum;
}

std::array<uint64_t, kRejections> FixedSums::rejections() const {
  std::array<uint64_t, kRejections> counts;
  for (std::size_t i = 0; i < kRejections; ++i) counts[i] = rejected_[i].load(kOrder);
  return counts;
}

double FixedSums::largest() const {
  const uint64_t bits = largestBits_.load(kOrder);
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

double FixedSums::measure(double value) noexcept {
  const uint64_t bits = bitsOf(value);
  uint64_t largest = largestBits_.load(kOrder);
  while (bits > largest && !largestBits_.compare_exchange_weak(largest, bits, kOrder)) {
  }
  return scale_ > 0.0 ? value * scale_ : std::ldexp(value, -unitExponent_);
}

void FixedSums::addFlaws(const FixedSums& other) noexcept {
  if (other.overflowed()) overflowed_.store(true, kOrder);
  largestBits_.store(std::max(largestBits_.load(kOrder), other.largestBits_.load(kOrder)), kOrder);
  for (std::size_t i = 0; i < kRejections; ++i) {
    rejected_[i].fetch_add(other.rejected_[i].load(kOrder), kOrder);
  }
  saturated_.fetch_add(other.saturated(), kOrder);
}

void FixedSums::clearFlaws() noexcept {
  largestBits_.store(0, kOrder);
  overflowed_.store(false, kOrder);
  for (std::atomic<uint64_t>& count : rejected_) count.store(0, kOrder);
  saturated_.store(0, kOrder);
}

}  // namespace awd
