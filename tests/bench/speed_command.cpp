// SPDX-License-Identifier: Apache-2.0
// awd-bench speed: what drawing, looking up, recording and adapting cost, for each basis and level
// in two dimensions.
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.h"
#include "commands.h"
#include "report.h"
#include "row.h"
#include "support/handles.h"

namespace bench {
namespace {

using awdtest::must;

constexpr uint32_t kDimensions = 2;
constexpr std::size_t kBatch = 4096;

/// A bump off the centre, as light from one side is.
double bump(const double* x) {
  const double u = x[0] - 0.3, v = x[1] - 0.6;
  return 0.02 + std::exp(-20.0 * (u * u + v * v));
}

/// A density that knows the bump, and a batch of its samples.
struct Workload {
  Workload(AWDDevice device, AWDDensityStructure structure, const char* basis, uint32_t level)
      : uniforms(kBatch * kDimensions), points(kBatch * kDimensions), pdfs(kBatch), values(kBatch) {
    const AWDDensityAxis axis = {basis, AWD_LEVEL(level), AWD_LEVEL(level)};
    const AWDDensityAxis axes[kDimensions] = {axis, axis};
    AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
    desc.dimensions = kDimensions;
    desc.structure = structure;
    desc.axes = axes;
    must(awdNewDensity(device, &desc, density.out()));
    for (int pass = 0; pass < 2; ++pass) {
      for (int batch = 0; batch < 32; ++batch) {
        draw();
        record();
      }
      must(awdAdaptDensity(density, nullptr));
    }
    draw();
  }

  void draw() {
    for (double& u : uniforms) u = std::generate_canonical<double, 53>(random);
    sample();
    for (std::size_t i = 0; i < kBatch; ++i) values[i] = bump(&points[i * kDimensions]);
  }
  void sample() {
    must(awdSampleDensity(density, kBatch, uniforms.data(), points.data(), pdfs.data(), nullptr));
  }
  void pdf() { must(awdGetDensityPdf(density, kBatch, points.data(), pdfs.data())); }
  void record() {
    must(awdRecordDensity(density, kBatch, points.data(), pdfs.data(), nullptr, values.data()));
  }

  awdtest::Handle<AWDDensity, awdReleaseDensity> density;
  std::vector<double> uniforms, points, pdfs, values;
  std::mt19937_64 random{1};
};

/// Time a sample: cost is what the benchmark's CPU column shows.
void perSample(benchmark::State& state, const std::function<void()>& work) {
  for (auto _ : state) work();
  state.counters["ns_per_sample"] = benchmark::Counter(
      static_cast<double>(kBatch) * 1e-9,
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void addAll(AWDDevice device, AWDDensityStructure structure, const char* basis, uint32_t level) {
  const std::string name = std::string(structure == AWD_STRUCTURE_TREE ? "tree" : "grid") + "/" +
                           basis + "/" + std::to_string(level) + "/";
  const auto workload = [=] { return std::make_shared<Workload>(device, structure, basis, level); };
  benchmark::RegisterBenchmark((name + "sample+pdf").c_str(), [=](benchmark::State& state) {
    const auto load = workload();
    perSample(state, [&] { load->sample(); });
  });
  benchmark::RegisterBenchmark((name + "pdf").c_str(), [=](benchmark::State& state) {
    const auto load = workload();
    perSample(state, [&] { load->pdf(); });
  });
  benchmark::RegisterBenchmark((name + "record").c_str(), [=](benchmark::State& state) {
    const auto load = workload();
    perSample(state, [&] { load->record(); });
  });
  benchmark::RegisterBenchmark((name + "record+adapt").c_str(), [=](benchmark::State& state) {
    const auto load = workload();
    // An adapt every 100,000 samples or so, as between the passes of a small frame.
    perSample(state, [&, batches = 0]() mutable {
      load->record();
      if (++batches % 24 == 0) must(awdAdaptDensity(load->density, nullptr));
    });
    AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
    must(awdGetDensityInfo(load->density, &info));
    state.counters["coefficients"] = static_cast<double>(info.coefficients);
    state.counters["bytes"] = static_cast<double>(info.bytes);
  });
}

struct Options {
  bool quick = false;
  std::string filter = ".";
  std::string folder;
};

/// Shows results as ever, and keeps them.
class KeepingReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) keep(run);
  }
  const std::vector<Row>& rows() const { return rows_; }

