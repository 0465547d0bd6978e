// SPDX-License-Identifier: Apache-2.0
// The cases of extremes.h, a test each.
#include "density/extremes.h"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>

namespace awdtest {

// As GoogleTest names it.
static void PrintTo(const Extreme& extreme, std::ostream* out) { *out << extreme.name; }

namespace {

class Extremes : public testing::TestWithParam<Extreme> {};

INSTANTIATE_TEST_SUITE_P(All, Extremes, testing::ValuesIn(extremes()), [](const auto& extreme) {
  std::string name;
  for (const char c : std::string(extreme.param.name)) {
    name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  }
  return name;
});

TEST_P(Extremes, ComeOutAsExpected) {
  const Outcome outcome = GetParam().run();
  EXPECT_TRUE(outcome.ok) << "expected: " << GetParam().expected << "; seen: " << outcome.seen;
  RecordProperty("seen", outcome.seen);
}

}  // namespace
}  // namespace awdtest
