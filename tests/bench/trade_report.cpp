// SPDX-License-Identifier: Apache-2.0
#include "trade_report.h"

#include <algorithm>
#include <cstdio>

#include "report.h"

namespace bench::trade {
namespace {

std::string figure(const Row& row, const char* key, double unit = 1.0) {
  return row.contains(key) ? shortNumber(row[key].get<double>() / unit) : "–";
}

std::string mark(const Row& row, const char* key) { return row[key].get<bool>() ? "yes" : ""; }

Plot chart(const ScenePlane& plane) {
  Plot plot;
  plot.title = plane.scene;
  plot.subtitle = "each point a budget, median over seeds";
  plot.x.label = "CPU seconds";
  plot.y.label = "error";
  plot.columns = 2;
  plot.shared = false;
  plot.panels = {{kTrimmed.name, {}}, {kL1.name, {}}};
  for (const MethodSummary& method : plane.methods) {
    plot.names.push_back(method.method);
    const std::vector<CostPoint>* kinds[] = {&method.trimmed, &method.l1};
    for (std::size_t k = 0; k < plot.panels.size(); ++k) {
      PlotSeries series = {method.method, {}};
      for (const CostPoint& p : *kinds[k]) {
        series.points.push_back({p.seconds, p.error, p.error, p.error});
      }
      plot.panels[k].series.push_back(std::move(series));
    }
  }
  return plot;
}

ReportTable planeTable(const ScenePlane& plane) {
  ReportTable table = {
      "All combinations; medians over seeds. On the front: none is both quicker "
      "and nearer",
      {"method", "samples", "CPU s", "trimmed relMSE", "L1", "KiB", "on the front", "by L1",
       "with memory"},
      {}};
  for (const Row& row : plane.rows) {
    table.rows.push_back({row["method"], figure(row, "samples_per_pixel"),
                          figure(row, "cpu_seconds"), figure(row, kTrimmed.key),
                          figure(row, kL1.key), figure(row, "bytes", 1024.0), mark(row, "on_front"),
                          mark(row, "on_front_l1"), mark(row, "on_front_with_memory")});
  }
  return table;
}

ReportTable methodTable(const ScenePlane& plane, const std::string& baseline) {
  ReportTable table = {"CPU seconds from which a method has less error than " + baseline +
                           " at equal time, and until its trimmed relMSE is at most so much",
                       {"method", "pays from", "by L1"},
                       {}};
  for (const TimeToError& time : plane.methods.front().times) {
    table.columns.push_back("to " + shortNumber(time.target));
  }
  for (const MethodSummary& method : plane.methods) {
    const bool itself = method.method == baseline;
    table.rows.push_back(
        {method.method, itself ? "–" : textOf(method.even), itself ? "–" : textOf(method.evenL1)});
    for (const TimeToError& time : method.times) table.rows.back().push_back(textOf(time));
  }
  return table;
}

ReportTable qualityTable(const std::vector<Row>& rows) {
  ReportTable table = {"What each quality takes, and the error that it leaves",
                       {"scene", "quality", "seed", "promised", "samples", "CPU s", "stated",
                        "stated, upper end", "true", "of the reference", "reached", "kept"},
                       {}};
  for (const Row& row : rows) {
    table.rows.push_back(
        {row["scene"], row["quality"], figure(row, "seed"), figure(row, "promised_error"),
         figure(row, "samples_per_pixel"), figure(row, "cpu_seconds"), figure(row, "stated_error"),
         figure(row, "stated_upper"), figure(row, "true_error"), figure(row, "reference_error"),
         row["reached"].get<bool>() ? "yes" : "no", row["kept"].get<bool>() ? "yes" : "no"});
  }
  return table;
}

void print(const ScenePlane& plane) {
  std::printf("\n%s: pays from (by L1), CPU s; CPU s to a trimmed relMSE\n", plane.scene.c_str());
  for (const MethodSummary& method : plane.methods) {
    std::printf("%-22s %s (%s);", method.method.c_str(), textOf(method.even).c_str(),
                textOf(method.evenL1).c_str());
    for (const TimeToError& time : method.times) {
      std::printf("  %.3g: %s", time.target, textOf(time).c_str());
    }
    std::printf("\n");
  }
  std::printf("on the front:");
  for (const Row& row : plane.rows) {
    if (!row["on_front"].get<bool>()) continue;
    std::printf(" %s/%u", row["method"].get<std::string>().c_str(),
                row["samples_per_pixel"].get<unsigned>());
  }
  std::printf("\n");
}

}  // namespace

void print(const Findings& findings) {
  for (const ScenePlane& plane : findings.planes) print(plane);
}

void write(const Findings& findings, const std::string& folder) {
  Row head = findings.head;
  head["methods"] = Row::array();
  head["qualities"] = findings.qualities;
  std::vector<Row> rows;
  for (const ScenePlane& plane : findings.planes) {
    for (const MethodSummary& method : plane.methods) {
      head["methods"].push_back(summaryRow(plane, method));
    }
    rows.insert(rows.end(), plane.rows.begin(), plane.rows.end());
  }
  writeRows(head, rows, folder, "trade");

  ReportSection section("trade", "Speed against accuracy");
  section.paragraph(
      "Error over CPU time, training included, of ways to guide and budgets. Times between budgets "
      "are read off straight lines in the logarithms; nothing is said beyond the budgets. Bytes "
      "are those of film and field.");
  section.command(findings.head["command"]);
  for (const ScenePlane& plane : findings.planes) {
    section.heading(plane.scene);
    section.plot(chart(plane), "Error over CPU seconds, " + plane.scene);
    section.table(methodTable(plane, findings.head["baseline"]));
    section.table(planeTable(plane));
  }
  if (!findings.qualities.empty()) {
    section.heading("The promises of --quality");
    section.paragraph(
        "Errors are root mean squares over the mean radiance, as awdGetRenderError() defines them. "
        "The true one is against the reference, whose own variance is taken off where it is known; "
        "it tells nothing below the reference's own error. Reached: the film says so, by the upper "
        "end of its interval; kept: the true error says so, which is promised for 95 times of 100. "
        "Kept were " +
        std::to_string(std::count_if(findings.qualities.begin(), findings.qualities.end(),
                                     [](const Row& row) { return row["kept"].get<bool>(); })) +
        " of " + std::to_string(findings.qualities.size()) + ".");
    section.table(qualityTable(findings.qualities));
  }
  writeReport(folder, section);
}

}  // namespace bench::trade
