// SPDX-License-Identifier: Apache-2.0
// awd-bench trade: what accuracy costs, and which combinations are worth it.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "failure.h"
#include "guide_methods.h"
#include "interrupt.h"
#include "trade_methods.h"
#include "trade_quality.h"
#include "trade_report.h"
#include "write_file.h"

namespace bench {
namespace {

struct Options {
  guide::Options scenes;
  std::vector<std::string> methods = trade::defaultMethods();
  std::vector<std::string> qualities;
  std::vector<double> targets{0.3, 0.1, 0.03};
  bool list = false, quick = false;

  Options() { scenes.samples = {8, 32, 128}, scenes.seeds = 3; }
};

/// Few cells of the same kind, in tens of seconds.
void makeQuick(Options& options) {
  options.scenes.only = {"ceiling-lamp", "verification"};
  options.scenes.samples = {8, 16, 64};
  options.scenes.seeds = 1;
  options.scenes.width = 32;
  options.scenes.referenceSamples = 1024;
  options.methods = {"cosine", "adaptive", "haar", "level-2", "quasi"};
  options.qualities = {"draft"};
}

std::string commandLine(const Options& options) {
  if (options.quick) return "awd-bench trade --quick --out DIR";
  const guide::Options& scenes = options.scenes;
  std::string text = "awd-bench trade --out DIR --methods " +
                     CLI::detail::join(options.methods, ",") + " --samples " +
                     CLI::detail::join(scenes.samples, ",") + " --seeds " +
                     std::to_string(scenes.seeds) + " --threads " + std::to_string(scenes.threads);
  if (!options.qualities.empty()) {
    text += " --quality " + CLI::detail::join(options.qualities, ",");
  }
  text += " --targets " + CLI::detail::join(options.targets, ",");
  if (!scenes.only.empty()) text += " --only " + CLI::detail::join(scenes.only, ",");
  if (!scenes.references.empty()) return text + " --references DIR";
  return text + " --width " + std::to_string(scenes.width) + " --reference-samples " +
         std::to_string(scenes.referenceSamples);
}

int list() {
  for (const guide::Method& method : guide::methods()) {
    std::printf("%-22s  %s\n", method.name, method.what);
  }
  std::printf("several at once: haar+quasi\n");
  return 0;
}

int run(Options options) {
  if (options.list) return list();
  if (options.quick) makeQuick(options);
  std::sort(options.scenes.samples.begin(), options.scenes.samples.end());
  std::vector<guide::Contender> contenders;
  for (const std::string& method : options.methods) contenders.push_back(trade::contender(method));
  const std::string& folder = options.scenes.folder;
  std::filesystem::create_directories(folder);
  command::checkWritable((std::filesystem::path(folder) / "trade.json").string());
  command::catchInterrupt();
  guide::Report report("", "trade", {});
  trade::Findings findings;
  const bool complete =
      guide::measureScenes(options.scenes, contenders, report, command::wasInterrupted) &&
      trade::measureQualities(options.scenes, options.qualities, command::wasInterrupted,
                              findings.qualities);
  findings.head = {{"command", commandLine(options)},
                   {"baseline", options.methods.front()},
                   {"threads", options.scenes.threads},
                   {"seeds", options.scenes.seeds},
                   {"complete", complete}};
  findings.planes = trade::planesOf(report.rows(), options.methods.front(), options.targets);
  print(findings);
  write(findings, folder);
  return complete ? 0 : command::kInterrupted;
}

}  // namespace

void addTradeCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  guide::Options& scenes = options->scenes;
  CLI::App* command = program.add_subcommand(
      "trade", "Speed against accuracy: the front, when guiding pays, time to an error");
  command->add_flag("--list", options->list, "Print the methods that there are");
  command->add_flag("--quick", options->quick, "Five methods, two scenes, small images, one seed");
  command
      ->add_option("--methods", options->methods,
                   "The baseline, and what is compared with it; several at once as haar+quasi")
      ->delimiter(',');
  command
      ->add_option("--quality", options->qualities,
                   "Also measure what these take, and whether they keep their promises")
      ->delimiter(',')
      ->check(CLI::IsMember(trade::qualityNames()));
  command
      ->add_option("--targets", options->targets,
                   "Trimmed relMSE to be reached; default 0.3,0.1,"
                   "0.03")
      ->delimiter(',')
      ->check(CLI::PositiveNumber);
  command->add_option("--scenes", scenes.moreScenes,
                      "A folder of folders with a scene file each, besides our own");
  command->add_option("--only", scenes.only, "These scenes alone, by name")->delimiter(',');
  command->add_option("--samples", scenes.samples, "A pixel; default 8,32,128")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seeds", scenes.seeds, "Default 3")->check(CLI::Range(1, 1000));
  command->add_option("--threads", scenes.threads, "Default 1")->check(CLI::Range(1, 65536));
  CLI::Option* references = command->add_option("--references", scenes.references,
                                                "A folder with SCENE-*.exr, as for guide");
  command->add_option("--width", scenes.width, "Pixels, without --references; default 128")
      ->check(CLI::Range(1, 65536))
      ->excludes(references);
  command
      ->add_option("--reference-samples", scenes.referenceSamples,
                   "A pixel, without --references; default 8192")
      ->check(CLI::Range(1, 10000000))
      ->excludes(references);
  CLI::Option* out = command->add_option("--out", scenes.folder,
                                         "Folder for trade.json, trade.csv and the report");
  command->callback([&action, options, out] {
    if (!options->list && out->empty()) throw CLI::RequiredError("--out");
    action = [options] { return run(*options); };
  });
}

}  // namespace bench
