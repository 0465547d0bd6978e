// SPDX-License-Identifier: Apache-2.0
#include "refit_plots.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "refit_summary.h"

namespace bench::refit {
namespace {

/// The order of colours.
constexpr const char* kMethodOrder[] = {"quasi",   "refit-descent", "ratio",      "paper",
                                        "mixture", "cosine",        "refit-ceres"};
constexpr const char* kFamilyOrder[] = {"haar grid", "linear grid", "quadratic grid", "m2 grid",
                                        "m3 grid",   "haar tree",   "m2 tree"};
constexpr const char* kNoiseOrder[] = {"none", "exponential", "outliers"};

/// "linear grid" for a grid of linear-bspline.
std::string familyOf(const Row& row) {
  const std::string basis = textOf(row, "basis");
  return basis.substr(0, basis.find("-bspline")) + " " + textOf(row, "structure");
}

/// A method has its colour in all plots.
Plot newPlot() {
  Plot plot;
  plot.names.assign(std::begin(kMethodOrder), std::end(kMethodOrder));
  return plot;
}

std::vector<Row> where(const std::vector<Row>& rows, const std::function<bool(const Row&)>& holds) {
  std::vector<Row> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen), holds);
  return chosen;
}

/// One series a method: points at the values of `x`, each `mean` of the `figure` there.
std::vector<PlotSeries> seriesOf(const std::vector<Row>& rows, const std::string& x,
                                 const std::string& figure,
                                 const std::function<double(const std::vector<double>&)>& mean) {
  std::vector<PlotSeries> all;
  for (const char* method : kMethodOrder) {
    std::map<double, std::vector<double>> groups;
    for (const Row& row : rows) {
      if (textOf(row, "method") != method) continue;
      groups[row[x].get<double>()].push_back(row[figure].get<double>());
    }
    if (groups.empty()) continue;
    PlotSeries series = {method, {}};
    for (const auto& [at, values] : groups) {
      const double y = mean(values);
      series.points.push_back({at, y, y, y});
    }
    all.push_back(std::move(series));
  }
  return all;
}

double arithmeticMean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

std::string nameOfNoise(const std::string& noise) { return noise == "none" ? "no noise" : noise; }

/// A column for each family and a row for each noise.
std::vector<PlotPanel> familyPanels(const std::vector<Row>& rows, const std::string& x,
                                    const std::string& figure, std::size_t& columns) {
  std::vector<std::string> families;
  for (const char* family : kFamilyOrder) {
    const bool present = std::any_of(rows.begin(), rows.end(),
                                     [&](const Row& row) { return familyOf(row) == family; });
    if (present) families.emplace_back(family);
  }
  columns = families.size();
  std::vector<PlotPanel> panels;
  for (const char* noise : kNoiseOrder) {
    if (where(rows, [&](const Row& row) { return textOf(row, "noise") == noise; }).empty())
      continue;
    for (const std::string& family : families) {
      const std::vector<Row> chosen = where(rows, [&](const Row& row) {
        return familyOf(row) == family && textOf(row, "noise") == noise;
      });
      const bool share = figure == "negative";
      panels.push_back({family + ", " + nameOfNoise(noise),
                        seriesOf(chosen, x, figure, share ? arithmeticMean : geometricMean)});
    }
  }
  return panels;
}

struct Figure {
  const char* key;
  const char* title;
  const char* label;
  bool logarithmic;
};
constexpr Figure kFigures[] = {
    {"variance", "Relative variance of the next pass", "∫ f²/p / (∫ f)² − 1", true},
    {"l2", "L2 error of the density", "‖p − f/∫f‖ / ‖f/∫f‖", true},
    {"negative", "Coefficients below 0 before the floor", "share of all", false}};

void plotMethods(const std::vector<Row>& rows, const std::string& what, ReportSection& section) {
  std::set<int> dimensions;
  for (const Row& row : rows) dimensions.insert(row["dimensions"].get<int>());
  for (const int d : dimensions) {
    const std::vector<Row> chosen =
        where(rows, [d](const Row& row) { return row["dimensions"].get<int>() == d; });
    for (const Figure& figure : kFigures) {
      Plot plot = newPlot();
      plot.title = std::string(figure.title) + ", " + std::to_string(d) +
                   (d == 1 ? " dimension" : " dimensions");
      plot.subtitle = what + " Mean over functions and levels of the medians over seeds.";
      plot.x = {"samples a coefficient, m/n", true};
      plot.y = {figure.label, figure.logarithmic};
      plot.panels = familyPanels(chosen, "samples_per_coefficient", figure.key, plot.columns);
      section.plot(plot, "");
    }
  }
}

