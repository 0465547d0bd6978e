// SPDX-License-Identifier: Apache-2.0
#include "guide_section.h"

#include <algorithm>

#include "command_line.h"

namespace bench::guide {
namespace {

std::string median(const Row& row, const std::string& name) {
  return row.contains(name) ? shortNumber(row[name].get<double>()) : "–";
}

std::string interval(const Row& row, const std::string& name) {
  if (!row.contains(name)) return "–";
  return median(row, name) + " [" + median(row, name + "_low") + ", " +
         median(row, name + "_high") + "]";
}

template <class Value>
std::vector<Value> valuesOf(const std::vector<Row>& rows, const char* key) {
  std::vector<Value> values;
  for (const Row& row : rows) {
    const auto value = row[key].get<Value>();
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

ReportTable tableOf(const std::string& baseline, const std::vector<Row>& rows) {
  ReportTable table = {
      "Medians over seeds. Efficiencies and rays a CPU second are relative to " + baseline +
          "'s of the same seed, with the 95 % interval of the median.",
      {"scene", "samples per pixel", "method", "seeds", "relMSE, trimmed", "relMSE", "L1",
       "CPU time, s", "efficiency", "efficiency by L1", "rays a second"},
      {}};
  for (const Row& row : rows) {
    table.rows.push_back({row["scene"].get<std::string>(), median(row, "samples_per_pixel"),
                          row["method"].get<std::string>(), median(row, "seeds"),
                          median(row, "relmse_trimmed"), median(row, "relmse"), median(row, "l1"),
                          median(row, "cpu_seconds"), interval(row, "efficiency_ratio"),
                          median(row, "l1_efficiency_ratio"), median(row, "ray_rate_ratio")});
  }
  return table;
}

/// A panel for each scene, with a series for each method.
Plot plotOf(const std::vector<Row>& rows, const std::string& x, const std::string& y) {
  Plot plot;
  plot.names = valuesOf<std::string>(rows, "method");
  plot.shared = false;
  for (const std::string& scene : valuesOf<std::string>(rows, "scene")) {
    PlotPanel panel = {scene, {}};
    for (const std::string& method : plot.names) {
      PlotSeries series = {method, {}};
      for (const Row& row : rows) {
        if (row["scene"] != scene || row["method"] != method || !row.contains(y)) continue;
        series.points.push_back({row[x].get<double>(), row[y].get<double>(),
                                 row[y + "_low"].get<double>(), row[y + "_high"].get<double>()});
      }
      if (!series.points.empty()) panel.series.push_back(std::move(series));
    }
    plot.panels.push_back(std::move(panel));
  }
  plot.columns = std::min<std::size_t>(3, plot.panels.size());
  return plot;
}

/// How often a method gains, loses, or neither for sure.
std::string verdict(const std::string& baseline, const std::string& method,
                    const std::vector<Row>& rows) {
  int above = 0, below = 0, all = 0;
  for (const Row& row : rows) {
    if (row["method"] != method || !row.contains("efficiency_ratio")) continue;
    above += row["efficiency_ratio_low"].get<double>() > 1.0 ? 1 : 0;
    below += row["efficiency_ratio_high"].get<double>() < 1.0 ? 1 : 0;
    ++all;
  }
  return "Of " + std::to_string(all) + " cells (scene and number of samples), " + method +
         " is more efficient than " + baseline + " in " + std::to_string(above) + ", less in " +
         std::to_string(below) + "; in the others the interval holds 1.";
}

}  // namespace

ReportSection sectionOf(const std::string& name, const std::string& baseline,
                        const std::vector<Row>& rows, const std::vector<Inset>& insets) {
  const bool ours = name == "guide";
  ReportSection section(name, ours ? "Guided against unguided rendering, by scene"
                                   : "A small path tracer guided by the library and its peers");
  section.paragraph(
      ours ? "The library's renderer with each way to guide, on whole scenes: error against CPU "
             "time, training included. Lower and further left is better."
           : "A host that is not the library's renderer, guided through the same interface as "
             "its peers are: error against CPU time, training included.");
  section.command(commandLine());
  if (rows.empty()) return section;
  for (const std::string& method : valuesOf<std::string>(rows, "method")) {
    if (method != baseline) section.paragraph(verdict(baseline, method, rows));
  }
  Plot error = plotOf(rows, "cpu_seconds", "relmse_trimmed");
  error.title = "Error against CPU time";
  error.x = {"CPU time, s", true};
  error.y = {"relMSE, trimmed", true};
  section.plot(error,
               "Each point is a number of samples per pixel: median and quartiles over seeds.");
  Plot gain = plotOf(rows, "samples_per_pixel", "efficiency_ratio");
  gain.title = "Efficiency relative to " + baseline + "'s; above 1 guiding pays";
  gain.x = {"samples per pixel", true};
  gain.y = {"efficiency ratio", true};
  section.plot(gain, "Median over seeds and its 95 % interval.");
  section.table(tableOf(baseline, rows));
  for (const Inset& inset : insets) {
    section.images(inset.images,
                   inset.scene + ", seed 1: " + baseline +
                       " with as many samples per pixel as take the CPU time of the method beside "
                       "it. Differences: blue where an image is darker than the reference, red "
                       "where it is brighter, full at half of it.");
  }
  return section;
}

}  // namespace bench::guide
