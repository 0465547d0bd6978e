// SPDX-License-Identifier: Apache-2.0
// awd-bench guide: efficiency of guided rendering against a baseline.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "commands.h"
#include "guide_methods.h"
#include "guide_options.h"

namespace bench {
namespace {

void list() {
  for (const guide::Method& method : guide::methods()) {
    std::printf("%-22s  %s\n", method.name, method.what);
  }
}

guide::Contender contender(const std::string& name) {
  const guide::Method& method = guide::methodNamed(name);
  Settings settings;
  method.change(settings);
  return {method.name,
          [settings](const awd::Device&, const LoadedScene& loaded, uint32_t samples, uint64_t seed,
                     Shot& shot) { return shoot(loaded, settings, samples, seed, shot); }};
}

}  // namespace

void addGuideCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<guide::Options>();
  CLI::App* command = program.add_subcommand(
      "guide", "Efficiency of guided rendering: error against CPU time, training included");
  command->add_option("--threads", options->threads, "Default 1")->check(CLI::Range(1, 65536));
  guide::addOptions(*command, action, {"guide", {"cosine", "adaptive"}, list, contender, ""},
                    options);
}

}  // namespace bench
