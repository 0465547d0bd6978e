// SPDX-License-Identifier: Apache-2.0
// awd-bench refit: coefficients by least squares against the projections.
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "command_line.h"
#include "commands.h"
#include "failure.h"
#include "interrupt.h"
#include "plot.h"
#include "refit_densities.h"
#include "refit_plots.h"
#include "refit_scenes.h"
#include "refit_summary.h"
#include "report.h"
#include "write_file.h"

namespace bench {
namespace {

struct Options {
  std::string folder;
  std::vector<std::string> parts;
  refit::PartOptions densities;
  refit::SceneOptions scenes;
};

bool wanted(const Options& options, const char* part) {
  return options.parts.empty() ||
         std::find(options.parts.begin(), options.parts.end(), part) != options.parts.end();
}

/// A line of progress on standard error: rewritten on a terminal, else one each tenth.
class Progress {
 public:
  explicit Progress(const char* what) : what_(what), terminal_(isatty(STDERR_FILENO) == 1) {}
  ~Progress() {
    if (terminal_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(std::size_t done, std::size_t all) {
    const std::size_t tenth = 10 * done / all;
    if (terminal_) {
      std::fprintf(stderr, "\r%s: %zu of %zu", what_, done, all);
    } else if (tenth != shown_) {
      std::fprintf(stderr, "%s: %zu of %zu\n", what_, done, all);
    }
    shown_ = tenth;
  }

 private:
  const char* what_;
  bool terminal_;
  std::size_t shown_ = static_cast<std::size_t>(-1);
};

Row headOf(const Options& options) {
  return {{"command", commandLine()},
          {"quick", options.densities.quick},
          {"complete", !command::wasInterrupted()}};
}

ReportSection newSection() {
  ReportSection section("refit", "Coefficients by least squares, or by projection");
  section.paragraph(
      "Coefficients of a density can be fitted to its samples by least squares (refit-descent, "
      "refit-ceres), or estimated by projections, which need no solver: quasi, a density's "
      "default, mixture and ratio, and that of the paper. Lower variance and error are better; "
      "in tables of errors relative to quasi, quasi is 1.");
  section.command(commandLine());
  return section;
}

#ifdef AWD_BENCH_SCENES
void compareRenders(const Options& options, const std::vector<refit::Method>& methods,
                    ReportSection& section) {
  Progress progress("render");
  refit::SceneOptions scenes = options.scenes;
  scenes.quick = options.densities.quick;
  scenes.folder = options.folder;
  const std::vector<Row> rows = refit::measureScenes(
      methods, scenes,
      [&](std::size_t done, std::size_t all) {
        progress.show(done, all);
        return !command::wasInterrupted();
      },
      command::wasInterrupted);
  writeRows(headOf(options), rows, options.folder, "refit-render");
  refit::printScenes(rows, section);
  refit::plotScenes(rows, section);
}
#else
void compareRenders(const Options&, const std::vector<refit::Method>&, ReportSection&) {
  std::fprintf(stderr, "built without the renderer: no scenes are rendered\n");
}
#endif

int run(const Options& options) {
  std::filesystem::create_directories(options.folder);
  command::checkWritable((std::filesystem::path(options.folder) / "refit.json").string());
  command::catchInterrupt();
  const awdtest::Device device = awdtest::newDevice(1);
  const std::vector<refit::Method> methods = refit::availableMethods(device);

  ReportSection section = newSection();
  std::vector<Row> rows;
  for (const refit::Part part : refit::kParts) {
    if (!wanted(options, nameOf(part)) || command::wasInterrupted()) continue;
    Progress progress(nameOf(part));
    const std::vector<Row> more = measurePart(device, methods, part, options.densities,
                                              [&](std::size_t done, std::size_t all) {
                                                progress.show(done, all);
                                                return !command::wasInterrupted();
                                              });
    rows.insert(rows.end(), more.begin(), more.end());
    // After each part: what is lost to whatever ends the program is one of them.
    writeRows(headOf(options), rows, options.folder, "refit");
    refit::printSummary(part, more, section);
    std::fflush(stdout);
  }
  refit::plotDensities(rows, section);
  if (wanted(options, "render") && !command::wasInterrupted()) {
    compareRenders(options, methods, section);
  }
  writeReport(options.folder, section);
  return command::wasInterrupted() ? command::kInterrupted : 0;
}

}  // namespace

void addRefitCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "refit", "Coefficients by least squares against the projections: error, variance and time");
  command->add_flag("--quick", options->densities.quick, "A few cells of each kind");
  command->add_option("--out", options->folder, "Folder for tables and a section of index.html")
      ->required();
  command->add_option("--parts", options->parts, "Some of shrinkage,first,adaptive,time,render")
      ->delimiter(',')
      ->check(CLI::IsMember({"shrinkage", "first", "adaptive", "time", "render"}));
  command
      ->add_option("--dimensions", options->densities.dimensions, "Of densities; default 1,2,3,4")
      ->delimiter(',')
      ->check(CLI::Range(1, 4));
  command->add_option("--scenes", options->scenes.moreScenes,
                      "A folder of folders with a scene file each, besides our own");
  command->add_option("--samples", options->scenes.samples, "A pixel; default 16,64,256")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000000));
  command->add_option("--reference-samples", options->scenes.referenceSamples, "Default 8192")
      ->check(CLI::Range(1, 10000000));
  command->add_option("--seeds", options->scenes.seeds, "Of renders; default 5")
      ->check(CLI::Range(1, 1000));
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace bench
