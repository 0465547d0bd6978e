// SPDX-License-Identifier: Apache-2.0
// How the program fails: by an exception, which main() turns into a line and an exit code.
#pragma once

#include <stdexcept>
#include <string>

#include "awd/awd.hpp"

namespace command {

enum ExitCode { kDone = 0, kFailed = 1, kMisused = 2, kInterrupted = 130 };

/// Something is wrong with the world: a file, the memory, the scene.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Something is wrong with the command line.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What `call` returns; if it fails, a Failure of the library's message after "what: ".
template <class Call>
auto named(const std::string& what, Call&& call) {
  try {
    return call();
  } catch (const awd::Error& error) {
    throw Failure(what + ": " + error.what());
  }
}

/// A text in double quotes.
std::string inQuotes(const std::string& text);

}  // namespace command
