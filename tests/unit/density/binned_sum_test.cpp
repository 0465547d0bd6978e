// SPDX-License-Identifier: Apache-2.0
#include "density/binned_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

using Value = std::pair<double, int>;

bool same(const BinnedSum& a, const BinnedSum& b) {
  return a.top() == b.top() && std::equal(a.bins(), a.bins() + BinnedSum::kBins, b.bins());
}

BinnedSum sumOf(const std::vector<Value>& values) {
  BinnedSum sum;
  for (const auto& [value, exponent] : values) sum.add(value, exponent);
  return sum;
}

/// Values of both signs with exponents over +-spread.
std::vector<Value> someValues(Uniforms& random, std::size_t count, double spread) {
  std::vector<Value> values;
  for (std::size_t i = 0; i < count; ++i) {
    const auto exponent = static_cast<int>(spread * (2.0 * random() - 1.0));
    values.emplace_back(random() < 0.1 ? 0.0 : 2.0 * random() - 1.0, exponent);
  }
  return values;
}

TEST(BinnedSum, OrderAndGroupsChangeNoBit) {
  Uniforms random(1);
  for (const double spread : {0.0, 10.0, 100.0, 3000.0}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<Value> values = someValues(random, 300, spread);
      const BinnedSum expected = sumOf(values);
      for (std::size_t i = values.size(); i-- > 1;) {
        std::swap(values[i], values[static_cast<std::size_t>(random() * double(i + 1))]);
      }
      EXPECT_TRUE(same(sumOf(values), expected));
      std::sort(values.begin(), values.end(),
                [](const Value& a, const Value& b) { return a.second < b.second; });
      EXPECT_TRUE(same(sumOf(values), expected)) << "rising";
      std::reverse(values.begin(), values.end());
      EXPECT_TRUE(same(sumOf(values), expected)) << "falling";
      // Sums of sums of sums.
      std::vector<BinnedSum> sums;
      for (const Value& value : values) sums.push_back(sumOf({value}));
      while (sums.size() > 1) {
        const auto at = static_cast<std::size_t>(random() * double(sums.size() - 1));
        sums[at].add(sums.back());
        sums.pop_back();
      }
      EXPECT_TRUE(same(sums[0], expected)) << "in groups";
    }
  }
}

TEST(BinnedSum, NothingIsZero) {
  BinnedSum sum;
  EXPECT_TRUE(sum.zero());
  sum.add(0.0, 100);
  sum.add(-0.0, -5000);
  sum.add(BinnedSum());
  EXPECT_TRUE(same(sum, BinnedSum())) << "zeros leave no trace";
  EXPECT_EQ(sum.scaled().value, 0.0);
  EXPECT_EQ(sum.value(), 0.0L);
  sum.add(3.0, 7);
  sum.add(-3.0, 7);
  EXPECT_TRUE(sum.zero());
  EXPECT_EQ(sum.value(), 0.0L);
}

TEST(BinnedSum, IntegersAreSummedExactly) {
  Uniforms random(2);
  for (int round = 0; round < 50; ++round) {
    const auto exponent = static_cast<int>(200.0 * random() - 100.0);
    int64_t expected = 0;
    BinnedSum sum;
    for (int i = 0; i < 500; ++i) {
      const auto value = static_cast<int64_t>((2.0 * random() - 1.0) * 0x1p52);
      expected += value;
      sum.add(static_cast<double>(value), exponent);
    }
    EXPECT_EQ(sum.value(), std::ldexp(static_cast<long double>(expected), exponent));
    const Scaled scaled = sum.scaled();
    EXPECT_EQ(std::ldexp(scaled.value, scaled.exponent - exponent), static_cast<double>(expected));
  }
}

TEST(BinnedSum, PositiveSumsAreRight) {
  Uniforms random(3);
  for (const double decades : {1.0, 5.0, 60.0}) {
    long double expected = 0.0L;
    BinnedSum sum;
    for (int i = 0; i < 10000; ++i) {
      const double value = std::pow(10.0, decades * (random() - 0.5));
      expected += value;
      sum.add(value, 0);
    }
    EXPECT_NEAR(static_cast<double>(sum.value() / expected), 1.0, 1e-16);
  }
}

/// Every place of the mantissa within the bins, 2^30 times, by doubling: nothing overflows.
TEST(BinnedSum, ManyOfTheLargest) {
  for (int shift = 0; shift < 64; ++shift) {
    for (const double value : {0x1.fffffffffffffp0, -0x1.fffffffffffffp0, 1.0, -0x1p-1074}) {
      BinnedSum sum = sumOf({{value, shift}});
      for (int i = 0; i < 30; ++i) sum.add(BinnedSum(sum));
      EXPECT_EQ(sum.value(), std::ldexp(static_cast<long double>(value), shift + 30)) << shift;
      BinnedSum last = sum;  // 2^31 - 1 of them
      for (int i = 0; i < 30; ++i) {
        BinnedSum part = sumOf({{value, shift}});
        for (int k = 0; k < i; ++k) part.add(BinnedSum(part));
        last.add(part);
      }
      EXPECT_EQ(last.value(), static_cast<long double>(value) * std::ldexp(2147483647.0L, shift));
    }
  }
}

/// Neither the exponents that come on top nor those of doubles themselves have an end.
TEST(BinnedSum, MagnitudesBeyondDoubles) {
  const Scaled large = sumOf({{1.5e308, 3000}, {1.5e308, 3000}}).scaled();
  EXPECT_EQ(std::ldexp(large.value, large.exponent - 3001), 1.5e308);
  const Scaled small = sumOf({{5e-324, -3000}, {5e-324, -3000}, {5e-324, -3000}}).scaled();
  EXPECT_EQ(std::ldexp(small.value, small.exponent + 3000), 1.5e-323);
  EXPECT_EQ(sumOf({{5e-324, 0}, {1e-310, 0}}).value(),
            static_cast<long double>(5e-324) + static_cast<long double>(1e-310));
}

/// What is too small beside the largest counts for nothing, even if the largest goes away again.
TEST(BinnedSum, TheSmallestIsDropped) {
  const std::vector<Value> values = {{1.0, 0}, {1.0, 1000}, {-1.0, 1000}};
  EXPECT_TRUE(sumOf(values).zero());
  EXPECT_TRUE(same(sumOf(values), sumOf({values[1], values[2], values[0]})));
  // All 53 bits of the largest count, and what others have in their places.
  for (int shift = 0; shift < 32; ++shift) {
    const BinnedSum sum = sumOf({{1.0, shift}, {1.0, shift - 52}, {-1.0, shift}});
    EXPECT_EQ(sum.value(), std::ldexp(1.0L, shift - 52)) << shift;
  }
}

TEST(BinnedSum, ComesBackFromItsBins) {
  Uniforms random(4);
  const BinnedSum sum = sumOf(someValues(random, 50, 40.0));
  EXPECT_TRUE(same(BinnedSum(sum.bins(), sum.top()), sum));
}

}  // namespace
}  // namespace awd