void plotShrinkage(const std::vector<Row>& rows, ReportSection& section) {
  Plot plot = newPlot();
  plot.title = "Variance of the next pass by kappa";
  plot.subtitle = "One pass from the uniform density. Geometric mean over all else.";
  plot.x = {"shrinkage kappa, in samples", true};
  plot.y = {"∫ f²/p / (∫ f)² − 1", true};
  plot.panels = familyPanels(rows, "shrinkage", "variance", plot.columns);
  section.plot(plot, "");
}

void plotTimes(const std::vector<Row>& rows, ReportSection& section) {
  const std::pair<const char*, const char*> figures[] = {
      {"adapt_ms", "CPU time of an adapt, ms"},
      {"record_ns", "CPU time of recording a sample, ns"}};
  for (const auto& [key, label] : figures) {
    Plot plot = newPlot();
    plot.title = label;
    plot.subtitle = "16 samples a coefficient; two and three dimensions.";
    plot.x = {"coefficients n", true};
    plot.shared = false;
    plot.y = {label, true};
    for (const char* family : kFamilyOrder) {
      for (const int d : {2, 3}) {
        const std::vector<Row> chosen = where(rows, [&](const Row& row) {
          return familyOf(row) == family && row["dimensions"].get<int>() == d;
        });
        if (chosen.empty()) continue;
        plot.panels.push_back({std::string(family) + ", " + std::to_string(d) + "D",
                               seriesOf(chosen, "coefficients", key, geometricMean)});
      }
    }
    plot.columns = std::min<std::size_t>(4, plot.panels.size());
    section.plot(plot, "");
  }
}

}  // namespace

void plotScenes(const std::vector<Row>& rows, ReportSection& section) {
  std::set<std::string> scenes, bases;
  for (const Row& row : rows) {
    scenes.insert(textOf(row, "scene"));
    if (!textOf(row, "basis").empty()) bases.insert(textOf(row, "basis"));
  }
  for (const std::string& basis : bases) {
    Plot plot = newPlot();
    plot.title = "Error against CPU time, " + basis;
    plot.subtitle =
        "Training included; relMSE without the worst 0.1 % of pixels. Each point is a number of "
        "samples; medians and quartiles over seeds.";
    plot.x = {"CPU time, s", true};
    plot.y = {"relMSE, trimmed", true};
    plot.shared = false;
    for (const std::string& scene : scenes) {
      PlotPanel panel = {scene, {}};
      for (const char* method : kMethodOrder) {
        PlotSeries series = {method, {}};
        for (const Row& row : rows) {
          const std::string own = textOf(row, "basis");
          if (textOf(row, "scene") != scene || textOf(row, "method") != method ||
              (!own.empty() && own != basis)) {
            continue;
          }
          series.points.push_back(
              {row["cpu_seconds"].get<double>(), row["relmse_trimmed"].get<double>(),
               row["relmse_trimmed_low"].get<double>(), row["relmse_trimmed_high"].get<double>()});
        }
        if (!series.points.empty()) panel.series.push_back(std::move(series));
      }
      plot.panels.push_back(std::move(panel));
    }
    plot.columns = std::min<std::size_t>(4, plot.panels.size());
    section.plot(plot, "");
  }
}

void plotDensities(const std::vector<Row>& rows, ReportSection& section) {
  const auto part = [&](Part wanted) {
    return where(rows, [&](const Row& row) {
      return textOf(row, "part") == nameOf(wanted) &&
             (wanted == Part::kTime || textOf(row, "method") != "refit-ceres");
    });
  };
  if (const auto chosen = part(Part::kShrinkage); !chosen.empty()) plotShrinkage(chosen, section);
  // Ceres has fewer seeds, and else the coefficients of descent: time is what it is compared by.
  if (const auto chosen = part(Part::kFirst); !chosen.empty()) {
    plotMethods(chosen, "One pass from the uniform density at a fixed level.", section);
  }
  if (const auto chosen = part(Part::kAdaptive); !chosen.empty()) {
    plotMethods(chosen, "After four passes that choose their levels.", section);
  }
  if (const auto chosen = part(Part::kTime); !chosen.empty()) plotTimes(chosen, section);
}

}  // namespace bench::refit
