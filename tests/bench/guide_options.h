// SPDX-License-Identifier: Apache-2.0
// The command line that `awd-bench guide` and `awd-bench rival` share.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "guide_scenes.h"

namespace bench::guide {

/// What a command compares.
struct Choice {
  const char* name;                  ///< of the command, and of the files that it writes
  std::vector<std::string> methods;  ///< by default, the baseline first
  std::function<void()> list;        ///< prints the methods that there are
  std::function<Contender(const std::string& method)> contender;  ///< throws if there is none
  std::string note;  ///< printed first, unless it is ""
};

/// Adds the options to a command, which sets `action` if it is called.
void addOptions(CLI::App& command, Action& action, Choice choice,
                const std::shared_ptr<Options>& options);

}  // namespace bench::guide
