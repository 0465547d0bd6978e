// SPDX-License-Identifier: Apache-2.0
// awd-bench extremes: what no input may do to a density, nor a scene to a render, as a table. The
// cases are those of tests/density and tests/scene_extremes.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "commands.h"
#include "density/extremes.h"
#include "report.h"
#include "row.h"
#ifdef AWD_BENCH_SCENES
#include "scene_extremes/extremes.h"
#endif

namespace bench {
namespace {

using awdtest::Extreme;
using awdtest::Outcome;

struct Options {
  bool quick = false;
  std::string folder;
};

constexpr const char* kCommand = "awd-bench extremes --out DIR";

void runAll(const char* of, const std::vector<Extreme>& extremes, const Options& options,
            std::vector<Row>& rows) {
  for (const Extreme& extreme : extremes) {
    if (options.quick && extreme.slow) continue;
    const auto start = std::chrono::steady_clock::now();
    const Outcome outcome = awdtest::outcomeOf(extreme);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%-8s %-42s  %-48s  %-4s  %s\n", of, extreme.name, extreme.expected,
                outcome.ok ? "ok" : "BAD", outcome.seen.c_str());
    std::fflush(stdout);
    rows.push_back({{"of", of},
                    {"case", extreme.name},
                    {"expected", extreme.expected},
                    {"ok", outcome.ok},
                    {"seen", outcome.seen},
                    {"seconds", seconds.count()}});
  }
}

void report(const Options& options, const std::vector<Row>& rows, std::size_t bad) {
  std::filesystem::create_directories(options.folder);
  writeRows({{"command", kCommand}, {"quick", options.quick}, {"bad", bad}}, rows, options.folder,
            "extremes");
  ReportSection section("extremes", "Extreme input");
  section.paragraph(
      "What no input may do to a density, nor a scene to a render. What is expected is known in "
      "advance: by analysis, as that in a closed room of albedo a whose walls emit e every "
      "radiance is e / (1 - a), or as the same bits. Means of images are to be right within 5 "
      "standard errors, and these below a stated share, 0.2 to 1 %. Each case is a test as well.");
  section.command(kCommand);
  ReportTable table = {std::to_string(rows.size()) + " cases, " + std::to_string(bad) + " bad",
                       {"of", "case", "expected", "", "seen", "s"},
                       {}};
  for (const Row& row : rows) {
    table.rows.push_back({row["of"], row["case"], row["expected"],
                          row["ok"].get<bool>() ? "ok" : "BAD", row["seen"],
                          shortNumber(row["seconds"].get<double>())});
  }
  section.table(table);
  writeReport(options.folder, section);
}

int run(const Options& options) {
  std::printf("%-8s %-42s  %-48s  %-4s  %s\n", "of", "case", "expected", "", "seen");
  std::vector<Row> rows;
  runAll("density", awdtest::densityExtremes(), options, rows);
#ifdef AWD_BENCH_SCENES
  runAll("render", awdtest::sceneExtremes(), options, rows);
#endif
  std::size_t bad = 0;
  for (const Row& row : rows) bad += row["ok"].get<bool>() ? 0 : 1;
  if (!options.folder.empty()) report(options, rows, bad);
  return bad > 0 ? 1 : 0;
}

}  // namespace

void addExtremesCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "extremes", "What comes of extreme input and extreme scenes; 1 if any is wrong");
  command->add_flag("--quick", options->quick, "Without the slow cases");
  command->add_option("--out", options->folder,
                      "Folder for extremes.json, extremes.csv and the report");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace bench
