// SPDX-License-Identifier: Apache-2.0
#include "guide_options.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>

#include "command_line.h"
#include "failure.h"
#include "interrupt.h"
#include "write_file.h"

namespace bench::guide {
namespace {

int run(const Choice& choice, const Options& options) {
  std::vector<Contender> contenders;
  for (const std::string& method : choice.methods) contenders.push_back(choice.contender(method));
  if (!options.folder.empty()) {
    std::filesystem::create_directories(options.folder);
    const std::string file = std::string(choice.name) + ".json";
    command::checkWritable((std::filesystem::path(options.folder) / file).string());
  }
  if (!choice.note.empty()) std::printf("%s\n", choice.note.c_str());
  command::catchInterrupt();
  Report report(options.folder, choice.name,
                {{"command", commandLine()},
                 {"baseline", choice.methods.front()},
                 {"threads", options.threads}});
  const bool complete = measureScenes(options, contenders, report, command::wasInterrupted);
  report.write(complete);
  return complete ? 0 : command::kInterrupted;
}

/// What is small enough for seconds; what was asked for stays.
void makeQuick(const CLI::App& command, Options& options) {
  const auto given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  if (!given("--only")) options.only = {"cornell-box", "two-rooms", "verification"};
  if (!given("--samples")) options.samples = {8, 32};
  if (!given("--seeds")) options.seeds = 2;
  if (!given("--width")) options.width = 64;
  if (!given("--reference-samples")) options.referenceSamples = 1024;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(text.empty() ? "" : ",").append(name);
  return text;
}

}  // namespace

void addOptions(CLI::App& command, Action& action, Choice choice,
                const std::shared_ptr<Options>& options) {
  auto chosen = std::make_shared<Choice>(std::move(choice));
  auto onlyList = std::make_shared<bool>(false);
  auto quick = std::make_shared<bool>(false);
  command.add_flag("--quick", *quick, "A few small cells, but for what is asked for");
  command.add_flag("--list", *onlyList, "Print the methods that there are");
  command
      .add_option("--methods", chosen->methods,
                  "The baseline, and what is compared with it; default " + joined(chosen->methods))
      ->delimiter(',');
  command.add_option("--scenes", options->moreScenes,
                     "A folder of folders with a scene file each, besides our own");
  command.add_option("--only", options->only, "These scenes alone, by name")->delimiter(',');
  command
      .add_option("--samples", options->samples,
                  "A pixel; default " + CLI::detail::join(options->samples, ","))
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  command.add_option("--seeds", options->seeds, "Default " + std::to_string(options->seeds))
      ->check(CLI::Range(1, 1000));
  CLI::Option* out = command.add_option("--out", options->folder,
                                        std::string("Folder for ") + chosen->name + ".json, " +
                                            chosen->name + ".csv and a section of index.html");
  CLI::Option* references =
      command.add_option("--references", options->references,
                         "A folder with SCENE-*.exr, independent unguided renders of equal\n"
                         "length: they are averaged, their variance is taken off the squared\n"
                         "errors, and images have their size. Without it: reference.exr beside\n"
                         "the scene, else one that is made and kept in the folder of --out");
  command.add_option("--width", options->width, "Pixels, without --references; default 128")
      ->check(CLI::Range(1, 65536))
      ->excludes(references);
  command
      .add_option("--reference-samples", options->referenceSamples,
                  "A pixel, without --references; default 8192")
      ->check(CLI::Range(1, 10000000))
      ->excludes(references);
  command.footer(
      "Efficiency: 1 / (relMSE without the worst 0.1 % of pixels x CPU seconds). The table has\n"
      "medians over seeds; efficiencies, also those from the untrimmed relMSE and from L1^2, and\n"
      "rays a CPU second are ratios to the baseline's of the same seed.");
  command.callback([&action, &command, chosen, options, onlyList, quick, out, references] {
    if (*quick) makeQuick(command, *options);
    if (!*onlyList && out->empty() && references->empty()) {
      throw CLI::RequiredError("--out or --references");
    }
    action = [chosen, options, onlyList] {
      if (!*onlyList) return run(*chosen, *options);
      chosen->list();
      return 0;
    };
  });
}

}  // namespace bench::guide
