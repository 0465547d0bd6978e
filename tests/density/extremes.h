// SPDX-License-Identifier: Apache-2.0
// What no input may do to a density: cases, each with what is to come of it. Through the C
// interface, and without a test framework, so that a program can print them as a table.
#pragma once

#include <string>
#include <vector>

namespace awdtest {

struct Outcome {
  bool ok;
  std::string seen;  ///< figures, or what went wrong first
};

struct Extreme {
  const char* name;
  const char* expected;
  Outcome (*run)();  ///< throws std::exception when a call fails
};

const std::vector<Extreme>& extremes();

}  // namespace awdtest
