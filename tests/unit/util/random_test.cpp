// SPDX-License-Identifier: Apache-2.0
#include "util/random.h"

#include <gtest/gtest.h>

#include <set>

namespace awd {
namespace {

TEST(RandomStream, IsAFunctionOfItsCounters) {
  RandomStream a(1, 2, 3, 4), b(1, 2, 3, 4);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(a.next(), b.next());
}

TEST(RandomStream, DiffersInEachCounter) {
  std::set<double> firsts;
  for (uint64_t i = 0; i < 1000; ++i) {
    firsts.insert(RandomStream(i, 0, 0, 0).next());
    if (i == 0) continue;
    firsts.insert(RandomStream(0, i, 0, 0).next());
    firsts.insert(RandomStream(0, 0, i, 0).next());
    firsts.insert(RandomStream(0, 0, 0, i).next());
  }
  EXPECT_EQ(firsts.size(), 3997u);
}

// Null hypothesis: numbers are uniform on [0,1)^2, both for successive dimensions of one path and
// for one dimension of successive samples. 16 x 16 bins, 255 degrees of freedom; chi-square above
// 350 has probability 7e-5 in each of the two tests.
TEST(RandomStream, FillsTheSquareEvenly) {
  constexpr int kPoints = 256 * 400;
  for (const bool alongPath : {true, false}) {
    int counts[256] = {};
    RandomStream path(7, 0, 0, 0);
    for (int i = 0; i < kPoints; ++i) {
      RandomStream sample(7, 0, 5, static_cast<uint64_t>(i));
      RandomStream neighbour(7, 0, 6, static_cast<uint64_t>(i));
      const double x = alongPath ? path.next() : sample.next();
      const double y = alongPath ? path.next() : neighbour.next();
      ASSERT_TRUE(x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0);
      ++counts[static_cast<int>(x * 16) * 16 + static_cast<int>(y * 16)];
    }
    double chi2 = 0.0;
    for (const int count : counts) chi2 += (count - 400.0) * (count - 400.0) / 400.0;
    EXPECT_LT(chi2, 350.0);
    EXPECT_GT(chi2, 175.0) << "too even to be random";
  }
}

}  // namespace
}  // namespace awd
