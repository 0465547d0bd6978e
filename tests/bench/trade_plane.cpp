// SPDX-License-Identifier: Apache-2.0
#include "trade_plane.h"

#include <algorithm>
#include <cmath>

#include "report.h"

namespace bench::trade {
namespace {

double number(const Row& row, const char* key) {
  return row.contains(key) ? row[key].get<double>() : std::nan("");
}

/// Marks the rows that are on the front of these figures. Without a cost, an error of 0 or less is
/// none: it is the reference's noise that was taken off.
void markFront(std::vector<Row>& rows, const char* mark, const ErrorKind& error,
               const std::vector<const char*>& costs) {
  std::vector<std::vector<double>> points;
  for (const Row& row : rows) {
    const double e = number(row, error.key);
    points.push_back({e > 0.0 ? e : std::nan("")});
    for (const char* cost : costs) points.back().push_back(number(row, cost));
  }
  const std::vector<bool> front = paretoFront(points);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i][mark] = static_cast<bool>(front[i]);
}

std::vector<CostPoint> pointsOf(const std::vector<Row>& rows, const std::string& method,
                                const ErrorKind& error) {
  std::vector<CostPoint> points;
  for (const Row& row : rows) {
    if (row["method"] == method)
      points.push_back({number(row, "cpu_seconds"), number(row, error.key)});
  }
  std::sort(points.begin(), points.end(),
            [](const CostPoint& a, const CostPoint& b) { return a.seconds < b.seconds; });
  return points;
}

MethodSummary summaryOf(const std::vector<Row>& rows, const std::string& method,
                        const std::string& baseline, const std::vector<double>& targets) {
  MethodSummary summary;
  summary.method = method;
  summary.trimmed = pointsOf(rows, method, kTrimmed);
  summary.l1 = pointsOf(rows, method, kL1);
  summary.even = breakEven(summary.trimmed, pointsOf(rows, baseline, kTrimmed));
  summary.evenL1 = breakEven(summary.l1, pointsOf(rows, baseline, kL1));
  for (const double target : targets) {
    TimeToError time = {target, 0.0, false};
    time.seconds = timeToError(summary.trimmed, target, &time.atFirst);
    summary.times.push_back(time);
  }
  return summary;
}

void setBreakEven(Row& row, const std::string& name, const BreakEven& even) {
  row[name] = std::isfinite(even.seconds) && !even.fromFirst ? "at" : textOf(even);
  if (std::isfinite(even.seconds)) row[name + "_seconds"] = even.seconds;
}

}  // namespace

std::vector<ScenePlane> planesOf(const std::vector<Row>& rows, const std::string& baseline,
                                 const std::vector<double>& targets) {
  std::vector<ScenePlane> planes;
  for (const Row& row : rows) {
    const std::string scene = row["scene"];
    if (planes.empty() || planes.back().scene != scene) planes.push_back({scene, {}, {}});
    planes.back().rows.push_back(row);
  }
  for (ScenePlane& plane : planes) {
    markFront(plane.rows, "on_front", kTrimmed, {"cpu_seconds"});
    markFront(plane.rows, "on_front_l1", kL1, {"cpu_seconds"});
    markFront(plane.rows, "on_front_with_memory", kTrimmed, {"cpu_seconds", "bytes"});
    for (const Row& row : plane.rows) {
      const std::string method = row["method"];
      const bool known =
          std::any_of(plane.methods.begin(), plane.methods.end(),
                      [&](const MethodSummary& other) { return other.method == method; });
      if (!known) plane.methods.push_back(summaryOf(plane.rows, method, baseline, targets));
    }
  }
  return planes;
}

std::string textOf(const BreakEven& even) {
  if (std::isnan(even.seconds)) return "no common time";
  if (even.seconds == kNever) return "never";
  return even.fromFirst ? "from the first budget" : shortNumber(even.seconds);
}

std::string textOf(const TimeToError& time) {
  if (time.seconds == kNever) return "not reached";
  return (time.atFirst ? "<= " : "") + shortNumber(time.seconds);
}

Row summaryRow(const ScenePlane& plane, const MethodSummary& method) {
  Row row = {{"scene", plane.scene}, {"method", method.method}};
  setBreakEven(row, "break_even", method.even);
  setBreakEven(row, "break_even_l1", method.evenL1);
  row["times_to_error"] = Row::array();
  for (const TimeToError& time : method.times) {
    Row entry = {{"target", time.target}, {"reached", time.seconds != kNever}};
    if (time.seconds != kNever) {
      entry["seconds"] = time.seconds;
      entry["at_first_budget"] = time.atFirst;
    }
    row["times_to_error"].push_back(entry);
  }
  return row;
}

}  // namespace bench::trade
