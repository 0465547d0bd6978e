// SPDX-License-Identifier: Apache-2.0
#include "density/binned_sum.h"

#include <cmath>

namespace awd {

namespace {

__extension__ using Wide = __int128;

/// bins as one integer in units of 2^(32 (top - 2)). Modulo 2^128, so that sums of forged numbers
/// are wrong, but not undefined.
Wide whole(const int64_t bins[BinnedSum::kBins]) {
  __extension__ using Bits = unsigned __int128;
  constexpr Bits kStep = Bits{1} << 32;
  const auto bits = [](int64_t bin) { return static_cast<Bits>(Wide{bin}); };
  return static_cast<Wide>((bits(bins[0]) * kStep + bits(bins[1])) * kStep + bits(bins[2]));
}

}  // namespace

void BinnedSum::raise(int32_t top) {
  const uint32_t by =
      top_ == kEmpty ? kBins : static_cast<uint32_t>(top) - static_cast<uint32_t>(top_);
  for (uint32_t i = kBins; i-- > 0;) bins_[i] = i >= by ? bins_[i - by] : 0;
  top_ = top;
}

Scaled BinnedSum::scaled() const {
  if (zero()) return {0.0, 0};
  int exponent;
  const double value = std::frexp(static_cast<double>(whole(bins_)), &exponent);
  return {value, exponent + 32 * (top_ - 2)};
}

long double BinnedSum::value() const {
  return zero() ? 0.0L : std::ldexp(static_cast<long double>(whole(bins_)), 32 * (top_ - 2));
}

}  // namespace awd
