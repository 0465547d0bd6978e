// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "awd/basis.h"
#include "commands.h"
#include "device.h"
#include "failure.h"
#include "statistics_json.h"

namespace command {
namespace {

using nlohmann::json;

struct BasesOptions {
  DeviceOptions device;
  bool json = false;
};

void printJson(const std::vector<AWDBasisInfo>& bases) {
  json usable = json::array(), rejected = json::array();
  for (const AWDBasisInfo& basis : bases) {
    if (basis.status == AWD_SUCCESS) {
      usable.push_back({{"name", basis.name},
                        {"summary", basis.summary},
                        {"file", basis.file},
                        {"order", basis.order},
                        {"min_level", basis.minLevel},
                        {"max_level", basis.maxLevel},
                        {"orthogonal", (basis.flags & AWD_BASIS_ORTHOGONAL) != 0},
                        {"periodic", (basis.flags & AWD_BASIS_PERIODIC) != 0},
                        {"nested", (basis.flags & AWD_BASIS_NESTED) != 0}});
    } else {
      rejected.push_back({{"name", basis.name},
                          {"file", basis.file},
                          {"result", awd::resultString(basis.status)},
                          {"reason", basis.message}});
    }
  }
  std::fputs(toText({{"bases", usable}, {"rejected", rejected}}).c_str(), stdout);
}

void printText(const std::vector<AWDBasisInfo>& bases) {
  for (const AWDBasisInfo& basis : bases) {
    if (basis.status == AWD_SUCCESS) {
      std::printf("%s: %s\n  %s\n  order %u, levels %u to %u%s%s%s\n", basis.name, basis.summary,
                  *basis.file ? basis.file : "(registered from memory)", basis.order,
                  basis.minLevel, basis.maxLevel,
                  basis.flags & AWD_BASIS_ORTHOGONAL ? ", orthogonal" : "",
                  basis.flags & AWD_BASIS_PERIODIC ? ", periodic" : "",
                  basis.flags & AWD_BASIS_NESTED ? ", nested" : "");
    } else {
      std::printf("rejected: %s\n  %s\n  %s: %s\n", *basis.name ? basis.name : "(no name)",
                  basis.file, awd::resultString(basis.status), basis.message);
    }
  }
  if (bases.empty()) std::puts("There are no bases.");
}

int list(const BasesOptions& options) {
  const awd::Device device = openDevice(options.device);
  const std::vector<AWDBasisInfo> bases = device.bases();
  options.json ? printJson(bases) : printText(bases);
  return kDone;
}

}  // namespace

void addBasesCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<BasesOptions>();
  CLI::App* command =
      program.add_subcommand("bases", "List bases, and rejected candidates with the reason");
  command
      ->add_option("--basis-path", options->device.basisPaths,
                   "Look for bases in this folder first; may be repeated")
      ->allow_extra_args(false);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&action, options] { action = [options] { return list(*options); }; });
}

}  // namespace command
