// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers: a pure function of (seed, pass, pixel, sample, dimension), so that
// neither threads nor the order of pixels can change a bit.
#pragma once

#include <cstdint>

namespace awd {

/// A bijection of 64 bits in which every input bit reaches every output bit: the finaliser of
/// splitmix64 (Steele, Lea and Flood 2014) with the constants of Stafford's variant 13.
inline uint64_t mixBits(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// The numbers of one camera path, dimension by dimension.
class RandomStream {
 public:
  RandomStream(uint64_t seed, uint64_t pass, uint64_t pixel, uint64_t sample) {
    uint64_t key = mixBits(seed + kGolden);
    key = mixBits(key ^ mixBits(pass + 2 * kGolden));
    key = mixBits(key ^ mixBits(pixel + 3 * kGolden));
    state_ = mixBits(key ^ mixBits(sample + 4 * kGolden));
    // Each path steps by an odd constant of its own, so that no two run into each other's tracks.
    step_ = mixBits(state_ ^ kGolden) | 1u;
  }

  /// The next dimension, uniform in [0,1) with 53 bits.
  double next() {
    state_ += step_;
    return static_cast<double>(mixBits(state_) >> 11) * 0x1p-53;
  }

 private:
  static constexpr uint64_t kGolden = 0x9e3779b97f4a7c15u;
  uint64_t state_, step_;
};

}  // namespace awd
