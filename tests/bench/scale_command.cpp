// SPDX-License-Identifier: Apache-2.0
// awd-bench scale: what rays, paths and memory cost as scenes, fields and threads grow.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.h"
#include "failure.h"
#include "interrupt.h"
#include "scale_measure.h"
#include "scale_report.h"
#include "write_file.h"

namespace bench {
namespace {

struct Options {
  bool quick = false;
  uint32_t width = 64, samples = 32;
  int repetitions = 5;
  std::string folder;
};

/// What each part goes through.
struct Sizes {
  std::vector<uint32_t> pieces = {1, 2, 4, 8, 16, 30};  // a side of a triangle
  std::vector<uint32_t> patchSamples = {64000, 16000, 4000, 1000, 250};
  std::vector<uint32_t> lamps = {1, 4, 16, 64, 256};  // a side of their grid
  std::vector<uint32_t> samples = {8, 32, 128, 512};  // a pixel
  std::vector<uint32_t> threads = {1, 2, 4};
};

constexpr const char* kLine = "%-10s %10s  %-18s %22s %22s %6s %22s %22s %8s %8s\n";

std::string text(const Row& row, const std::string& name, bool spread) {
  char text[64];
  const auto number = [&](const char* end) { return row[name + end].get<double>(); };
  if (spread) {
    std::snprintf(text, sizeof text, "%.3g [%.3g, %.3g]", number(""), number("_low"),
                  number("_high"));
  } else {
    std::snprintf(text, sizeof text, "%.4g", number(""));
  }
  return text;
}

void print(const Row& row) {
  char megabytes[32];
  std::snprintf(megabytes, sizeof megabytes, "%.3g", 1e-6 * row["bytes"].get<double>());
  std::printf(kLine, row["part"].get<std::string>().c_str(), text(row, "x", false).c_str(),
              row["method"].get<std::string>().c_str(), text(row, "ns_per_ray", true).c_str(),
              text(row, "ns_per_path", true).c_str(), text(row, "rays_per_path", false).c_str(),
              text(row, "ray_cost_ratio", true).c_str(), text(row, "path_cost_ratio", true).c_str(),
              text(row, "patches", false).c_str(), megabytes);
  std::fflush(stdout);
}

class Series {
 public:
  explicit Series(const Options& options) : options_(options) {
    if (!options.quick) return;
    options_.width = std::min(options.width, 32u);
    options_.samples = std::min(options.samples, 8u);
    options_.repetitions = std::min(options.repetitions, 2);
    sizes_ = {{1, 4}, {4000, 500}, {1, 16}, {8, 16}, {1, 2}};
  }

  /// False: cancelled.
  bool measureAll() {
    scale::CountedDevice device(1, command::wasInterrupted);
    for (const uint32_t n : sizes_.pieces) {
      const scale::CommittedScene scene = scale::cutRooms(device, n, options_.width);
      const auto triangles = static_cast<double>(scene.info.triangles);
      if (!add({"triangles", triangles, &scene, options_.samples})) return false;
    }
    const scale::CommittedScene rooms = scale::cutRooms(device, 1, options_.width);
    for (const uint32_t patchSamples : sizes_.patchSamples) {
      if (!add({"patches", 0.0, &rooms, options_.samples, 1, patchSamples})) return false;
    }
    for (const uint32_t side : sizes_.lamps) {
      const scale::CommittedScene scene = scale::lampGrid(device, side, options_.width);
      const auto lights = static_cast<double>(scene.info.lights);
      if (!add({"lights", lights, &scene, options_.samples})) return false;
    }
    for (const uint32_t samples : sizes_.samples) {
      if (!add({"samples", static_cast<double>(samples), &rooms, samples})) return false;
    }
    for (const uint32_t threads : sizes_.threads) {
      scale::CountedDevice several(threads, command::wasInterrupted);
      const scale::CommittedScene scene = scale::cutRooms(several, 1, options_.width);
      const auto x = static_cast<double>(threads);
      if (!add({"threads", x, &scene, options_.samples, threads})) return false;
    }
    return true;
  }

  void write(bool complete) const {
    if (options_.folder.empty()) return;
    const std::string command = line();
    writeRows({{"command", command}, {"complete", complete}, {"first_seed", 1}}, rows_,
              options_.folder, "scale");
    scale::writeSection(rows_, command, options_.folder);
  }

 private:
  std::string line() const {
    return "awd-bench scale" + std::string(options_.quick ? " --quick" : "") + " --width " +
           std::to_string(options_.width) + " --samples " + std::to_string(options_.samples) +
           " --repetitions " + std::to_string(options_.repetitions) + " --out DIR";
  }

  bool add(const scale::Point& point) {
    auto rows = scale::measure(point, options_.repetitions, command::wasInterrupted);
    if (!rows) return false;
    for (std::size_t m = 0; m < rows->size(); ++m) {
      Row& row = (*rows)[m];
      // Known only when they have learned: of the guided method, whose row is the last.
      if (point.part == "patches") row["x"] = rows->back()["patches"];
      if (point.part == "threads") {
        // Of the same method on the first number of threads, which is 1.
        if (point.threads == sizes_.threads.front()) oneThread_.push_back(row["wall_seconds"]);
        row["wall_speed_up"] = oneThread_[m] / row["wall_seconds"].get<double>();
      }
      print(row);
      rows_.push_back(row);
    }
    write(false);
    return true;
  }

  Options options_;
  Sizes sizes_;
  std::vector<Row> rows_;
  std::vector<double> oneThread_;  ///< wall time by method
};

int run(const Options& options) {
  if (!options.folder.empty()) {
    std::filesystem::create_directories(options.folder);
    command::checkWritable((std::filesystem::path(options.folder) / "scale.json").string());
  }
  command::catchInterrupt();
  std::printf(kLine, "part", "x", "method", "ns a ray", "ns a path", "rays/p", "ray, of cosine",
              "path, of cosine", "patches", "MB");
  Series series(options);
  const bool complete = series.measureAll();
  series.write(complete);
  return complete ? 0 : command::kInterrupted;
}

}  // namespace

void addScaleCommand(CLI::App& program, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand(
      "scale", "Cost of a ray and a path against triangles, patches, lights, samples and threads");
  command->add_flag("--quick", options->quick,
                    "Two sizes each, images of 32 pixels, 8 samples, two repetitions at most");
  command->add_option("--width", options->width, "Of the images; default 64")
      ->check(CLI::Range(8, 4096));
  command->add_option("--samples", options->samples, "A pixel; default 32")
      ->check(CLI::Range(1, 100000));
  command->add_option("--repetitions", options->repetitions, "Default 5")
      ->check(CLI::Range(1, 1000));
  command->add_option("--out", options->folder, "Folder for scale.json, scale.csv and the report");
  command->callback([&action, options] { action = [options] { return run(*options); }; });
}

}  // namespace bench
