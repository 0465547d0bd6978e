// SPDX-License-Identifier: Apache-2.0
// Numbers from a fuzzer's bytes; zeros once they are used up.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace fuzz {

class Bytes {
 public:
  Bytes(const uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return size_ == 0; }
  uint8_t byte() {
    if (size_ == 0) return 0;
    --size_;
    return *data_++;
  }
  uint32_t below(uint32_t limit) { return byte() % limit; }

  /// Small ones mostly, and those around which arithmetic breaks.
  uint32_t integer() {
    const uint32_t kind = byte();
    if (kind < 200) return kind % 40;
    if (kind < 210) return 1u << (kind % 32);
    if (kind < 220) return (1u << (kind % 32)) - 1;
    uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value = value << 8 | byte();
    return value;
  }

  /// Any double: plain ones, special ones, or any bits at all.
  double real() {
    constexpr double special[] = {0.0,
                                  -0.0,
                                  1.0,
                                  -1.0,
                                  0.5,
                                  1e-300,
                                  1e300,
                                  1e-17,
                                  -1e-17,
                                  std::numeric_limits<double>::denorm_min(),
                                  std::numeric_limits<double>::max(),
                                  std::numeric_limits<double>::infinity(),
                                  -std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::quiet_NaN()};
    const uint32_t kind = byte();
    if (kind < 64) return special[kind % (sizeof special / sizeof special[0])];
    if (kind < 160) return byte() / 255.0;
    if (kind < 224) return std::ldexp(byte() / 128.0 - 1.0, -static_cast<int>(below(64)));
    uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double value;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

 private:
  const uint8_t* data_;
  std::size_t size_;
};

}  // namespace fuzz
