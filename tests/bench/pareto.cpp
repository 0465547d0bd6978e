// SPDX-License-Identifier: Apache-2.0
#include "pareto.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace bench {
namespace {

bool isFinite(const std::vector<double>& point) {
  return std::all_of(point.begin(), point.end(), [](double x) { return std::isfinite(x); });
}

bool beats(const std::vector<double>& a, const std::vector<double>& b) {
  bool smaller = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] > b[i]) return false;
    smaller = smaller || a[i] < b[i];
  }
  return smaller;
}

/// Those that have logarithms.
std::vector<CostPoint> positive(std::vector<CostPoint> points) {
  points.erase(std::remove_if(points.begin(), points.end(),
                              [](const CostPoint& p) {
                                return !(p.seconds > 0.0 && p.error > 0.0 &&
                                         std::isfinite(p.seconds) && std::isfinite(p.error));
                              }),
               points.end());
  return points;
}

/// y at x on the line through two points, all of which are positive, linear in the logarithms.
double logLine(double x0, double y0, double x1, double y1, double x) {
  const double share = std::log(x / x0) / std::log(x1 / x0);
  return std::exp(std::log(y0) + share * std::log(y1 / y0));
}

}  // namespace

std::vector<bool> paretoFront(const std::vector<std::vector<double>>& points) {
  std::vector<bool> front(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    front[i] = isFinite(points[i]) &&
               std::none_of(points.begin(), points.end(), [&](const std::vector<double>& other) {
                 return isFinite(other) && beats(other, points[i]);
               });
  }
  return front;
}

double timeToError(const std::vector<CostPoint>& points, double target, bool* reachedAtFirst) {
  const std::vector<CostPoint> known = positive(points);
  if (reachedAtFirst) *reachedAtFirst = !known.empty() && known.front().error <= target;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i].error > target) continue;
    if (i == 0) return known[i].seconds;
    const CostPoint& before = known[i - 1];
    return logLine(before.error, before.seconds, known[i].error, known[i].seconds, target);
  }
  return kNever;
}

double errorAtTime(const std::vector<CostPoint>& points, double seconds) {
  const std::vector<CostPoint> known = positive(points);
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i].seconds == seconds) return known[i].error;
    if (known[i].seconds < seconds) continue;
    if (i == 0) break;
    const CostPoint& before = known[i - 1];
    return logLine(before.seconds, before.error, known[i].seconds, known[i].error, seconds);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

BreakEven breakEven(const std::vector<CostPoint>& method, const std::vector<CostPoint>& baseline) {
  std::vector<double> times;
  for (const std::vector<CostPoint>* points : {&method, &baseline}) {
    for (const CostPoint& point : *points) {
      const double a = errorAtTime(method, point.seconds);
      const double b = errorAtTime(baseline, point.seconds);
      if (!std::isnan(a) && !std::isnan(b)) times.push_back(point.seconds);
    }
  }
  if (times.empty()) return {std::numeric_limits<double>::quiet_NaN(), false};
  std::sort(times.begin(), times.end());
  const auto gain = [&](double time) {
    return std::log(errorAtTime(baseline, time) / errorAtTime(method, time));
  };
  // From the end: better for good, not by the luck of one budget.
  std::size_t first = times.size();
  while (first > 0 && gain(times[first - 1]) > 0.0) --first;
  if (first == times.size()) return {kNever, false};
  if (first == 0) return {times.front(), true};
  // Both are lines in the logarithms here, and so is their difference.
  const double t0 = times[first - 1], t1 = times[first], g0 = gain(t0), g1 = gain(t1);
  return {t0 * std::pow(t1 / t0, -g0 / (g1 - g0)), false};
}

}  // namespace bench
