// SPDX-License-Identifier: Apache-2.0
#include "mutate.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace fuzz {

namespace {

using awdtest::Random;

constexpr uint64_t kIntegers[] = {0,          1,          2,           0x7f,        0xff,
                                  0x7fff,     0xffff,     0x10000,     0x3fffffff,  0x7fffffff,
                                  0x80000000, 0xfffffffe, 0xffffffffu, 0x100000000, ~uint64_t{0}};
constexpr double kReals[] = {0.0,
                             -0.0,
                             1.0,
                             -1.0,
                             1e-300,
                             1e300,
                             1e38,
                             std::numeric_limits<double>::denorm_min(),
                             std::numeric_limits<double>::max(),
                             std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()};
const char* const kWords[] = {
    "0",   "-1",         "2147483647", "2147483648", "4294967295",
    "3",   "4294967296", "1e39",       "-1e39",      "18446744073709551615",
    "nan", "1e-46",      "\"\"",       "null",       "[]",
    "{}",  "7",          "65536",      "-2147483649"};

class Mutation {
 public:
  Mutation(Input bytes, Random& random) : bytes_(std::move(bytes)), random_(random) {}

  void change() {
    if (bytes_.empty()) bytes_.push_back(0);
    const std::size_t at = below(bytes_.size());
    switch (below(11)) {
      case 0:
        bytes_[at] ^= static_cast<uint8_t>(1u << below(8));
        break;
      case 1:
        bytes_[at] = static_cast<uint8_t>(random_.bits());
        break;
      case 2:
        putNumber(at, any(kIntegers), std::size_t{1} << below(4));
        break;
      case 3:
        putReal(at);
        break;
      case 4:
        bytes_.resize(at);
        break;
      case 5:
        bytes_.erase(begin(at),
                     begin(at + 1 + below(std::min<std::size_t>(16, bytes_.size() - at))));
        break;
      case 6:
        bytes_.insert(begin(at), 1 + below(8), static_cast<uint8_t>(random_.bits()));
        break;
      case 7:  // a piece comes twice
        copy(at, true);
        break;
      case 8:
        copy(at, false);
        break;
      default:
        replaceWord(at);
    }
  }
  Input take() { return std::move(bytes_); }

 private:
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(random_.bits() % limit); }
  template <class T, std::size_t n>
  const T& any(const T (&list)[n]) {
    return list[below(n)];
  }
  Input::iterator begin(std::size_t at) { return bytes_.begin() + static_cast<std::ptrdiff_t>(at); }

  void putNumber(std::size_t at, uint64_t number, std::size_t size) {
    for (std::size_t i = 0; i < size && at + i < bytes_.size(); ++i) {
      bytes_[at + i] = static_cast<uint8_t>(number >> 8 * i);
    }
  }
  void putReal(std::size_t at) {
    const double real = any(kReals);
    if (random_.bits() & 1) {
      const auto narrow = static_cast<float>(std::clamp(real, -3e38, 3e38));
      uint32_t bits;
      std::memcpy(&bits, &narrow, sizeof bits);
      putNumber(at, bits, sizeof bits);
    } else {
      uint64_t bits;
      std::memcpy(&bits, &real, sizeof bits);
      putNumber(at, bits, sizeof bits);
    }
  }
  void copy(std::size_t from, bool insert) {
    const std::size_t size = 1 + below(std::min<std::size_t>(64, bytes_.size() - from));
    const Input piece(begin(from), begin(from + size));
    const std::size_t to = below(bytes_.size());
    if (insert) {
      bytes_.insert(begin(to), piece.begin(), piece.end());
    } else {
      std::copy_n(piece.begin(), std::min(size, bytes_.size() - to), begin(to));
    }
  }
  /// The number in digits at or behind a place becomes another.
  void replaceWord(std::size_t at) {
    const auto isPart = [](uint8_t c) {
      return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e';
    };
    const auto first =
        std::find_if(begin(at), bytes_.end(), [](uint8_t c) { return c >= '0' && c <= '9'; });
    if (first == bytes_.end()) return;
    const auto last = std::find_if_not(first, bytes_.end(), isPart);
    const char* word = any(kWords);
    const auto next = bytes_.erase(first, last);
    bytes_.insert(next, word, word + std::strlen(word));
  }

  Input bytes_;
  Random& random_;
};

}  // namespace

Input mutated(const Input& input, std::size_t longest, awdtest::Random& random) {
  Mutation mutation(input, random);
  for (uint64_t left = 1 + random.bits() % 4; left > 0; --left) mutation.change();
  Input result = mutation.take();
  if (result.size() > longest) result.resize(longest);
  return result;
}

}  // namespace fuzz
