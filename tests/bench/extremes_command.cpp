// SPDX-License-Identifier: Apache-2.0
// awd-bench extremes: what no input may do to a density, as a table. The cases are those of
// tests/density.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "commands.h"
#include "density/extremes.h"

namespace bench {
namespace {

awdtest::Outcome outcomeOf(const awdtest::Extreme& extreme) {
  try {
    return extreme.run();
  } catch (const std::exception& error) {
    return {false, error.what()};
  }
}

int run() {
  std::printf("%-40s  %-48s  %-4s  %s\n", "case", "expected", "", "seen");
  bool good = true;
  for (const awdtest::Extreme& extreme : awdtest::extremes()) {
    const awdtest::Outcome outcome = outcomeOf(extreme);
    good = good && outcome.ok;
    std::printf("%-40s  %-48s  %-4s  %s\n", extreme.name, extreme.expected,
                outcome.ok ? "ok" : "BAD", outcome.seen.c_str());
  }
  return good ? 0 : 1;
}

}  // namespace

void addExtremesCommand(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("extremes", "What densities make of extreme input; 1 if any is wrong");
  command->callback([&action] { action = run; });
}

}  // namespace bench
