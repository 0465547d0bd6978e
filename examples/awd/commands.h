// SPDX-License-Identifier: Apache-2.0
// The subcommands. Each add...Command describes its options; if it is the one that was called,
// parsing leaves in `action` what to do, which returns an exit code.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>

namespace command {

using Action = std::function<int()>;

/// commandLine: as it was called, kept in the image.
void addRenderCommand(CLI::App& program, Action& action, const std::string& commandLine);
void addPngCommand(CLI::App& program, Action& action);
void addCompareCommand(CLI::App& program, Action& action);
void addBasesCommand(CLI::App& program, Action& action);
void addCheckBasisCommand(CLI::App& program, Action& action);

}  // namespace command
