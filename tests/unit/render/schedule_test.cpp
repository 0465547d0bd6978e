// SPDX-License-Identifier: Apache-2.0
#include "render/schedule.h"

#include <gtest/gtest.h>

#include <numeric>

#include "util/error.h"

namespace awd {
namespace {

using Passes = std::pmr::vector<uint32_t>;

Passes plan(uint32_t total, AWDPreset preset, bool learns = true) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = total;
  return planPasses(std::pmr::get_default_resource(), schedule, preset, learns);
}

TEST(Schedule, PaperIsThreeTimesTenAndSeventy) {
  EXPECT_EQ(plan(0, AWD_PRESET_PAPER), (Passes{10, 10, 10, 70}));
  EXPECT_EQ(plan(50, AWD_PRESET_PAPER), (Passes{5, 5, 5, 35}));
}

TEST(Schedule, DividesEveryTotalWithoutLoss) {
  for (const AWDPreset preset : {AWD_PRESET_DEFAULT, AWD_PRESET_PAPER}) {
    for (uint32_t total = 1; total < 2000; ++total) {
      const Passes passes = plan(total, preset);
      EXPECT_EQ(std::accumulate(passes.begin(), passes.end(), 0u), total);
      for (const uint32_t pass : passes) EXPECT_GE(pass, 1u);
    }
  }
  EXPECT_EQ(plan(15, AWD_PRESET_DEFAULT), (Passes{1, 1, 1, 2, 2, 2, 6}));
  EXPECT_EQ(plan(0xFFFFFFFFu, AWD_PRESET_DEFAULT).size(), 91u);
}

TEST(Schedule, OnePassWhereNothingIsLearned) {
  EXPECT_EQ(plan(64, AWD_PRESET_DEFAULT, false), (Passes{64}));
}

TEST(Schedule, TakesTheHostsNumbers) {
  const uint32_t numbers[] = {3, 1, 2};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.samplesPerPass = numbers;
  schedule.passCount = 3;
  EXPECT_EQ(planPasses(std::pmr::get_default_resource(), schedule, AWD_PRESET_DEFAULT, true),
            (Passes{3, 1, 2}));
}

TEST(Schedule, QualitiesAskForLessErrorWithMoreSamples) {
  AWDSchedule before = AWD_SCHEDULE_INIT;
  before.error = 1.0;
  for (AWDQuality quality = AWD_QUALITY_DRAFT; quality <= AWD_QUALITY_REFERENCE; ++quality) {
    const AWDSchedule schedule = qualitySchedule(quality);
    EXPECT_EQ(schedule.structSize, sizeof schedule);
    EXPECT_GT(schedule.error, 0.0);
    EXPECT_LT(schedule.error, before.error);
    EXPECT_GT(schedule.totalSamples, before.totalSamples);
    EXPECT_EQ(schedule.samplesPerPass, nullptr);
    EXPECT_EQ(schedule.seconds, 0.0);
    before = schedule;
  }
}

TEST(Schedule, RefusesContradictions) {
  const uint32_t numbers[] = {3, 0};
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  const auto refused = [&] {
    EXPECT_THROW(planPasses(std::pmr::get_default_resource(), schedule, AWD_PRESET_DEFAULT, true),
                 Error);
  };
  schedule.passCount = 2;
  refused();  // no numbers
  schedule.samplesPerPass = numbers;
  refused();  // a pass of 0
  schedule.passCount = 1;
  schedule.totalSamples = 3;
  refused();  // both ways at once
}

}  // namespace
}  // namespace awd
