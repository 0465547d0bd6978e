// SPDX-License-Identifier: Apache-2.0
// The table of functions is that of the headers.
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "misuse/caller.h"
#include "misuse/headers.h"

namespace {

using namespace awdmisuse;

std::set<std::string> declared() {
  const std::regex function("AWD_CALL\\s+(awd[A-Z]\\w*)\\s*\\(");
  std::set<std::string> names;
  const std::string headers = textOfHeaders();
  for (std::sregex_iterator match(headers.begin(), headers.end(), function), end; match != end;
       ++match) {
    names.insert((*match)[1]);
  }
  return names;
}

TEST(Listed, EveryFunctionOfTheHeaders) {
  std::set<std::string> listed;
  for (const Function& function : allFunctions()) {
    EXPECT_TRUE(listed.insert(function.name).second) << function.name << " is listed twice";
  }
  EXPECT_EQ(listed, declared());
  EXPECT_GT(listed.size(), 100u);
}

}  // namespace
