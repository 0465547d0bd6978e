// SPDX-License-Identifier: Apache-2.0
#include "schedule.h"

#include <gtest/gtest.h>

#include "failure.h"

using namespace command;

namespace {

using Numbers = std::vector<uint32_t>;

TEST(Schedule, NothingGivenLeavesItToThePreset) {
  const Schedule schedule = makeSchedule({}, {}, {});
  EXPECT_TRUE(schedule.samplesPerPass.empty());
  EXPECT_EQ(schedule.totalSamples, 0u);
}

TEST(Schedule, NumbersGiveThePasses) {
  EXPECT_EQ(makeSchedule({}, "4", {}).samplesPerPass, (Numbers{4}));
  EXPECT_EQ(makeSchedule({}, "1,2,30", {}).samplesPerPass, (Numbers{1, 2, 30}));
  EXPECT_EQ(makeSchedule(3, "1,2,30", {}).samplesPerPass, (Numbers{1, 2, 30}));
}

TEST(Schedule, OneNumberHoldsForAllPasses) {
  EXPECT_EQ(makeSchedule(3, "5", {}).samplesPerPass, (Numbers{5, 5, 5}));
}

TEST(Schedule, TotalIsLeftToTheLibrary) {
  const Schedule schedule = makeSchedule({}, {}, 64);
  EXPECT_TRUE(schedule.samplesPerPass.empty());
  EXPECT_EQ(schedule.totalSamples, 64u);
}

TEST(Schedule, RefusesContradictions) {
  EXPECT_THROW(makeSchedule(2, "1,2,3", {}), UsageError);
  EXPECT_THROW(makeSchedule(4, "1,2,3", {}), UsageError);
  EXPECT_THROW(makeSchedule({}, "4", 64), UsageError);
  EXPECT_THROW(makeSchedule(2, {}, 64), UsageError);
  EXPECT_THROW(makeSchedule(2, {}, {}), UsageError);
}

TEST(Schedule, RefusesWhatIsNoListOfNumbers) {
  for (const char* list : {"", ",", "4,", ",4", "4,,4", "0", "4,0", "-1", "4.5", "4 4", "x", "4x",
                           "4294967296", "+4"}) {
    EXPECT_THROW(makeSchedule({}, list, {}), UsageError) << '"' << list << '"';
  }
}

}  // namespace
