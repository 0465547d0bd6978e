// SPDX-License-Identifier: Apache-2.0
#include "scale_report.h"

#include "report.h"
#include "scale_measure.h"

namespace bench::scale {
namespace {

double number(const Row& row, const std::string& name) { return row[name].get<double>(); }

/// Of the rows of a part, a series for each method.
PlotPanel panelOf(const std::vector<Row>& rows, const Part& part, const std::string& figure,
                  const std::string& title) {
  PlotPanel panel = {title, {}};
  for (const Method& method : methods()) {
    PlotSeries series = {method.name, {}};
    for (const Row& row : rows) {
      if (row["part"] != part.name || row["method"] != method.name) continue;
      series.points.push_back({number(row, "x"), number(row, figure), number(row, figure + "_low"),
                               number(row, figure + "_high")});
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

Plot plotOf(const Part& part, const char* title, const char* y, bool logarithmic,
            std::vector<PlotPanel> panels) {
  Plot plot;
  plot.title = std::string(title) + " over " + part.name;
  plot.x = {part.label, true};
  plot.y = {y, logarithmic};
  plot.columns = panels.size();
  for (const Method& method : methods()) plot.names.emplace_back(method.name);
  plot.shared = false;
  plot.panels = std::move(panels);
  return plot;
}

void addCharts(ReportSection& section, const std::vector<Row>& rows, const Part& part) {
  section.plot(plotOf(part, "CPU time", "CPU time, ns", false,
                      {panelOf(rows, part, "ns_per_ray", "a ray"),
                       panelOf(rows, part, "ns_per_path", "a path")}),
               "CPU time of the whole render, learning included, by its rays (shadow rays as well) "
               "and by its camera paths: medians and quartiles of the repetitions.");
  PlotPanel memory = {"field and film", {}};
  for (const Method& method : methods()) {
    PlotSeries series = {method.name, {}};
    for (const Row& row : rows) {
      if (row["part"] != part.name || row["method"] != method.name) continue;
      const double bytes = 1e-6 * number(row, "bytes");
      series.points.push_back({number(row, "x"), bytes, bytes, bytes});
    }
    memory.series.push_back(std::move(series));
  }
  section.plot(plotOf(part, "Memory", "MB", true, {std::move(memory)}),
               "Memory of field and film at the end, by the library's account; that of the scene "
               "is in the table.");
}

std::string spreadText(const Row& row, const std::string& name) {
  return shortNumber(number(row, name)) + " [" + shortNumber(number(row, name + "_low")) + ", " +
         shortNumber(number(row, name + "_high")) + "]";
}

ReportTable tableOf(const std::vector<Row>& rows, const Part& part) {
  ReportTable table = {
      std::string("Over ") + part.name + ": median [quartiles]",
      {part.label, "method", "ns a ray", "ns a path", "rays a path", "ray, of cosine",
       "path, of cosine", "patches", "field and film, MB", "scene, MB", "wall s"},
      {}};
  const bool threads = part.name == std::string("threads");
  if (threads) table.columns.emplace_back("speed-up in wall time");
  for (const Row& row : rows) {
    if (row["part"] != part.name) continue;
    table.rows.push_back(
        {shortNumber(number(row, "x")), row["method"], spreadText(row, "ns_per_ray"),
         spreadText(row, "ns_per_path"), shortNumber(number(row, "rays_per_path")),
         spreadText(row, "ray_cost_ratio"), spreadText(row, "path_cost_ratio"),
         shortNumber(number(row, "patches")), shortNumber(1e-6 * number(row, "bytes")),
         shortNumber(1e-6 * number(row, "scene_bytes")), shortNumber(number(row, "wall_seconds"))});
    if (threads) table.rows.back().push_back(shortNumber(number(row, "wall_speed_up")));
  }
  return table;
}

}  // namespace

const std::vector<Part>& parts() {
  static const std::vector<Part> all = {
      {"triangles", "triangles",
       "Two rooms, each triangle but those of lamps cut into n x n equal ones: the image stays the "
       "same, and so do the paths."},
      {"patches", "patches that have learned",
       "Two rooms, patches split at ever fewer samples. Unguided renders, which have none, stand "
       "where the guided ones have theirs."},
      {"lights", "lights", "A closed room with n x n lamps of one power in all."},
      {"samples", "samples a pixel",
       "Two rooms: what learning costs is spread over more paths, while patches grow in number."},
      {"threads", "threads",
       "Two rooms: CPU time of all threads together. The table has the wall time, which other "
       "programs lengthen; more threads than the machine has cores only take turns."},
  };
  return all;
}

void writeSection(const std::vector<Row>& rows, const std::string& command,
                  const std::string& folder) {
  ReportSection section("scale", "Cost against size");
  section.paragraph(
      "What a ray and a path cost as scenes and fields grow, guided and unguided. The methods take "
      "turns within a repetition, and ratios are those of the same repetition.");
  for (const Method& method : methods()) {
    section.paragraph(std::string(method.name) + ": " + method.what + ".");
  }
  section.command(command);
  for (const Part& part : parts()) {
    section.heading(std::string("Over ") + part.name);
    section.paragraph(part.what);
    addCharts(section, rows, part);
    section.table(tableOf(rows, part));
  }
  writeReport(folder, section);
}

}  // namespace bench::scale
