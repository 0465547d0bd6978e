// SPDX-License-Identifier: Apache-2.0
#include "basis/self_test.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#include "tables.h"

namespace {

using namespace awd;

std::string failedSentence(const AWDBasisFamily& family) {
  const std::vector<Check> checks = selfTest(family);
  const Check* failure = firstFailure(checks);
  return failure ? failure->sentence() : "";
}

TEST(SelfTest, HonestFamiliesPassWithRoomToSpare) {
  for (const AWDBasisFamily* family :
       {&test::haar(), &test::linear(), &test::linearPeriodic(), &test::quadratic()}) {
    const std::vector<Check> checks = selfTest(*family);
    EXPECT_GE(checks.size(), 13u);
    for (const Check& check : checks) {
      EXPECT_TRUE(check.ok()) << family->name << ": " << check.sentence();
      EXPECT_EQ(check.sentence(), "");
      // Rounding, or a Kolmogorov-Smirnov distance at half of what is allowed.
      EXPECT_LE(check.worst(), 0.5 * check.limit()) << family->name << ": " << check.name();
    }
    EXPECT_EQ(firstFailure(checks), nullptr);
  }
}

TEST(SelfTest, ChecksGoOnAfterAFailureWithTheirFigures) {
  AWDBasisFamily family = test::linear();
  family.weight = [](uint32_t level, uint32_t j) { return test::linear().weight(level, j) * 1.5; };
  const std::vector<Check> checks = selfTest(family);
  EXPECT_EQ(checks.size(), selfTest(test::linear()).size());
  int failures = 0;
  for (const Check& check : checks) failures += !check.ok();
  EXPECT_EQ(failures, 1) << "the weights alone: their sums scale with them";
  ASSERT_NE(firstFailure(checks), nullptr);
  EXPECT_STREQ(firstFailure(checks)->name(), "weight");
  EXPECT_NEAR(firstFailure(checks)->worst(), 0.5, 0.01) << "of a cell";
}

TEST(SelfTest, WhatOthersStandOnEndsIt) {
  AWDBasisFamily family = test::linear();
  family.order = 9;
  EXPECT_EQ(selfTest(family).size(), 1u);
  family = test::linear();
  family.cells = [](uint32_t) { return 0u; };
  EXPECT_EQ(selfTest(family).size(), 2u);
}

TEST(SelfTest, TheTableIsLookedAtBeforeItIsCalled) {
  const auto refused = [](void (*change)(AWDBasisFamily&), const char* sentence) {
    AWDBasisFamily family = test::linear();
    change(family);
    EXPECT_EQ(failedSentence(family), sentence);
  };
  const char* const names = "name does not match ^[a-z][a-z0-9_.-]{0,63}$";
  refused([](AWDBasisFamily& f) { f.name = nullptr; }, names);
  refused([](AWDBasisFamily& f) { f.name = ""; }, names);
  refused([](AWDBasisFamily& f) { f.name = "9lives"; }, names);
  refused([](AWDBasisFamily& f) { f.name = "a/../b"; }, names);
  refused(
      [](AWDBasisFamily& f) {
        f.name = "a234567890123456789012345678901234567890123456789012345678901234x";
      },
      names);
  refused([](AWDBasisFamily& f) { f.name = "a.b_c-d9"; }, "");
  const char* const line = "summary is not a line of at most 200 characters";
  refused([](AWDBasisFamily& f) { f.summary = nullptr; }, line);
  refused([](AWDBasisFamily& f) { f.summary = "two\nlines"; }, line);
  refused([](AWDBasisFamily& f) { f.order = 0; }, "order is 0: it must be 1 to 8");
  refused([](AWDBasisFamily& f) { f.sampleDims = 0; }, "sampleDims is 0: it must be 1 to 8");
  refused([](AWDBasisFamily& f) { f.sampleDims = 9; }, "sampleDims is 9: it must be 1 to 8");
  refused([](AWDBasisFamily& f) { f.minLevel = 21; },
          "levels 21 to 20: they must be an ascending range up to 20");
  refused([](AWDBasisFamily& f) { f.maxLevel = 21; },
          "levels 0 to 21: they must be an ascending range up to 20");
  refused([](AWDBasisFamily& f) { f.flags = 8; }, "flags 0x8: only 0x7 are known");
  refused([](AWDBasisFamily& f) { f.sample = nullptr; }, "a function of the table is NULL");
}

TEST(SelfTest, SizesThatWouldEatTheMemoryAreRefused) {
  AWDBasisFamily family = test::linear();
  family.cells = [](uint32_t level) { return level == 7 ? 0x80000000u : 1u << level; };
  EXPECT_EQ(failedSentence(family),
            "cells out of range: level 7: got 2147483648, want 1 to 2097152");
  family.cells = [](uint32_t) { return 0u; };
  EXPECT_EQ(failedSentence(family), "cells out of range: level 0: got 0, want 1 to 4096");
  family = test::linear();
  family.count = [](uint32_t level) { return (2u << level) + 1; };
  EXPECT_EQ(failedSentence(family), "count out of range: level 0: got 3, want 1 to 2");
  family.count = [](uint32_t) { return 0u; };
  EXPECT_EQ(failedSentence(family), "count out of range: level 0: got 0, want 1 to 2");
  family = test::linear();
  family.minLevel = 13;
  EXPECT_EQ(failedSentence(family), "cells out of range: level 13: got 8192, want 1 to 4096");
}

TEST(SelfTest, LevelsThatBeginFurtherUp) {
  AWDBasisFamily family = test::linear();
  family.minLevel = 10;
  EXPECT_EQ(failedSentence(family), "");
  family.minLevel = family.maxLevel = 12;
  EXPECT_EQ(failedSentence(family), "");
}

TEST(SelfTest, WorkIsBounded) {
  static std::atomic<uint64_t> calls;
  calls = 0;
  AWDBasisFamily family = test::linear();
  family.eval = [](uint32_t level, double x, uint32_t* first, double* values) {
    ++calls;
    return test::linear().eval(level, x, first, values);
  };
  EXPECT_EQ(failedSentence(family), "");
  EXPECT_LT(calls, 200000u);
}

}  // namespace
