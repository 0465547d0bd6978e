// SPDX-License-Identifier: Apache-2.0
#include "frame.h"

#include <algorithm>

namespace fuzz {

namespace {

constexpr std::size_t kLengthAt = 12, kChecksumAt = 20;

uint64_t mixed(uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// As the library has it (lib/util/bytes.cpp), which tests of whole bytes would tell.
uint64_t checksumOf(const uint8_t* bytes, std::size_t size) {
  uint64_t sum = mixed(size), word = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const bool own = i >= kChecksumAt && i < kFrame;
    word = word << 8 | (own ? 0u : bytes[i]);
    if (i % 8 == 7 || i + 1 == size) {
      sum = mixed(sum + word + 0x9e3779b97f4a7c15u) ^ (sum << 1 | sum >> 63);
      word = 0;
    }
  }
  return sum;
}

void putAt(uint8_t* to, uint64_t number) {
  for (int i = 0; i < 8; ++i) to[i] = static_cast<uint8_t>(number >> 8 * i);
}

}  // namespace

bool repairFrame(Input& bytes, std::size_t begin, std::size_t end, const Input& like) {
  if (end > bytes.size() || end - begin < kFrame || like.size() < kFrame) return false;
  uint8_t* frame = bytes.data() + begin;
  std::copy_n(like.begin(), kLengthAt, frame);
  putAt(frame + kLengthAt, end - begin);
  putAt(frame + kChecksumAt, checksumOf(frame, end - begin));
  return true;
}

}  // namespace fuzz
