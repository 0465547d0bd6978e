// SPDX-License-Identifier: Apache-2.0
// awd-bench wavelets: coefficients that a tree saves when details below their standard error are
// dropped, and what that does to the variance of f/p.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <vector>

#include "command_line.h"
#include "commands.h"
#include "report.h"
#include "row.h"
#include "support/handles.h"
#include "wavelets.h"

namespace bench {
namespace {

using awdtest::must;

constexpr uint32_t kDimensions = 2;
constexpr uint32_t kLevel = 5;
constexpr std::size_t kQuickSamples = 2000;
constexpr uint32_t kGrid = 512;  // points of the quadrature along an axis

struct Function {
  const char* name;
  double (*value)(double x, double y);
};

const Function kFunctions[] = {
    {"constant", [](double, double) { return 1.0; }},
    {"ramp", [](double x, double y) { return 0.2 + x + 0.5 * y; }},
    {"bump", [](double x, double y) { return std::exp(-30.0 * (x * x + (y - 0.4) * (y - 0.4))); }},
    {"disc", [](double x, double y) { return std::hypot(x - 0.4, y - 0.5) < 0.3 ? 1.0 : 0.01; }},
    {"ridge", [](double x, double y) { return std::exp(-200.0 * (x - y) * (x - y)); }},
};

using Density = awdtest::Handle<AWDDensity, awdReleaseDensity>;

/// V / I^2 with V the variance of f/p, by the midpoint rule.
double relativeVariance(AWDDensity density, const Function& f) {
  std::vector<double> points, pdfs(kGrid * kGrid);
  for (uint32_t i = 0; i < kGrid; ++i) {
    for (uint32_t k = 0; k < kGrid; ++k) {
      points.insert(points.end(), {(i + 0.5) / kGrid, (k + 0.5) / kGrid});
    }
  }
  must(awdGetDensityPdf(density, pdfs.size(), points.data(), pdfs.data()));
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < pdfs.size(); ++i) {
    const double value = f.value(points[2 * i], points[2 * i + 1]);
    sum += value / (kGrid * kGrid);
    squares += value * value / pdfs[i] / (kGrid * kGrid);
  }
  return squares / (sum * sum) - 1.0;
}

/// A tree of 2^level x 2^level boxes that has learnt from so many uniform samples. fixed: none are
/// merged.
Density learn(AWDDevice device, const char* basis, const Function& f, std::size_t samples,
              bool fixed, AWDDensityReport& report) {
  // The boxes that there are are all that is allowed.
  const AWDDensityAxis axis = {basis, AWD_LEVEL(kLevel), AWD_LEVEL(fixed ? kLevel : kLevel + 1)};
  const AWDDensityAxis axes[kDimensions] = {axis, axis};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = kDimensions;
  desc.structure = AWD_STRUCTURE_TREE;
  desc.axes = axes;
  Density density;
  must(awdNewDensity(device, &desc, density.out()));
  std::mt19937_64 random(1);
  std::vector<double> uniforms(samples * kDimensions), points(uniforms.size()), values(samples);
  for (double& u : uniforms) u = std::generate_canonical<double, 53>(random);
  must(awdSampleDensity(density, samples, uniforms.data(), points.data(), nullptr, nullptr));
  for (std::size_t i = 0; i < samples; ++i) values[i] = f.value(points[2 * i], points[2 * i + 1]);
  must(awdRecordDensity(density, samples, points.data(), nullptr, nullptr, values.data()));
  must(awdAdaptDensity(density, &report));
  return density;
}

struct Options {
  bool quick = false;
  std::size_t samples = 20000;
  std::string folder;
};

void print(const Row& row) {
  std::printf("%-6s %-10s %8llu %8llu %8llu %10.5f %10.5f\n",
              row["basis"].get<std::string>().c_str(), row["function"].get<std::string>().c_str(),
              row["coefficients"].get<unsigned long long>(),
              row["dropped"].get<unsigned long long>(), row["split"].get<unsigned long long>(),
              row["variance"].get<double>(), row["variance_after"].get<double>());
}

ReportSection sectionOf(const std::vector<Row>& rows, std::size_t samples) {
  ReportSection section("wavelets", "Coefficients that need not be kept");
  section.paragraph(
      "A density in " + std::to_string(1u << kLevel) + " x " + std::to_string(1u << kLevel) +
      " boxes learns a function from " + std::to_string(samples) +
      " samples. Wavelet details smaller than their own standard error are noise: dropping them "
      "saves coefficients. The variance of f/p, relative to the squared integral, tells what that "
      "does to sampling; lower is better.");
  section.command(commandLine());
  ReportTable table = {"Merged and split boxes, and the variance without and with that.",
                       {"basis", "function", "coefficients", "dropped", "split", "variance",
                        "variance after", "after / before"},
                       {}};
  for (const Row& row : rows) {
    const double before = row["variance"].get<double>(),
                 after = row["variance_after"].get<double>();
    table.rows.push_back({row["basis"].get<std::string>(), row["function"].get<std::string>(),
                          row["coefficients"].dump(), row["dropped"].dump(), row["split"].dump(),
                          shortNumber(before), shortNumber(after), shortNumber(after / before)});
  }
  section.table(table);
  return section;
}

int run(const Options& options) {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  awdtest::Handle<AWDDevice, awdReleaseDevice> device;
  must(awdNewDevice(&desc, device.out()));
  const std::size_t samples = options.quick ? kQuickSamples : options.samples;
  std::printf("%zu samples on %u x %u boxes; variance relative to the squared integral\n", samples,
              1u << kLevel, 1u << kLevel);
  std::printf("%-6s %-10s %8s %8s %8s %10s %10s\n", "basis", "function", "all", "dropped", "split",
              "variance", "after");
  const std::vector<Row> rows = measureWavelets(device, samples);
  for (const Row& row : rows) print(row);
  if (options.folder.empty()) return 0;
  std::filesystem::create_directories(options.folder);
  writeRows({{"command", commandLine()}, {"samples", samples}, {"seed", 1}}, rows, options.folder,
            "wavelets");
  writeReport(options.folder, sectionOf(rows, samples));
  return 0;
}

}  // namespace

std::vector<Row> measureWavelets(AWDDevice device, std::size_t samples) {
  std::vector<Row> rows;
  for (const char* basis : {"haar", "f2", "m2", "m3"}) {
    for (const Function& f : kFunctions) {
      AWDDensityReport all = AWD_DENSITY_REPORT_INIT, kept = AWD_DENSITY_REPORT_INIT;
      const Density full = learn(device, basis, f, samples, true, all);
      const Density coarse = learn(device, basis, f, samples, false, kept);
      rows.push_back({{"basis", basis},
                      {"function", f.name},
                      {"coefficients", all.coefficients},
                      {"coefficients_after", kept.coefficients},
                      {"dropped", kept.coarsened},
                      {"split", kept.split},
                      {"variance", relativeVariance(full, f)},
                      {"variance_after", relativeVariance(coarse, f)}});
    }
  }
  return rows;
}

void addWaveletsCommand(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand(
      "wavelets", "Coefficients saved by dropping details below their standard error");
  const auto options = std::make_shared<Options>();
  CLI::Option* samples =
      command->add_option("--samples", options->samples, "Of the pass; default 20000")
          ->check(CLI::Range(1000, 100000000));
  command->add_flag("--quick", options->quick, "2000 samples")->excludes(samples);
  command->add_option("--out", options->folder,
                      "Folder for wavelets.json, wavelets.csv and a section of index.html");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace bench
