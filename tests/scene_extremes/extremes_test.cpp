// SPDX-License-Identifier: Apache-2.0
// The cases of extremes.h, a test each.
#include "scene_extremes/extremes.h"

#include <gtest/gtest.h>

#include <ostream>

namespace awdtest {

// As GoogleTest names it.
static void PrintTo(const Extreme& extreme, std::ostream* out) { *out << extreme.name; }

namespace {

class SceneExtremes : public testing::TestWithParam<Extreme> {};

INSTANTIATE_TEST_SUITE_P(All, SceneExtremes, testing::ValuesIn(sceneExtremes()),
                         [](const auto& extreme) { return testNameOf(extreme.param); });

TEST_P(SceneExtremes, ComeOutAsExpected) {
  const Outcome outcome = outcomeOf(GetParam());
  EXPECT_TRUE(outcome.ok) << "expected: " << GetParam().expected << "; seen: " << outcome.seen;
  RecordProperty("seen", outcome.seen);
}

}  // namespace
}  // namespace awdtest
