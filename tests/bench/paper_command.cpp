// SPDX-License-Identifier: Apache-2.0
// awd-bench paper: the tables and figures of Pietrek and Peter 1999, on our scenes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "failure.h"
#include "interrupt.h"
#include "paper.h"
#include "write_file.h"

namespace bench {
namespace {

struct Part {
  const char* name;
  void (*measure)(paper::Study& study);
};

constexpr Part kParts[] = {
    {"passes", paper::measurePasses},       {"quality", paper::measureQuality},
    {"bands", paper::measureBands},
#ifdef AWD_BENCH_EIGEN
    {"radiosity", paper::measureRadiosity},
#endif
    {"questions", paper::measureQuestions},
};

std::string commandLine(const paper::Options& options) {
  std::string line = "awd-bench paper --out DIR --parts " + CLI::detail::join(options.parts, ",");
  if (options.quick) line += " --quick";
  if (!options.only.empty()) line += " --only " + CLI::detail::join(options.only, ",");
  if (!options.references.empty()) line += " --references REFERENCES";
  line += " --threads " + std::to_string(options.threads);
  if (options.quick) return line;  // settles what is below
  return line + " --seeds " + std::to_string(options.seeds) + " --width " +
         std::to_string(options.width) + " --reference-samples " +
         std::to_string(options.referenceSamples);
}

int run(const paper::Options& options) {
  std::filesystem::create_directories(options.folder);
  command::checkWritable((std::filesystem::path(options.folder) / "paper.json").string());
  command::catchInterrupt();
  const awd::Device device = newRenderDevice(options.threads, command::wasInterrupted);
  paper::Study study = {options, device, ReportSection("paper", "Pietrek and Peter 1999"), {}};
  study.section.paragraph(
      "The paper that the library begins with. It guides a path tracer by densities in a basis of "
      "boxes (Haar) or of hats (linear B-splines), one for each planar piece of the scene, which "
      "learn in three passes of 10 samples a pixel before the last of 70, and compares them with "
      "directions drawn uniformly and by the cosine. Here that is done on scenes of ours, to its "
      "letter (the preset paper); published figures stand beside ours, and what the library does "
      "by itself is called our defaults.");
  study.section.command(commandLine(options));
  bool complete = true;
  try {
    for (const Part& part : kParts) {
      const auto& parts = options.parts;
      if (std::find(parts.begin(), parts.end(), part.name) != parts.end()) part.measure(study);
    }
  } catch (const paper::Cancelled&) {
    complete = false;
    study.section.paragraph("Interrupted: parts are missing.");
  }
  writeRows({{"command", commandLine(options)},
             {"seeds", options.seeds},
             {"threads", options.threads},
             {"width", options.width},
             {"complete", complete}},
            study.rows, options.folder, "paper");
  writeReport(options.folder, study.section);
  return complete ? 0 : command::kInterrupted;
}

void makeQuick(paper::Options& options) {
  options.quick = true;
  options.seeds = 2;
  options.width = 32;
  options.referenceSamples = 1024;
}

}  // namespace

void addPaperCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<paper::Options>();
  CLI::App* command = program.add_subcommand(
      "paper", "The tables and figures of Pietrek and Peter 1999, and its open questions");
  command->add_option("--out", options->folder, "Folder for paper.json, paper.csv and the report")
      ->required();
  std::vector<std::string> parts;
  for (const Part& part : kParts) parts.push_back(part.name);
  options->parts = parts;
  command->add_option("--parts", options->parts, "Of " + CLI::detail::join(parts, ",") + "; all")
      ->delimiter(',')
      ->check(CLI::IsMember(parts));
  command->add_option("--only", options->only, "Scenes of the part quality, by name; all")
      ->delimiter(',');
  command->add_option("--references", options->references,
                      "A folder with SCENE-*.exr, as for guide; images have their size");
  CLI::Option* seeds = command->add_option("--seeds", options->seeds, "Default 5");
  seeds->check(CLI::Range(1, 1000));
  command->add_option("--threads", options->threads, "Default 1")->check(CLI::Range(1, 65536));
  CLI::Option* width = command->add_option("--width", options->width, "Pixels; default 64");
  width->check(CLI::Range(1, 65536));
  CLI::Option* samples = command->add_option("--reference-samples", options->referenceSamples,
                                             "A pixel, without --references; default 4096");
  samples->check(CLI::Range(2, 10000000));
  CLI::Option* quick = command->add_flag(
      "--quick", "Two scenes of 32 x 32 pixels, two seeds, coarse elements, fewer cells");
  quick->excludes(seeds)->excludes(width)->excludes(samples);
  command->callback([&action, options, quick] {
    if (*quick) makeQuick(*options);
    action = [options] { return run(*options); };
  });
}

}  // namespace bench
