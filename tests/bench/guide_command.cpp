// SPDX-License-Identifier: Apache-2.0
// awd-bench guide: efficiency of guided rendering against a baseline.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "failure.h"
#include "guide_methods.h"
#include "guide_scenes.h"
#include "interrupt.h"
#include "write_file.h"

namespace bench {
namespace {

int list() {
  for (const guide::Method& method : guide::methods()) {
    std::printf("%-22s  %s\n", method.name, method.what);
  }
  return 0;
}

int run(const guide::Options& options) {
  if (!options.folder.empty()) {
    std::filesystem::create_directories(options.folder);
    command::checkWritable((std::filesystem::path(options.folder) / "guide.json").string());
  }
  command::catchInterrupt();
  guide::Report report(options.folder, {{"command", "awd-bench guide"},
                                        {"baseline", options.names.front()},
                                        {"threads", options.threads}});
  const bool complete = guide::measureScenes(options, report, command::wasInterrupted);
  report.write(complete);
  return complete ? 0 : command::kInterrupted;
}

}  // namespace

void addGuideCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<guide::Options>();
  auto onlyList = std::make_shared<bool>(false);
  CLI::App* command = program.add_subcommand(
      "guide", "Efficiency of guided rendering: error against CPU time, training included");
  command->add_flag("--list", *onlyList, "Print the methods that there are");
  command
      ->add_option("--methods", options->names,
                   "The baseline, and what is compared with it; default cosine,adaptive")
      ->delimiter(',');
  command->add_option("--scenes", options->moreScenes,
                      "A folder of folders with a scene file each, besides our own");
  command->add_option("--only", options->only, "These scenes alone, by name")->delimiter(',');
  command->add_option("--samples", options->samples, "A pixel; default 32,64,128,256,512")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  command->add_option("--seeds", options->seeds, "Default 5")->check(CLI::Range(1, 1000));
  command->add_option("--threads", options->threads, "Default 1")->check(CLI::Range(1, 65536));
  CLI::Option* out =
      command->add_option("--out", options->folder, "Folder for guide.json and guide.csv");
  CLI::Option* references =
      command->add_option("--references", options->references,
                          "A folder with SCENE-*.exr, independent unguided renders of equal\n"
                          "length: they are averaged, their variance is taken off the squared\n"
                          "errors, and images have their size. Without it: reference.exr beside\n"
                          "the scene, else one that is made and kept in the folder of --out");
  command->add_option("--width", options->width, "Pixels, without --references; default 128")
      ->check(CLI::Range(1, 65536))
      ->excludes(references);
  command
      ->add_option("--reference-samples", options->referenceSamples,
                   "A pixel, without --references; default 8192")
      ->check(CLI::Range(1, 10000000))
      ->excludes(references);
  command->footer(
      "Efficiency: 1 / (relMSE without the worst 0.1 % of pixels x CPU seconds). The table has\n"
      "medians over seeds; efficiencies, also those from the untrimmed relMSE and from L1^2, and\n"
      "rays a CPU second are ratios to the baseline's of the same seed.");
  command->callback([&action, options, onlyList, out, references] {
    if (!*onlyList && out->empty() && references->empty()) {
      throw CLI::RequiredError("--out or --references");
    }
    action = [options, onlyList] { return *onlyList ? list() : run(*options); };
  });
}

}  // namespace bench
