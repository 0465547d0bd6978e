// SPDX-License-Identifier: Apache-2.0
#include "density_section.h"

#include <cmath>
#include <map>

#include "command_line.h"

namespace bench {
namespace {

constexpr const char* kBestVegas = "vegas";
constexpr const char* kMethods[] = {kOurs, kBestVegas, "miser", "plain", "cubature"};

double rmsOf(const Table& table, const std::string& integrand, const std::string& method) {
  if (method == kBestVegas) return table.vegas(integrand);
  const Figures* figures = table.find(integrand, method);
  return figures ? figures->rms : std::nan("");
}

/// Geometric mean over the integrands; NaN unless there is one of each.
double meanError(const Table& table, const std::string& method) {
  double sum = 0.0;
  const std::vector<std::string> names = table.integrands();
  for (const std::string& name : names) sum += std::log(rmsOf(table, name, method));
  return std::exp(sum / static_cast<double>(names.size()));
}

Plot errorPlot(const std::vector<Table>& tables) {
  std::map<int, std::map<std::string, std::vector<PlotPoint>>> points;
  for (const Table& table : tables) {
    for (const char* method : kMethods) {
      const double error = meanError(table, method);
      if (!(error > 0.0)) continue;
      const auto evaluations = static_cast<double>(table.evaluations());
      points[table.dimensions()][method].push_back({evaluations, error, error, error});
    }
  }
  Plot plot;
  plot.title = "RMS error, geometric mean over the integrands";
  plot.x = {"evaluations", true};
  plot.y = {"absolute RMS error", true};
  plot.names.assign(std::begin(kMethods), std::end(kMethods));
  plot.shared = false;
  for (const auto& [dimensions, series] : points) {
    PlotPanel panel = {std::to_string(dimensions) + " dimensions", {}};
    for (const auto& [method, all] : series) panel.series.push_back({method, all});
    plot.panels.push_back(std::move(panel));
  }
  plot.columns = 3;
  return plot;
}

ReportTable errorTable(const std::vector<Table>& tables) {
  ReportTable table = {
      "RMS errors, absolute. Reported / true: the error that the library reports over the true "
      "one, with its 95 % interval; 1 is honest.",
      {"dimensions", "evaluations", "integrand", "awd", "reported / true", "vegas", "miser",
       "plain", "cubature"},
      {}};
  for (const Table& from : tables) {
    for (const std::string& name : from.integrands()) {
      const Figures& ours = *from.find(name, kOurs);
      std::vector<std::string> row = {std::to_string(from.dimensions()),
                                      std::to_string(from.evaluations()), name,
                                      shortNumber(ours.rms),
                                      shortNumber(ours.ratio) + " [" + shortNumber(ours.low) +
                                          ", " + shortNumber(ours.high) + "]"};
      for (const char* peer : {kBestVegas, "miser", "plain", "cubature"}) {
        row.push_back(shortNumber(rmsOf(from, name, peer)));
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace

ReportSection densitySection(const std::vector<Table>& tables) {
  ReportSection section("density", "Integrals by a learned density");
  section.paragraph(
      "The density alone, without any rendering: it learns where a function is large, and "
      "integrates it from samples drawn there. Compared with the Monte Carlo methods of GSL "
      "(VEGAS: the better of two configurations for each integrand) and with deterministic "
      "cubature, which is far better on smooth functions of few dimensions.");
  section.command(commandLine());
  for (const Table& table : tables) {
    if (!table.verdict().empty()) section.paragraph(table.verdict());
  }
  section.plot(errorPlot(tables), "Lower is better; what was not built in is missing.");
  section.table(errorTable(tables));
  return section;
}

}  // namespace bench
