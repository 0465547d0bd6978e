// SPDX-License-Identifier: Apache-2.0
#include "basis/check.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

TEST(Check, KeepsTheWorstFigureAndTheFirstViolation) {
  awd::Check check("sum", 0.5);
  EXPECT_FALSE(check.fails(0.25));
  EXPECT_FALSE(check.fails(0.5));
  EXPECT_TRUE(check.ok());
  EXPECT_EQ(check.worst(), 0.5);
  EXPECT_TRUE(check.fails(0.75));
  check.say("at %d", 3);
  EXPECT_FALSE(check.fails(2.0)) << "only the first is told";
  EXPECT_FALSE(check.ok());
  EXPECT_EQ(check.worst(), 2.0);
  EXPECT_EQ(check.sentence(), "at 3");
  EXPECT_STREQ(check.name(), "sum");
  EXPECT_EQ(check.limit(), 0.5);
}

TEST(Check, NaNFails) {
  awd::Check check("value", 1.0);
  EXPECT_TRUE(check.fails(NAN));
  EXPECT_FALSE(check.ok());
  EXPECT_TRUE(std::isinf(check.worst()));
}

TEST(Check, InfinityFailsAndMinusInfinityDoesNot) {
  awd::Check check("value", 1.0);
  EXPECT_FALSE(check.fails(-INFINITY));
  EXPECT_TRUE(check.fails(INFINITY));
}

TEST(Check, BrokenIsTheFirstViolationOrNone) {
  awd::Check first("a", 1.0);
  first.broken("no figure");
  EXPECT_FALSE(first.ok());
  EXPECT_EQ(first.sentence(), "no figure");
  awd::Check second("b", 1.0);
  EXPECT_TRUE(second.fails(3.0));
  second.say("too large");
  second.broken("no figure");
  EXPECT_EQ(second.sentence(), "too large");
}

}  // namespace
