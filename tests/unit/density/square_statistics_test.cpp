// SPDX-License-Identifier: Apache-2.0
#include "density/square_statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

TEST(SquareStatistics, CountsAndSums) {
  SquareStatistics statistics(memory(), 2, SquareStatistics::unitExponentFor(1.0));
  statistics.record(0, 1.5);
  statistics.record(0, 0.0);
  statistics.record(1, 0.25);
  EXPECT_EQ(statistics.count(0), 2u);
  EXPECT_EQ(statistics.sum(0), 1.5);
  EXPECT_EQ(statistics.sum(1), 0.25);
  EXPECT_EQ(statistics.samples(), 3u);
  EXPECT_EQ(statistics.largest(), 1.5);
}

TEST(SquareStatistics, OrderAndThreadsChangeNoBit) {
  Uniforms random(13);
  std::vector<std::pair<std::size_t, double>> records(20000);
  for (auto& [component, value] : records) {
    component = static_cast<std::size_t>(random() * 4);
    value = std::pow(10.0, 12.0 * random() - 9.0);
  }
  const int unit = SquareStatistics::unitExponentFor(1.0);
  SquareStatistics forward(memory(), 4, unit);
  for (const auto& [component, value] : records) forward.record(component, value);
  SquareStatistics threaded(memory(), 4, unit);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (std::size_t i = records.size(); i-- > 0;) {
        if (i % 4 == t) threaded.record(records[i].first, records[i].second);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  SquareStatistics half(memory(), 4, unit), sum(memory(), 4, unit);
  for (std::size_t i = 0; i < records.size(); ++i) {
    (i % 2 ? half : sum).record(records[i].first, records[i].second);
  }
  sum.add(half);
  for (const SquareStatistics* other : {&threaded, &sum}) {
    for (std::size_t c = 0; c < 4; ++c) {
      EXPECT_EQ(forward.count(c), other->count(c));
      EXPECT_EQ(forward.sum(c), other->sum(c));
    }
    EXPECT_EQ(forward.largest(), other->largest());
    EXPECT_EQ(forward.saturated(), other->saturated());
  }
}

TEST(SquareStatistics, RejectsWhatIsNoRadiance) {
  SquareStatistics statistics(memory(), 1, SquareStatistics::unitExponentFor(1.0));
  statistics.record(0, std::numeric_limits<double>::quiet_NaN());
  statistics.record(0, std::numeric_limits<double>::infinity());
  statistics.record(0, -1.0);
  statistics.record(0, 2.0);
  EXPECT_EQ(statistics.rejected(), 3u);
  EXPECT_EQ(statistics.count(0), 4u);  // they stay in the count, as zeros
  EXPECT_EQ(statistics.sum(0), 2.0);
}

TEST(SquareStatistics, KeepsNineDigitsAtAnyMagnitude) {
  for (const double magnitude : {1e-300, 5e-324, 1e-30, 1.0, 1e30, 1e300}) {
    SquareStatistics statistics(memory(), 1, SquareStatistics::unitExponentFor(magnitude));
    for (int i = 0; i < 1000; ++i) statistics.record(0, magnitude);
    EXPECT_NEAR(statistics.sum(0) / magnitude / 1000, 1.0, 1e-9) << magnitude;
    EXPECT_EQ(statistics.saturated(), 0u);
    EXPECT_FALSE(statistics.overflowed());
  }
}

TEST(SquareStatistics, ClampsTowersAndSaysSo) {
  SquareStatistics statistics(memory(), 1, SquareStatistics::unitExponentFor(1.0));
  statistics.record(0, 1e30);
  EXPECT_EQ(statistics.saturated(), 1u);
  EXPECT_EQ(statistics.largest(), 1e30);
  EXPECT_EQ(statistics.sum(0), 0x1p20);
  // Past the end of the sum once, and then around it: what has overflowed stays so.
  for (int i = 0; i < 6000; ++i) statistics.record(0, 1e30);
  EXPECT_TRUE(statistics.overflowed());
  statistics.clear();
  EXPECT_EQ(statistics.samples(), 0u);
  EXPECT_FALSE(statistics.overflowed());
}

}  // namespace
}  // namespace awd
