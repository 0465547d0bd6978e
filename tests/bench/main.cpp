// SPDX-License-Identifier: Apache-2.0
// awd-bench: measures what libawd claims. Exit codes: 0 done, 1 failed, 2 misused.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "command_line.h"
#include "commands.h"

namespace {

using AddCommand = void (*)(CLI::App& program, bench::Action& action);

constexpr AddCommand kCommands[] = {
    bench::addDensityCommand,  bench::addExtremesCommand, bench::addRefitCommand,
    bench::addWaveletsCommand,
#ifdef AWD_BENCH_SCENES
    bench::addGuideCommand,    bench::addRivalCommand,    bench::addPaperCommand,
    bench::addScaleCommand,    bench::addTradeCommand,
#endif
#ifdef AWD_BENCH_GOOGLE
    bench::addSpeedCommand,
#endif
};

int run(int argumentCount, char** arguments) {
  bench::setCommandLine(argumentCount, arguments);
  CLI::App program("Figures about libawd, and about its peers where they are installed",
                   "awd-bench");
  program.require_subcommand(1);
  bench::Action action;
  for (const AddCommand add : kCommands) add(program, action);
  try {
    program.parse(argumentCount, arguments);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : 2;
  }
  return action();
}

}  // namespace

int main(int argumentCount, char** arguments) {
  int code = 1;
  try {
    code = run(argumentCount, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "awd-bench: %s\n", error.what());
  }
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    std::fprintf(stderr, "awd-bench: can't write to standard output\n");
    if (code == 0) code = 1;
  }
  return code;
}
