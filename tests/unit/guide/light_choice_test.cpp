// SPDX-License-Identifier: Apache-2.0
#include "guide/light_choice.h"

#include <gtest/gtest.h>

#include <numeric>

namespace awd {
namespace {

std::pmr::memory_resource* memory() { return std::pmr::get_default_resource(); }

Ref<LightChoice> prior(std::vector<float> powers) {
  return LightChoice::make(memory(), powers.data(), powers.size());
}

TEST(LightChoice, BeginsByPower) {
  const auto choice = prior({1.0f, 0.0f, 3.0f, 0.0f});
  EXPECT_FLOAT_EQ(choice->chance(0), 0.25f);
  EXPECT_EQ(choice->chance(1), 0.0f);
  EXPECT_FLOAT_EQ(choice->chance(2), 0.75f);
  EXPECT_EQ(choice->chance(3), 0.0f);
  EXPECT_EQ(choice->magnitude(), 0.0);
  EXPECT_EQ(choice->choose(0.0).light, 0u);
  EXPECT_EQ(choice->choose(0.25).light, 2u);
  EXPECT_EQ(choice->choose(1.0 - 0x1p-53).light, 2u);
}

/// Chances are the widths of what chooses them, and the rest is uniform again.
TEST(LightChoice, ChoosesByItsChances) {
  const auto choice = prior({5.0f, 1.0f, 1e-3f, 2.0f});
  constexpr int kSteps = 100000;
  std::vector<double> counts(4), rests(4);
  for (int i = 0; i < kSteps; ++i) {
    const LightChoice::Chosen chosen = choice->choose((i + 0.5) / kSteps);
    ASSERT_EQ(chosen.chance, choice->chance(chosen.light));
    ASSERT_TRUE(chosen.rest >= 0.0 && chosen.rest < 1.0);
    ++counts[chosen.light];
    rests[chosen.light] += chosen.rest;
  }
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(counts[i] / kSteps, static_cast<double>(choice->chance(i)), 1.5 / kSteps);
    EXPECT_NEAR(rests[i] / counts[i], 0.5, 0.1);
  }
}

/// 1e-60 of all power is a chance as a double, and none as the float that a host divides by.
TEST(LightChoice, NeverChoosesWhatHasNoChance) {
  const auto choice = prior({1e-30f, 1e30f, 1e-30f});
  for (const double u : {0.0, 1e-300, 0.5, 1.0 - 0x1p-53}) {
    const LightChoice::Chosen chosen = choice->choose(u);
    EXPECT_EQ(chosen.light, 1u);
    EXPECT_EQ(chosen.chance, 1.0f);
  }
  EXPECT_EQ(choice->chance(0), 0.0f);
}

/// Two strata of a uniform: (1 + (1 - 2^-53)) / 2 is 1 in doubles.
TEST(LightChoice, TakesAUniformThatWasRoundedToOne) {
  const auto choice = prior({1.0f, 2.0f, 0.0f});
  const LightChoice::Chosen chosen = choice->choose((1.0 + (1.0 - 0x1p-53)) / 2.0);
  EXPECT_EQ(chosen.light, 1u);
  EXPECT_LT(chosen.rest, 1.0);
}

/// What was too bright for doubles does not outlive a split that forgets it.
TEST(LightChoice, ForgetsWhatIsInfinite) {
  const auto start = prior({1.0f, 1.0f});
  LightSums bright(memory(), 2, LightSums::unitExponentFor(1e200));
  for (int i = 0; i < 10; ++i) bright.record(0, 1e200);
  const auto infinite = start->learn(*start, bright, 1.0);
  LightSums usual(memory(), 2, LightSums::unitExponentFor(1.0));
  usual.record(0, 1.0);
  const auto next = infinite->learn(*start, usual, 0.0);
  EXPECT_NEAR(next->magnitude(), 1.0, 1e-3);
}

TEST(LightChoice, LearnsTheRootMeanSquares) {
  const auto before = prior({1.0f, 1.0f, 2.0f});
  LightSums sums(memory(), 3, LightSums::unitExponentFor(1.0));
  for (int i = 0; i < 400; ++i) sums.record(0, i % 4 == 0 ? 2.0 : 0.0);  // root mean square 1
  for (int i = 0; i < 200; ++i) sums.record(1, 3.0);
  for (int i = 0; i < 40; ++i) sums.record(2, 0.0);
  const auto after = before->learn(*before, sums, 1.0);
  EXPECT_NEAR(after->magnitude(), 4.0, 1e-6);
  const double trust = 0.95 * 640.0 / 672.0;
  EXPECT_NEAR(after->chance(0), trust * 0.25 + (1.0 - trust) * 0.25, 1e-6);
  EXPECT_NEAR(after->chance(1), trust * 0.75 + (1.0 - trust) * 0.25, 1e-6);
  EXPECT_NEAR(after->chance(2), (1.0 - trust) * 0.5, 1e-6);

  // Twice as much of the same is known as after both at once; forgotten, only the second counts.
  LightSums both(memory(), 3, LightSums::unitExponentFor(1.0));
  both.add(sums);
  both.add(sums);
  EXPECT_TRUE(*after->learn(*before, sums, 1.0) == *before->learn(*before, both, 1.0));
  EXPECT_TRUE(*after->learn(*before, sums, 0.0) == *after);
}

TEST(LightChoice, DarkOrHugeLightLeavesThePrior) {
  const auto before = prior({1.0f, 3.0f});
  LightSums dark(memory(), 2, LightSums::unitExponentFor(1.0));
  for (int i = 0; i < 1000; ++i) dark.record(0, 0.0);
  EXPECT_TRUE(*before->learn(*before, dark, 1.0) == *before);
  LightSums huge(memory(), 2, LightSums::unitExponentFor(1e300));
  for (int i = 0; i < 1000; ++i) huge.record(0, 1e300);
  EXPECT_TRUE(*before->learn(*before, huge, 1.0) == *before);
}

}  // namespace
}  // namespace awd
