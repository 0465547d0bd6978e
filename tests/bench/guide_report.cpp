// SPDX-License-Identifier: Apache-2.0
#include "guide_report.h"

#include <cmath>
#include <cstdio>

#include "png_bytes.h"

namespace bench::guide {
namespace {

struct NamedFigure {
  const char* name;
  Figure figure;
};

constexpr NamedFigure kFigures[] = {
    {"relmse", [](const Shot& shot) { return shot.relMse; }},
    {"relmse_trimmed", [](const Shot& shot) { return shot.relMseTrimmed; }},
    {"l1", [](const Shot& shot) { return shot.l1; }},
    {"cpu_seconds", [](const Shot& shot) { return shot.cpuSeconds; }},
    {"rays", [](const Shot& shot) { return shot.rays; }},
    {"rays_per_cpu_second", rayRate},
    {"patches", [](const Shot& shot) { return shot.patches; }},
    {"coefficients", [](const Shot& shot) { return shot.coefficients; }},
    {"bytes", [](const Shot& shot) { return shot.bytes; }},
};

/// Also compared with the baseline.
constexpr NamedFigure kRatios[] = {
    {"efficiency_ratio", efficiency},
    {"untrimmed_efficiency_ratio", untrimmedEfficiency},
    {"l1_efficiency_ratio", l1Efficiency},
    {"ray_rate_ratio", rayRate},
};

/// Three or four digits, in few characters.
std::string text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// "-" where there is none.
std::string ratioText(const Row& row, const std::string& name, bool interval) {
  if (!row.contains(name)) return "-";
  char text[96];
  const int length = std::snprintf(text, sizeof text, "%.3f", row[name].get<double>());
  if (interval) {
    std::snprintf(text + length, sizeof text - static_cast<std::size_t>(length), " [%.3f, %.3f]",
                  row[name + "_low"].get<double>(), row[name + "_high"].get<double>());
  }
  return text;
}

constexpr const char* kLine = "%8s  %-22s %5s %9s %9s %9s %8s %8s  %-22s %9s %7s %7s\n";

void print(const Row& row) {
  const auto median = [&](const char* name) { return text(row[name].get<double>()); };
  std::printf(kLine, text(row["samples_per_pixel"].get<double>()).c_str(),
              row["method"].get<std::string>().c_str(), text(row["seeds"].get<double>()).c_str(),
              median("relmse_trimmed").c_str(), median("relmse").c_str(), median("l1").c_str(),
              median("cpu_seconds").c_str(),
              text(row["rays_per_cpu_second"].get<double>() * 1e-6).c_str(),
              ratioText(row, "efficiency_ratio", true).c_str(),
              ratioText(row, "untrimmed_efficiency_ratio", false).c_str(),
              ratioText(row, "l1_efficiency_ratio", false).c_str(),
              ratioText(row, "ray_rate_ratio", false).c_str());
  std::fflush(stdout);
}

}  // namespace

void Report::begin(const LoadedScene& loaded) {
  loaded_ = &loaded;
  std::printf("\n%s, %u x %u", loaded.name.c_str(), loaded.camera.width, loaded.camera.height);
  const Reference& reference = loaded.reference;
  if (reference.relMse > 0.0) {
    std::printf("; the reference, of %zu files, has a relMSE of %.2g", reference.files,
                reference.relMse);
  }
  std::printf("\n");
  std::printf(kLine, "spp", "method", "seeds", "trimmed", "relMSE", "L1", "CPU s", "Mray/s",
              "efficiency [95 %]", "untrimmed", "by L1", "ray/s");
  std::fflush(stdout);
}

void Report::add(uint32_t samples, const std::string& method, const std::vector<Shot>& shots,
                 const std::vector<Shot>* base) {
  Row row = {{"scene", loaded_->name},
             {"width", loaded_->camera.width},
             {"height", loaded_->camera.height},
             {"samples_per_pixel", samples},
             {"method", method},
             {"seeds", shots.size()},
             {"reference_files", loaded_->reference.files},
             {"reference_relmse", loaded_->reference.relMse}};
  for (const auto& [name, figure] : kFigures) {
    if (!std::isnan(figure(shots.front()))) setSpread(row, name, spreadOf(shots, figure));
  }
  for (const auto& [name, figure] : kRatios) {
    const auto ratio = base ? ratioOf(shots, *base, figure) : std::nullopt;
    if (ratio) setSpread(row, name, *ratio);
  }
  print(row);
  if (base) keepImage(samples, method, shots.front());
  rows_.push_back(std::move(row));
}

void Report::keepImage(uint32_t samples, const std::string& method, const Shot& shot) {
  if (shot.image.values.empty()) return;
  if (insets_.empty() || insets_.back().scene != loaded_->name) insets_.push_back({});
  Inset& inset = insets_.back();
  // Those of the last number of samples are shown.
  if (inset.scene.empty() || inset.samples != samples) inset = {loaded_->name, samples, {}};
  for (ReportImage& image : imagesOf(samples, method, shot))
    inset.images.push_back(std::move(image));
}

void Report::showBaseline(uint32_t samples, const std::string& method, const Shot& shot) {
  const command::RgbImage& reference = loaded_->reference.mean;
  std::vector<ReportImage> images = imagesOf(samples, method, shot);
  images.insert(images.begin(), {"reference", pngOf(reference, exposureOf(reference))});
  std::vector<ReportImage>& shown = insets_.back().images;
  shown.insert(shown.begin(), images.begin(), images.end());
}

std::vector<ReportImage> Report::imagesOf(uint32_t samples, const std::string& method,
                                          const Shot& shot) const {
  const command::RgbImage& reference = loaded_->reference.mean;
  return {{method + ", " + std::to_string(samples) + " samples in " + shortNumber(shot.cpuSeconds) +
               " s, relMSE " + shortNumber(shot.relMseTrimmed) + ", trimmed",
           pngOf(shot.image, exposureOf(reference))},
          {method + " against the reference", differencePng(shot.image, reference)}};
}

void Report::write(bool complete) {
  if (folder_.empty()) return;
  Row head = head_;
  head["complete"] = complete;
  writeRows(head, rows_, folder_, name_);
  writeReport(folder_, sectionOf(name_, head_["baseline"].get<std::string>(), rows_, insets_));
}

}  // namespace bench::guide
