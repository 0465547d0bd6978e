// SPDX-License-Identifier: Apache-2.0
// The table of functions is that of the headers.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "misuse/caller.h"

namespace {

std::set<std::string> declared() {
  const std::regex function("AWD_CALL\\s+(awd[A-Z]\\w*)\\s*\\(");
  std::set<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(AWD_TEST_INCLUDE "/awd")) {
    if (file.path().extension() != ".h") continue;
    std::ostringstream text;
    text << std::ifstream(file.path()).rdbuf();
    const std::string header = text.str();
    for (std::sregex_iterator match(header.begin(), header.end(), function), end; match != end;
         ++match) {
      names.insert((*match)[1]);
    }
  }
  return names;
}

TEST(Listed, EveryFunctionOfTheHeaders) {
  std::set<std::string> listed;
  for (const awdmisuse::Function& function : awdmisuse::allFunctions()) {
    EXPECT_TRUE(listed.insert(function.name).second) << function.name << " is listed twice";
  }
  EXPECT_EQ(listed, declared());
  EXPECT_GT(listed.size(), 100u);
}

}  // namespace
