// SPDX-License-Identifier: Apache-2.0
#include "guide/exchange_visitors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace awd {
namespace {

__extension__ using Wide = __int128;

/// As the statistics of a patch: three sums that only grow, whether one went past its end, the
/// largest value, and a count.
struct Recorded {
  std::array<std::atomic<int64_t>, 3> sums{};
  std::atomic<bool> overflowed{false};
  std::atomic<uint64_t> largest{0}, count{0};

  template <class Visitor>
  void visit(Visitor& visitor) {
    for (std::atomic<int64_t>& sum : sums) visitor.sum(sum);
    visitor.overflow(overflowed);
    visitor.maximum(largest);
    visitor.count(count);
  }
};

using Sums = std::array<uint64_t, 5>;
using Maxima = std::array<uint64_t, 2>;

/// `times` processes that each have recorded the same.
void combine(Recorded& one, uint64_t times, Recorded& all) {
  ExchangeCounter size;
  one.visit(size);
  ASSERT_EQ(size.sums, Sums().size());
  ASSERT_EQ(size.maxima, Maxima().size());
  Sums sums;
  Maxima maxima;
  ExchangeWriter writer = {sums.data(), maxima.data()};
  one.visit(writer);
  for (uint64_t& sum : sums) sum *= times;
  ExchangeChecker checker = {sums.data(), maxima.data()};
  one.visit(checker);
  EXPECT_TRUE(checker.good);
  ExchangeReader reader = {sums.data(), maxima.data()};
  all.visit(reader);
}

TEST(ExchangeVisitors, SumsCountsAndMaximaComeBack) {
  Recorded one, all;
  one.sums[1] = (int64_t{1} << 40) + 7;
  one.largest = 12345;
  one.count = 9;
  combine(one, 1000, all);
  EXPECT_EQ(all.sums[0], 0);
  EXPECT_EQ(all.sums[1], ((int64_t{1} << 40) + 7) * 1000);
  EXPECT_EQ(all.largest, 12345u);
  EXPECT_EQ(all.count, 9000u);
  EXPECT_FALSE(all.overflowed);
}

TEST(ExchangeVisitors, EverySumPastItsEndIsFoundOutAndNoOther) {
  for (const int64_t units : {int64_t{1}, int64_t{0xffffffff}, int64_t{1} << 31, int64_t{1} << 50,
                              (int64_t{1} << 62) + 5, (int64_t{1} << 62) - 1, INT64_MAX}) {
    for (const uint64_t times : {1u, 2u, 3u, 4u, 5u, 7u, 8u, 9u, 1000u, 8191u, 8192u, 10000u}) {
      Recorded one, all;
      one.sums[2] = units;
      one.sums[0] = 0xffffffff;  // whose upper half is lost in every process
      combine(one, times, all);
      const Wide exact = static_cast<Wide>(units) * times;
      EXPECT_EQ(all.overflowed, exact > INT64_MAX) << units << " times " << times;
      EXPECT_EQ(static_cast<uint64_t>(all.sums[2].load()), static_cast<uint64_t>(exact));
    }
  }
}

TEST(ExchangeVisitors, AnOverflowOfOneIsThatOfAll) {
  Recorded one, all;
  one.overflowed = true;
  combine(one, 1, all);
  EXPECT_TRUE(all.overflowed);
}

TEST(ExchangeVisitors, MaximaThatWereAddedAreFoundOut) {
  Recorded one;
  const Sums sums{};
  for (const Maxima& maxima : {Maxima{2, 0}, Maxima{0, 0x7ff0000000000000u}}) {
    ExchangeChecker checker = {sums.data(), maxima.data()};
    one.visit(checker);
    EXPECT_FALSE(checker.good);
  }
}

}  // namespace
}  // namespace awd
