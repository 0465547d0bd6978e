// SPDX-License-Identifier: Apache-2.0
// Numbers as bytes, lowest first on every machine, in a frame that tells damage: a word that says
// what it is, a version, the length and a checksum of all of it.
#pragma once

#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <string_view>
#include <type_traits>
#include <vector>

namespace awd {

class ByteWriter {
 public:
  /// magic: eight characters. most: bytes that room is made for at once.
  ByteWriter(std::pmr::memory_resource* memory, std::string_view magic, uint32_t version,
             std::size_t most = 0);

  /// An integer, or a double by its bits.
  template <class Number>
  void put(Number number) {
    uint64_t bits = 0;
    if constexpr (std::is_floating_point_v<Number>) {
      static_assert(sizeof(Number) == sizeof bits);
      std::memcpy(&bits, &number, sizeof bits);
    } else {
      bits = static_cast<uint64_t>(number);
    }
    for (std::size_t i = 0; i < sizeof number; ++i) {
      bytes_.push_back(static_cast<char>(bits >> (8 * i)));
    }
  }
  void putText(std::string_view text);
  /// Bytes with a frame of their own, or none.
  void putBytes(const std::pmr::vector<char>& bytes);
  /// A number that tends to be small: seven bits a byte, the lowest first.
  void putPacked(uint64_t number);

  /// Completes the frame and hands it over.
  std::pmr::vector<char> finish();

 private:
  std::pmr::vector<char> bytes_;
};

/// Every function fails with AWD_ERROR_IO when the bytes are not what they should be.
class ByteReader {
 public:
  /// Checks the whole frame. what: the kind of thing, for messages.
  ByteReader(const void* bytes, std::size_t size, std::string_view magic, uint32_t version,
             const char* what);

  template <class Number>
  Number get() {
    const char* from = take(sizeof(Number));
    uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bits |= uint64_t{static_cast<unsigned char>(from[i])} << (8 * i);
    }
    if constexpr (std::is_floating_point_v<Number>) {
      Number number;
      std::memcpy(&number, &bits, sizeof number);
      return number;
    } else {
      return static_cast<Number>(bits);
    }
  }
  /// The same, and damaged if not from least to most.
  template <class Number>
  Number get(Number least, Number most) {
    const auto number = get<Number>();
    if (!(number >= least && number <= most)) damaged();
    return number;
  }
  std::string_view getText(std::size_t longest);
  std::string_view getBytes();
  uint64_t getPacked();
  /// A count of items of which each takes that many bytes at least, so that no more is allocated
  /// than was given.
  std::size_t getCount(std::size_t itemSize);
  std::size_t remaining() const { return static_cast<std::size_t>(end_ - next_); }
  /// All has been read.
  void finish();
  [[noreturn]] void damaged() const;

 private:
  const char* take(std::size_t size);

  const char* next_;
  const char* end_;
  const char* what_;
};

}  // namespace awd
