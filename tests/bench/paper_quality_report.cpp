// SPDX-License-Identifier: Apache-2.0
#include "paper_quality_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "paper_methods.h"
#include "png_bytes.h"

namespace bench::paper {
namespace {

const CurvePoint& tablePoint(const QualityOf& quality, std::size_t method) {
  const auto& curve = quality.curves[method];
  return *std::find_if(curve.begin(), curve.end(),
                       [](const CurvePoint& point) { return point.samples == kTableSamples; });
}

/// Median over seeds of the ratio of f.
template <class F>
double medianRatio(const CurvePoint& above, const CurvePoint& below, const F& f) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < above.l1.size(); ++i) ratios.push_back(f(above, i) / f(below, i));
  return spreadOf(ratios).median;
}

double errorRatio(const CurvePoint& above, const CurvePoint& below) {
  return medianRatio(above, below, [](const CurvePoint& p, std::size_t i) { return p.l1[i]; });
}

/// Time to a given error, which falls with the root of time.
double timeRatio(const CurvePoint& above, const CurvePoint& below) {
  return medianRatio(above, below, [](const CurvePoint& p, std::size_t i) {
    return p.l1[i] * p.l1[i] * p.cpuSeconds[i];
  });
}

ReportTable tableOf(const std::vector<QualityOf>& all) {
  ReportTable table;
  table.caption =
      "Table 1: L1 error at 100 samples a pixel, 3 x 10 of them to learn from; median over seeds "
      "(quartiles), and relative to the cosine's. Published: Pietrek and Peter 1999, table 1, of "
      "a scene that we don't have, so that only the ratios compare.";
  table.columns = {"pdf", "published", "published / cosine"};
  for (const QualityOf& quality : all) {
    table.columns.push_back(quality.scene);
    table.columns.push_back("/ cosine");
    table.columns.push_back("CPU s");
  }
  const double publishedCosine = *methods()[kCosine].published;
  for (std::size_t m = 0; m < methods().size(); ++m) {
    const auto& published = methods()[m].published;
    std::vector<std::string> row = {methods()[m].name, shortNumber(published.value_or(NAN)),
                                    shortNumber(published.value_or(NAN) / publishedCosine)};
    for (const QualityOf& quality : all) {
      const CurvePoint& point = tablePoint(quality, m);
      const Spread l1 = spreadOf(point.l1);
      row.push_back(shortNumber(l1.median) + " (" + shortNumber(l1.low) + " to " +
                    shortNumber(l1.high) + ")");
      row.push_back(shortNumber(errorRatio(point, tablePoint(quality, kCosine))));
      row.push_back(shortNumber(spreadOf(point.cpuSeconds).median));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// What the paper says of figures 5 and 6, of ours.
std::string verdictOf(const QualityOf& quality) {
  double error = INFINITY, time = 0.0;
  uint32_t errorAt = 0, timeAt = 0;
  const auto& haar = quality.curves[kHaar];
  const auto& cosine = quality.curves[kCosine];
  for (std::size_t i = 0; i < haar.size(); ++i) {
    // Before something was learned the two are not the methods that they are called.
    if (haar[i].samples <= kLearningPasses * kLearningSamples) continue;
    const double errorHere = errorRatio(haar[i], cosine[i]);
    const double timeHere = timeRatio(cosine[i], haar[i]);
    if (errorHere < error) error = errorHere, errorAt = haar[i].samples;
    if (timeHere > time) time = timeHere, timeAt = haar[i].samples;
  }
  const CurvePoint &linear = tablePoint(quality, kLinear), &best = tablePoint(quality, kHaar);
  return quality.scene + ": Haar has at best " + moreOrLess(error) + " error than cosine (at " +
         std::to_string(errorAt) + " samples; published: up to 17 % less), and cosine needs " +
         moreOrLess(time) + " CPU time for the error that Haar has at " + std::to_string(timeAt) +
         " samples (published: up to 41 % more). At 100 samples the linear B-spline has " +
         moreOrLess(errorRatio(linear, best)) + " error than Haar (published: " +
         moreOrLess(*methods()[kLinear].published / *methods()[kHaar].published) + ").";
}

PlotPanel panelOf(const QualityOf& quality, bool byTime) {
  PlotPanel panel = {quality.scene, {}};
  for (std::size_t m = 0; m < methods().size(); ++m) {
    PlotSeries series = {methods()[m].name, {}};
    for (const CurvePoint& point : quality.curves[m]) {
      const Spread l1 = spreadOf(point.l1);
      const double x = byTime ? spreadOf(point.cpuSeconds).median : point.samples;
      series.points.push_back({x, l1.median, l1.low, l1.high});
    }
    panel.series.push_back(std::move(series));
  }
  return panel;
}

Plot plotOf(const std::vector<QualityOf>& all, bool byTime) {
  Plot plot;
  plot.title = byTime ? "Error by CPU time (figure 6)" : "Error by samples (figure 5)";
  plot.subtitle = "median over seeds, quartiles; both axes logarithmic";
  plot.x.label = byTime ? "CPU seconds, learning included" : "samples per pixel";
  plot.y.label = "L1 error";
  plot.columns = 2;
  plot.shared = false;
  for (const Method& method : methods()) plot.names.push_back(method.name);
  for (const QualityOf& quality : all) plot.panels.push_back(panelOf(quality, byTime));
  return plot;
}

void addImages(const QualityOf& quality, ReportSection& section) {
  const float exposure = exposureOf(quality.reference);
  std::vector<ReportImage> images;
  for (std::size_t m = 0; m < quality.images.size(); ++m) {
    images.push_back({methods()[m].name, pngOf(quality.images[m], exposure)});
  }
  images.push_back({"reference", pngOf(quality.reference, exposure)});
  section.images(images, "Figure 3 on " + quality.scene + ": 100 samples a pixel, seed 1.");
}

}  // namespace

void addRows(const QualityOf& quality, std::vector<Row>& rows) {
  for (std::size_t m = 0; m < methods().size(); ++m) {
    for (std::size_t i = 0; i < quality.curves[m].size(); ++i) {
      const CurvePoint& point = quality.curves[m][i];
      Row row = {{"part", "quality"},           {"scene", quality.scene},
                 {"method", methods()[m].name}, {"samples_per_pixel", point.samples},
                 {"seeds", point.l1.size()},    {"reference_relmse", quality.referenceRelMse}};
      setSpread(row, "l1", spreadOf(point.l1));
      setSpread(row, "cpu_seconds", spreadOf(point.cpuSeconds));
      row["error_to_cosine"] = errorRatio(point, quality.curves[kCosine][i]);
      row["cosine_time_to_equal_error"] = timeRatio(quality.curves[kCosine][i], point);
      if (point.samples == kTableSamples && methods()[m].published) {
        row["published_l1"] = *methods()[m].published;
      }
      rows.push_back(std::move(row));
    }
  }
}

void writeQuality(const std::vector<QualityOf>& all, Study& study) {
  ReportSection& section = study.section;
  section.heading("Table 1 and figures 3, 5 and 6: error of four pdfs");
  section.paragraph(
      "All but our defaults run the preset paper: four shadow rays a light, independent numbers, "
      "roulette by albedo, a density for each planar piece, the estimator paper. They differ in "
      "the pdf alone. Unguided images have as many samples as guided ones in all their passes.");
  section.table(tableOf(all));
  for (const QualityOf& quality : all) {
    const std::string verdict = verdictOf(quality);
    std::printf("%s\n", verdict.c_str());
    section.paragraph(verdict);
  }
  section.plot(plotOf(all, false), "Figure 5. The guided ones learn from the first 30 samples.");
  section.plot(plotOf(all, true), "Figure 6.");
  for (const QualityOf& quality : all) addImages(quality, section);
}

}  // namespace bench::paper
