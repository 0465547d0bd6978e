// SPDX-License-Identifier: Apache-2.0
// awd: renders scene files, and handles images and bases. Exit codes: 0 done, 1 failed, 2 misused,
// 130 interrupted.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "awd/awd.h"
#include "commands.h"
#include "console.h"
#include "failure.h"

namespace {

using namespace command;

std::string joined(int count, char** words) {
  std::string line = "awd";
  for (int i = 1; i < count; ++i) line += std::string(" ") + words[i];
  return line;
}

int run(int argumentCount, char** arguments) {
  CLI::App program("Adaptive wavelet densities: renders scenes by guided path tracing", "awd");
  program.set_version_flag("--version", "awd " + std::to_string(AWD_VERSION_MAJOR) + '.' +
                                            std::to_string(AWD_VERSION_MINOR) + '.' +
                                            std::to_string(AWD_VERSION_PATCH));
  program.require_subcommand(0, 1);
  program.get_formatter()->column_width(28);
  program.failure_message([](const CLI::App*, const CLI::Error& error) {
    return std::string("awd: ") + error.what() + " (--help tells more)\n";
  });
  Action action;
  addRenderCommand(program, action, joined(argumentCount, arguments));
  addPngCommand(program, action);
  addCompareCommand(program, action);
  addBasesCommand(program, action);
  addCheckBasisCommand(program, action);
  try {
    program.parse(argumentCount, arguments);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? kDone : kMisused;
  }
  if (!action)
    throw UsageError(
        "say what to do: render, png, compare, bases or check-basis (--help tells more)");
  return action();
}

}  // namespace

int main(int argumentCount, char** arguments) {
  int code = kFailed;
  try {
    code = run(argumentCount, arguments);
  } catch (const UsageError& error) {
    complain(error.what());
    code = kMisused;
  } catch (const std::bad_alloc&) {
    complain("out of memory");
  } catch (const std::exception& error) {
    complain(error.what());
  }
  // A full disk shows only now.
  if (std::fflush(stdout) != 0 || std::ferror(stdout)) {
    complain("can't write to standard output");
    if (code == kDone) code = kFailed;
  }
  return code;
}
