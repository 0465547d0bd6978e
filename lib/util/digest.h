// SPDX-License-Identifier: Apache-2.0
// A number that tells two things apart, made of all that they consist of, in order.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "util/random.h"
#include "util/vec.h"

namespace awd {

class Digest {
 public:
  /// Every bit of a number reaches every bit of the digest.
  template <class Number>
  void add(Number number) {
    uint64_t bits = 0;
    static_assert(std::is_arithmetic_v<Number> && sizeof number <= sizeof bits);
    std::memcpy(&bits, &number, sizeof number);
    sum_ = mixBits(sum_ + bits + 0x9e3779b97f4a7c15u) ^ (sum_ << 1 | sum_ >> 63);
  }
  template <class T>
  void add(Vec3<T> v) {
    add(v.x);
    add(v.y);
    add(v.z);
  }
  void add(std::string_view text) {
    add(text.size());
    for (const char c : text) add(c);
  }
  uint64_t value() const { return sum_; }

 private:
  uint64_t sum_ = 0;
};

}  // namespace awd
