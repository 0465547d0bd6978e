// SPDX-License-Identifier: Apache-2.0
#include "trade_quality.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "support/handles.h"

namespace bench::trade {
namespace {

using awdtest::must;

AWDSchedule scheduleOf(const std::string& quality) {
  const auto found = std::find(qualityNames().begin(), qualityNames().end(), quality);
  if (found == qualityNames().end()) throw std::runtime_error("no quality " + quality);
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  must(awdGetQualitySchedule(static_cast<AWDQuality>(found - qualityNames().begin() + 1),
                             &schedule));
  return schedule;
}

/// As AWDRenderError defines it, against the reference, whose own variance is taken off the squares
/// where it is known. Not below 0, which such a difference may be.
double trueError(const std::vector<float>& image, const Reference& reference) {
  double squares = 0.0, sum = 0.0;
  const std::vector<float>& variance = reference.variance.values;
  for (std::size_t i = 0; i < image.size(); ++i) {
    const double truth = reference.mean.values[i];
    squares += std::pow(static_cast<double>(image[i]) - truth, 2);
    if (!variance.empty()) squares -= static_cast<double>(variance[i]);
    sum += truth;
  }
  return std::sqrt(std::max(squares, 0.0) * static_cast<double>(image.size())) / sum;
}

/// The error that the reference has itself; 0: not known.
double ownError(const Reference& reference) {
  double squares = 0.0, sum = 0.0;
  for (const float value : reference.variance.values) squares += static_cast<double>(value);
  for (const float value : reference.mean.values) sum += static_cast<double>(value);
  return std::sqrt(squares * static_cast<double>(reference.mean.values.size())) / sum;
}

/// False: cancelled.
bool measure(const LoadedScene& loaded, const std::string& quality, uint64_t seed, Row& row) {
  const AWDSchedule schedule = scheduleOf(quality);
  AWDRenderDesc desc = AWD_RENDER_DESC_INIT;
  desc.camera = &loaded.camera;
  desc.seed = seed;
  awdtest::Render render;
  must(awdNewRender(loaded.scene.get(), nullptr, &desc, render.out()));
  const AWDResult result = awdRenderPasses(render, &schedule);
  if (result == AWD_ERROR_CANCELLED) return false;
  must(result);
  AWDRenderError error = AWD_RENDER_ERROR_INIT;
  must(awdGetRenderError(render, &error));
  AWDPassStatistics statistics = AWD_PASS_STATISTICS_INIT;
  must(awdGetRenderStatistics(render, &statistics));
  std::vector<float> image(loaded.reference.mean.values.size());
  must(awdReadFilm(render, AWD_FILM_RADIANCE, image.data(), 0, 0));
  const double truth = trueError(image, loaded.reference);
  row = {{"scene", loaded.name},
         {"quality", quality},
         {"seed", seed},
         {"promised_error", schedule.error},
         {"most_samples", schedule.totalSamples},
         {"samples_per_pixel", statistics.samplesPerPixel},
         {"cpu_seconds", statistics.cpuSeconds},
         {"stated_error", error.error},
         {"stated_upper", error.upper},
         {"true_error", truth},
         {"reference_error", ownError(loaded.reference)},
         {"reached", error.upper <= schedule.error},
         {"kept", truth <= schedule.error}};
  return true;
}

void print(const Row& row) {
  std::printf(
      "%-14s %-10s %6llu samples %8.3g CPU s, promised %.3g, stated %.3g [to %.3g], "
      "true %.3g%s%s\n",
      row["scene"].get<std::string>().c_str(), row["quality"].get<std::string>().c_str(),
      row["samples_per_pixel"].get<unsigned long long>(), row["cpu_seconds"].get<double>(),
      row["promised_error"].get<double>(), row["stated_error"].get<double>(),
      row["stated_upper"].get<double>(), row["true_error"].get<double>(),
      row["reached"].get<bool>() ? "" : ", NOT REACHED",
      row["kept"].get<bool>() ? "" : ", NOT KEPT");
  std::fflush(stdout);
}

}  // namespace

const std::vector<std::string>& qualityNames() {
  static const std::vector<std::string> names = {"draft", "normal", "fine", "reference"};
  return names;
}

bool measureQualities(const guide::Options& options, const std::vector<std::string>& qualities,
                      Cancelled cancelled, std::vector<Row>& rows) {
  const awd::Device device = newRenderDevice(options.threads, cancelled);
  for (const auto& [name, file] : guide::chosenScenes(options)) {
    const auto loaded = guide::loadChosen(device, options, name, file);
    if (!loaded && cancelled()) return false;
    if (!loaded) continue;
    for (const std::string& quality : qualities) {
      for (int seed = 1; seed <= options.seeds; ++seed) {
        Row row;
        if (cancelled() || !measure(*loaded, quality, static_cast<uint64_t>(seed), row)) {
          return false;
        }
        print(row);
        rows.push_back(std::move(row));
      }
    }
  }
  return true;
}

}  // namespace bench::trade
