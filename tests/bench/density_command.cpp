// SPDX-License-Identifier: Apache-2.0
// awd-bench density: errors of the integrator against those of its peers.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>
#include <thread>

#include "commands.h"
#include "density_report.h"

namespace bench {
namespace {

constexpr double kManyUpTo = 1e5;  // evaluations
constexpr int kMany = 200, kFew = 40, kQuick = 10;

struct Options {
  bool quick = false;
  std::vector<int> dimensions{2, 4, 6};
  std::vector<double> evaluations{1e4, 1e5, 1e6};
  int repetitions = 0;
  unsigned threads = std::max(1u, std::thread::hardware_concurrency());
  std::string folder;
};

/// How many tell ours from its honesty; for the peers fewer will do.
int repetitionsOf(const Options& options, const Method& method, double evaluations) {
  if (!method.random) return 1;
  if (options.repetitions > 0) return options.repetitions;
  if (options.quick) return kQuick;
  return method.name == kOurs && evaluations <= kManyUpTo ? kMany : kFew;
}

std::vector<Method> allMethods() {
  std::vector<Method> methods = awdMethods();
  for (std::vector<Method> more : {gslMethods(), cubatureMethods()}) {
    std::move(more.begin(), more.end(), std::back_inserter(methods));
  }
  if (gslMethods().empty()) std::printf("built without GSL: no plain, MISER or VEGAS\n");
  if (cubatureMethods().empty()) std::printf("built without cubature\n");
  return methods;
}

Table measureTable(const Options& options, const std::vector<Method>& methods, int dimensions,
                   double evaluations) {
  const std::vector<Integrand> integrands = allIntegrands(dimensions);
  std::vector<Cell> cells;
  for (const Integrand& integrand : integrands) {
    for (const Method& method : methods) {
      cells.push_back({&integrand, &method, static_cast<uint64_t>(evaluations),
                       repetitionsOf(options, method, evaluations)});
    }
  }
  const std::vector<Figures> figures = measure(cells, options.threads);
  Table table(dimensions, static_cast<uint64_t>(evaluations));
  for (std::size_t i = 0; i < cells.size(); ++i) table.add(cells[i], figures[i]);
  return table;
}

void printLines(const char* title, const std::vector<std::string>& lines) {
  std::printf("\n%s\n", title);
  for (const std::string& line : lines) std::printf("  %s\n", line.c_str());
  if (lines.empty()) std::printf("  none\n");
}

void printSummary(const std::vector<Table>& tables) {
  std::vector<std::string> verdicts, lost, dishonest;
  for (const Table& table : tables) {
    if (!table.verdict().empty()) verdicts.push_back(table.verdict());
    for (std::string& line : table.lost()) lost.push_back(std::move(line));
    for (std::string& line : table.dishonest()) dishonest.push_back(std::move(line));
  }
  printLines("Goals, by geometric mean over the integrands:", verdicts);
  printLines("Reported errors whose 95 % interval misses [0.8, 1.5] of the true ones:", dishonest);
  printLines(
      "Lost. Cubature is far better than any Monte Carlo method on smooth functions in few\n"
      "dimensions, and where it can halve its boxes towards a jump or kink along an axis:",
      lost);
}

int run(Options options) {
  if (options.quick) {
    options.dimensions = {2};
    options.evaluations = {1e4};
  }
  std::printf(
      "Errors are absolute. VEGAS rms: the better of two configurations for each integrand, %s "
      "and\n"
      "%s. Columns right of it: rms errors as multiples of it.\n",
      kVegas[0], kVegas[1]);
  const std::vector<Method> methods = allMethods();
  std::vector<Table> tables;
  for (const int dimensions : options.dimensions) {
    for (const double evaluations : options.evaluations) {
      tables.push_back(measureTable(options, methods, dimensions, evaluations));
      tables.back().print();
      std::fflush(stdout);
    }
  }
  printSummary(tables);
  if (!options.folder.empty()) writeTables(tables, options.folder);
  return 0;
}

}  // namespace

void addDensityCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "density", "True and reported error of the integrator, against GSL and cubature");
  command->add_flag("--quick", options->quick, "2D, 1e4 evaluations, 10 repetitions");
  command->add_option("--dimensions", options->dimensions, "Some of 1 to 6; default 2,4,6")
      ->delimiter(',')
      ->check(CLI::Range(1, kMostDimensions));
  command->add_option("--evaluations", options->evaluations, "Default 1e4,1e5,1e6")
      ->delimiter(',')
      ->check(CLI::Range(256.0, 1e9));
  command
      ->add_option("--repetitions", options->repetitions,
                   "Default 40, and 200 for ours up to 1e5 evaluations")
      ->check(CLI::Range(2, 100000));
  command->add_option("--threads", options->threads, "Default: all")->check(CLI::Range(1u, 1024u));
  command->add_option("--out", options->folder,
                      "Folder for density.json, density.csv and a section of index.html");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace bench
