// SPDX-License-Identifier: Apache-2.0
#include "util/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "util/random.h"

namespace awd {
namespace {

TEST(Sobol, ReversesBits) {
  EXPECT_EQ(reverseBits(1u), 0x80000000u);
  EXPECT_EQ(reverseBits(0x0000000du), 0xb0000000u);
  for (uint32_t i = 0; i < 1000; ++i) {
    const auto x = static_cast<uint32_t>(mixBits(i));
    EXPECT_EQ(reverseBits(reverseBits(x)), x);
  }
}

// Against the direction numbers v_k = v_{k-1} xor v_{k-1} / 2, v_0 = 1/2, of the polynomial x + 1.
TEST(Sobol, SecondDimensionIsThatOfItsDirectionNumbers) {
  for (uint32_t i = 0; i < 2000; ++i) {
    const auto index = i < 1000 ? i : static_cast<uint32_t>(mixBits(i));
    uint32_t direction = 0x80000000u, y = 0;
    for (uint32_t k = 0; k < 32; ++k, direction ^= direction >> 1) {
      if (index >> k & 1u) y ^= direction;
    }
    EXPECT_EQ(reverseBits(secondSobolReversed(index)), y) << index;
  }
}

TEST(Sobol, ScramblingChangesABitByLowerOnesAlone) {
  for (uint32_t i = 0; i < 500; ++i) {
    const auto x = static_cast<uint32_t>(mixBits(i));
    const auto seed = static_cast<uint32_t>(mixBits(i) >> 32);
    for (uint32_t bit = 0; bit < 32; ++bit) {
      const uint32_t changed = scrambleReversed(x, seed) ^ scrambleReversed(x ^ 1u << bit, seed);
      EXPECT_EQ(changed & ((2u << bit) - 1u), 1u << bit) << "bit " << bit;
    }
  }
}

TEST(Sobol, EveryDyadicRectangleHasItsPoint) {
  for (uint32_t trial = 0; trial < 20; ++trial) {
    const auto seed = [&](uint32_t i) { return static_cast<uint32_t>(mixBits(10 * trial + i)); };
    for (uint32_t k = 1; k <= 8; ++k) {
      const uint32_t first = (trial % 4) << k;  // blocks later in the sequence too
      for (uint32_t a = 0; a <= k; ++a) {
        std::set<uint64_t> cells;
        for (uint32_t i = 0; i < 1u << k; ++i) {
          const SobolPoint p = sobolPoint(first + i, seed(0), seed(1), seed(2));
          ASSERT_TRUE(p.x >= 0.0 && p.x < 1.0 && p.y >= 0.0 && p.y < 1.0);
          cells.insert(static_cast<uint64_t>(std::ldexp(p.x, static_cast<int>(a))) << 32 |
                       static_cast<uint64_t>(std::ldexp(p.y, static_cast<int>(k - a))));
        }
        EXPECT_EQ(cells.size(), 1u << k) << "2^" << a << " columns of 2^" << k << " points";
      }
    }
  }
}

// Null hypothesis: over random seeds the point of any index is uniform on the square. Pearson's
// chi-square on 16 x 16 cells, 255 degrees of freedom: above 360 with probability 1.5e-5 in each
// of 4 tests. Fixed seeds.
TEST(Sobol, EachPointIsUniformOverSeeds) {
  constexpr int kSamples = 100000;
  for (const uint32_t index : {0u, 1u, 5u, 1000003u}) {
    std::vector<int> counts(256, 0);
    for (int i = 0; i < kSamples; ++i) {
      const uint64_t seed = mixBits(3000u * index + 7u * static_cast<uint64_t>(i));
      const SobolPoint p =
          sobolPoint(index, static_cast<uint32_t>(mixBits(seed)), static_cast<uint32_t>(seed),
                     static_cast<uint32_t>(seed >> 32));
      ++counts[static_cast<std::size_t>(16 * p.x) * 16 + static_cast<std::size_t>(16 * p.y)];
    }
    double chi2 = 0.0;
    for (const int count : counts) {
      const double expected = kSamples / 256.0;
      chi2 += (count - expected) * (count - expected) / expected;
    }
    EXPECT_LT(chi2, 360.0) << "index " << index;
  }
}

}  // namespace
}  // namespace awd
