// SPDX-License-Identifier: Apache-2.0
#include "util/error.h"

#include <gtest/gtest.h>

namespace {

TEST(Error, FailFormatsAndKeepsTheCode) {
  try {
    awd::fail(AWD_ERROR_IO, "can't read \"%s\", item %d of %zu", "a%b", 3, std::size_t{7});
    FAIL() << "returned";
  } catch (const awd::Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_IO);
    EXPECT_STREQ(error.what(), "can't read \"a%b\", item 3 of 7");
  }
}

TEST(Error, IsAnExceptionLikeAnyOther) {
  EXPECT_THROW(awd::fail(AWD_ERROR_UNKNOWN, "x"), std::exception);
}

TEST(Error, ALongTextIsCutNotOverrun) {
  const std::string longText(100000, 'x');
  try {
    awd::fail(AWD_ERROR_UNKNOWN, "%s", longText.c_str());
  } catch (const awd::Error& error) {
    const std::string text = error.what();
    EXPECT_GE(text.size(), 500u);
    EXPECT_LT(text.size(), longText.size());
    EXPECT_EQ(text, longText.substr(0, text.size()));
  }
}

}  // namespace
