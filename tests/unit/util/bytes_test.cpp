// SPDX-License-Identifier: Apache-2.0
#include "util/bytes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "util/error.h"

namespace awd {
namespace {

constexpr char kMagic[] = "AWDBYTES";
using Bytes = std::pmr::vector<char>;

ByteWriter writer() { return {std::pmr::get_default_resource(), kMagic, 3}; }
ByteReader reader(const Bytes& bytes) { return {bytes.data(), bytes.size(), kMagic, 3, "a test"}; }

/// Whether reading these bytes fails, with AWD_ERROR_IO and what they should have been.
template <class Read>
void expectDamaged(const Bytes& bytes, Read&& read) {
  try {
    ByteReader from = reader(bytes);
    read(from);
    ADD_FAILURE() << "no damage was found";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_IO);
    EXPECT_NE(std::string(error.what()).find("a test"), std::string::npos) << error.what();
  }
}

TEST(Bytes, NumbersComeBack) {
  ByteWriter to = writer();
  to.put(uint32_t{0xfedcba98u});
  to.put(int32_t{-7});
  to.put(std::numeric_limits<int64_t>::min());
  to.put(std::numeric_limits<uint64_t>::max());
  for (const double x : {0.0, -0.0, 5e-324, -1.7e308, HUGE_VAL, std::nan("")}) to.put(x);
  to.putText("a word");
  to.putText("");
  const Bytes bytes = to.finish();
  EXPECT_EQ(bytes.size(), 28u + 4 + 4 + 8 + 8 + 6 * 8 + 4 + 6 + 4);
  EXPECT_EQ(static_cast<unsigned char>(bytes[28]), 0x98) << "the lowest byte first";

  ByteReader from = reader(bytes);
  EXPECT_EQ(from.get<uint32_t>(), 0xfedcba98u);
  EXPECT_EQ(from.get<int32_t>(), -7);
  EXPECT_EQ(from.get<int64_t>(), std::numeric_limits<int64_t>::min());
  EXPECT_EQ(from.get<uint64_t>(), std::numeric_limits<uint64_t>::max());
  EXPECT_FALSE(std::signbit(from.get<double>()));
  EXPECT_TRUE(std::signbit(from.get<double>()));
  EXPECT_EQ(from.get<double>(), 5e-324);
  EXPECT_EQ(from.get<double>(), -1.7e308);
  EXPECT_EQ(from.get<double>(), HUGE_VAL);
  EXPECT_TRUE(std::isnan(from.get<double>()));
  EXPECT_EQ(from.getText(6), "a word");
  EXPECT_EQ(from.getText(0), "");
  from.finish();
}

TEST(Bytes, PackedNumbersComeBack) {
  constexpr uint64_t kMost = std::numeric_limits<uint64_t>::max();
  ByteWriter to = writer();
  for (const uint64_t x : {uint64_t{0}, uint64_t{127}, uint64_t{128}, uint64_t{300}, kMost / 2}) {
    to.putPacked(x);
  }
  to.putPacked(kMost);
  const Bytes bytes = to.finish();
  EXPECT_EQ(bytes.size(), 28u + 1 + 1 + 2 + 2 + 9 + 10);
  ByteReader from = reader(bytes);
  for (const uint64_t x : {uint64_t{0}, uint64_t{127}, uint64_t{128}, uint64_t{300}, kMost / 2}) {
    EXPECT_EQ(from.getPacked(), x);
  }
  EXPECT_EQ(from.getPacked(), kMost);
  from.finish();

  for (const int last : {2, 0x80, 0}) {  // a 65th bit; more bytes than that; one that says nothing
    ByteWriter wrong = writer();
    for (int i = 0; i < 9; ++i) wrong.put(char{-1});
    wrong.put(static_cast<char>(last));
    wrong.put(char{1});
    expectDamaged(wrong.finish(), [](ByteReader& of) { of.getPacked(); });
  }
}

TEST(Bytes, EveryFlippedBitIsFound) {
  ByteWriter to = writer();
  for (int i = 0; i < 20; ++i) to.put(i);
  const Bytes bytes = to.finish();
  reader(bytes);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    expectDamaged(damaged, [](ByteReader&) {});
  }
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    expectDamaged(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size)),
                  [](ByteReader&) {});
  }
}

TEST(Bytes, WhatMakesNoSenseIsDamage) {
  ByteWriter to = writer();
  to.put(uint64_t{3});
  to.put(uint64_t{4});
  const Bytes bytes = to.finish();
  expectDamaged(bytes, [](ByteReader& from) { from.get<uint64_t>(4, 9); });
  expectDamaged(bytes, [](ByteReader& from) { from.finish(); });
  expectDamaged(bytes, [](ByteReader& from) {
    for (int i = 0; i < 3; ++i) from.get<uint64_t>();
  });
  expectDamaged(bytes, [](ByteReader& from) { from.getText(2); });   // longer than it may be
  expectDamaged(bytes, [](ByteReader& from) { from.getCount(4); });  // 3 items: 12 bytes of 8
  ByteReader from = reader(bytes);
  EXPECT_EQ(from.getCount(2), 3u);

  ByteWriter other = writer();
  other.put(std::nan(""));
  expectDamaged(other.finish(), [](ByteReader& of) { of.get(-1.0, 1.0); });
}

TEST(Bytes, WithinOthersComeBack) {
  const Bytes inner = writer().finish();
  ByteWriter to = writer();
  to.putBytes(inner);
  to.putBytes({});
  to.put(uint8_t{7});
  const Bytes bytes = to.finish();
  ByteReader from = reader(bytes);
  const std::string_view got = from.getBytes();
  EXPECT_EQ(Bytes(got.begin(), got.end()), inner);
  EXPECT_TRUE(from.getBytes().empty());
  EXPECT_EQ(from.get<uint8_t>(), 7);
  from.finish();

  ByteWriter other = writer();
  other.put(uint64_t{2});
  other.put(uint8_t{0});
  expectDamaged(other.finish(), [](ByteReader& of) { of.getBytes(); });
}

TEST(Bytes, AnotherVersionIsNamed) {
  const Bytes bytes = writer().finish();
  try {
    ByteReader(bytes.data(), bytes.size(), kMagic, 4, "a test");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "a test of version 3: this library reads version 4");
  }
}

}  // namespace
}  // namespace awd
