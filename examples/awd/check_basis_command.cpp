// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "awd/awd.hpp"
#include "commands.h"
#include "failure.h"

namespace command {
namespace {

/// A line for every check, below the name of its family.
class Table {
 public:
  void operator()(const AWDBasisCheck& check) {
    if (family_ != static_cast<int64_t>(check.index)) {
      family_ = check.index;
      std::printf("%s%s\n  %-20s %10s %10s\n", check.index > 0 ? "\n" : "",
                  *check.family ? check.family : "(no name)", "check", "worst", "limit");
    }
    std::printf("  %-20s %10.3g %10.3g  %s\n", check.name, check.worst, check.limit,
                check.status == AWD_SUCCESS ? "ok" : "FAILED");
    if (check.status != AWD_SUCCESS) std::printf("    %s\n", check.message);
  }

 private:
  int64_t family_ = -1;
};

int checkBasis(const std::string& file) {
  awd::checkBasisModule(std::filesystem::absolute(file), Table());
  return kDone;
}

}  // namespace

void addCheckBasisCommand(CLI::App& program, Action& action) {
  auto file = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("check-basis", "Test a basis module: every check with its figure");
  command->add_option("FILE", *file, "The module, a .so file")->required();
  command->callback([&action, file] { action = [file] { return checkBasis(*file); }; });
}

}  // namespace command