 private:
  void keep(const Run& run) {
    std::istringstream name(run.benchmark_name());
    std::string part[4];
    for (std::string& text : part) std::getline(name, text, '/');
    Row row = {{"structure", part[0]},
               {"basis", part[1]},
               {"level", std::stoi(part[2])},
               {"call", part[3]}};
    row["ns_per_sample"] = 1e9 * run.cpu_accumulated_time /
                           (static_cast<double>(run.iterations) * static_cast<double>(kBatch));
    for (const char* counter : {"coefficients", "bytes"}) {
      const auto found = run.counters.find(counter);
      if (found != run.counters.end()) row[counter] = static_cast<double>(found->second);
    }
    rows_.push_back(std::move(row));
  }

  std::vector<Row> rows_;
};

ReportSection sectionOf(const std::vector<Row>& rows) {
  ReportSection section("speed", "What a sample costs");
  section.paragraph(
      "CPU time of drawing a direction with its density (sample+pdf), of looking one up (pdf), of "
      "recording a sample, and of that with an adapt every 100,000 samples, in two dimensions for "
      "each basis and level. Clocks of a busy or virtual machine vary.");
  section.command(commandLine());
  ReportTable table = {
      "Nanoseconds a sample.",
      {"structure", "basis", "level", "call", "ns a sample", "coefficients", "bytes"},
      {}};
  for (const Row& row : rows) {
    const auto count = [&](const char* name) {
      return row.contains(name) ? std::to_string(row[name].get<long long>()) : std::string("–");
    };
    table.rows.push_back({row["structure"].get<std::string>(), row["basis"].get<std::string>(),
                          row["level"].dump(), row["call"].get<std::string>(),
                          shortNumber(row["ns_per_sample"].get<double>()), count("coefficients"),
                          count("bytes")});
  }
  section.table(table);
  return section;
}

int run(const Options& options) {
  std::printf(
      "CPU time per sample in two dimensions. Intel Open PGL's parallax-aware mixtures took, on a\n"
      "machine of this kind: pdf 41 ns, sample + pdf 121 ns, update 460 ns a sample.\n");
  std::fflush(stdout);
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  awdtest::Handle<AWDDevice, awdReleaseDevice> device;
  must(awdNewDevice(&desc, device.out()));
  const char* const families[] = {"haar",
                                  "linear-bspline",
                                  "linear-bspline-periodic",
                                  "quadratic-bspline",
                                  "quadratic-bspline-periodic",
                                  "f2",
                                  "m2",
                                  "m3"};
  for (const char* family : families) {
    for (const uint32_t level : {2u, 3u, 4u, 6u}) {
      if (options.quick && level != 3) continue;
      addAll(device, AWD_STRUCTURE_GRID, family, level);
    }
  }
  for (const char* family : {"haar", "f2", "m2", "m3"}) {
    for (const uint32_t level : {2u, 3u, 4u, 6u}) {
      if (options.quick && level != 3) continue;
      addAll(device, AWD_STRUCTURE_TREE, family, level);
    }
  }
  std::string program = "awd-bench";
  std::string time = options.quick ? "--benchmark_min_time=0.001" : "--benchmark_min_time=0.1";
  std::string filter = "--benchmark_filter=" + options.filter;
  char* arguments[] = {program.data(), time.data(), filter.data(), nullptr};
  int count = 3;
  benchmark::Initialize(&count, arguments);
  KeepingReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::Shutdown();
  if (options.folder.empty()) return 0;
  std::filesystem::create_directories(options.folder);
  writeRows({{"command", commandLine()}, {"seed", 1}}, reporter.rows(), options.folder, "speed");
  writeReport(options.folder, sectionOf(reporter.rows()));
  return 0;
}

}  // namespace

void addSpeedCommand(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("speed", "Time a sample for each basis and level");
  const auto options = std::make_shared<Options>();
  command->add_flag("--quick", options->quick, "One level, short runs");
  command->add_option("--filter", options->filter, "Only what matches this, such as grid/m2/4/pdf");
  command->add_option("--out", options->folder,
                      "Folder for speed.json, speed.csv and a section of index.html");
  command->callback([options, &action] { action = [options] { return run(*options); }; });
}

}  // namespace bench
