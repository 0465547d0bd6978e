// SPDX-License-Identifier: Apache-2.0
// The subcommands. A new one is a file of its own, a line here and one in main.cpp. Each describes
// its options; if it is the one that was called, parsing leaves in `action` what to do, which
// returns an exit code.
#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace bench {

using Action = std::function<int()>;

void addDensityCommand(CLI::App& program, Action& action);
void addExtremesCommand(CLI::App& program, Action& action);
#ifdef AWD_BENCH_SCENES
void addGuideCommand(CLI::App& program, Action& action);
void addPaperCommand(CLI::App& program, Action& action);
void addRivalCommand(CLI::App& program, Action& action);
void addScaleCommand(CLI::App& program, Action& action);
void addTradeCommand(CLI::App& program, Action& action);
#endif
void addRefitCommand(CLI::App& program, Action& action);
void addWaveletsCommand(CLI::App& program, Action& action);
#ifdef AWD_BENCH_GOOGLE
void addSpeedCommand(CLI::App& program, Action& action);
#endif

}  // namespace bench
