// SPDX-License-Identifier: Apache-2.0
// What no input may do to the library: a case, with what is to come of it. Without a test
// framework, so that a program can print cases as a table.
#pragma once

#include <cctype>
#include <exception>
#include <string>

namespace awdtest {

struct Outcome {
  bool ok;
  std::string seen;  ///< figures, or what went wrong first
};

struct Extreme {
  const char* name;
  const char* expected;
  Outcome (*run)();   ///< throws std::exception when a call fails
  bool slow = false;  ///< takes more than a second or two
};

/// A call that fails is an outcome, too.
inline Outcome outcomeOf(const Extreme& extreme) {
  try {
    return extreme.run();
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

/// As GoogleTest names it.
inline std::string testNameOf(const Extreme& extreme) {
  std::string name;
  for (const char* c = extreme.name; *c; ++c) {
    name += std::isalnum(static_cast<unsigned char>(*c)) ? *c : '_';
  }
  return name + (extreme.slow ? "Slow" : "");
}

}  // namespace awdtest
