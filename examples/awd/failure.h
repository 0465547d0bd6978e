// SPDX-License-Identifier: Apache-2.0
// How the program fails: by an exception, which main() turns into a line and an exit code.
#pragma once

#include <stdexcept>
#include <string>

#include "awd/awd.h"

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

/// Throws the library's message as a Failure, after "what: " unless that is empty.
void check(AWDResult result, const std::string& what = "");

/// A text in double quotes.
std::string inQuotes(const std::string& text);

}  // namespace command
