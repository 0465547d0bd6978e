// SPDX-License-Identifier: Apache-2.0
#include "density_report.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "command_line.h"
#include "density_section.h"
#include "row.h"

namespace bench {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Bounds that the interval of reported / true error must meet.
constexpr double kLeastRatio = 0.8, kMostRatio = 1.5;
constexpr const char* kPeers[] = {"plain", "miser", "cubature"};

double goalOf(int dimensions) { return dimensions <= 2 ? 0.33 : 0.7; }

template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

/// A ratio in six columns, of any magnitude.
std::string ratioText(double ratio) {
  if (std::isnan(ratio)) return "     -";
  if (ratio >= 9999.5 || ratio < 0.0005) return text("%6.0e", ratio);
  return ratio >= 99.5 ? text("%6.0f", ratio) : text("%6.3f", ratio);
}

bool honest(const Figures& f) {
  return std::isnan(f.ratio) || (f.low <= kMostRatio && f.high >= kLeastRatio);
}

}  // namespace

void Table::add(const Cell& cell, const Figures& figures) {
  rows_.push_back({cell.integrand->name(), cell.method->name, cell.repetitions, figures});
}

const Figures* Table::find(const std::string& integrand, const std::string& method) const {
  for (const Row& row : rows_) {
    if (row.integrand == integrand && row.method == method) return &row.figures;
  }
  return nullptr;
}

double Table::vegas(const std::string& integrand) const {
  double best = kNone;
  for (const char* configuration : kVegas) {
    if (const Figures* f = find(integrand, configuration)) best = std::fmin(best, f->rms);
  }
  return best;
}

double Table::relativeToVegas(const std::string& integrand, const std::string& method) const {
  const Figures* f = find(integrand, method);
  return f ? f->rms / vegas(integrand) : kNone;
}

double Table::geometricMean(const std::string& method) const {
  double sum = 0.0;
  const std::vector<std::string> names = integrands();
  for (const std::string& name : names) sum += std::log(relativeToVegas(name, method));
  return std::exp(sum / static_cast<double>(names.size()));
}

std::vector<std::string> Table::integrands() const {
  std::vector<std::string> names;
  for (const Row& row : rows_) {
    if (row.method == kOurs) names.push_back(row.integrand);
  }
  return names;
}

std::string Table::place() const {
  return text("%dD, %.0f evaluations", dimensions_, static_cast<double>(evaluations_));
}

void Table::print() const {
  std::printf("\n%s\n%-14s %9s %9s %9s  %-19s %9s %6s", place().c_str(), "", "rms error", "mean",
              "median", "reported/true", "VEGAS rms", "awd");
  for (const char* peer : kPeers) std::printf(" %8s", peer);
  std::printf("\n");
  for (const std::string& name : integrands()) {
    const Figures& ours = *find(name, kOurs);
    std::printf("%-14s %9.2e %9.2e %9.2e  %4.2f [%4.2f, %4.2f]%s %9.2e %s", name.c_str(), ours.rms,
                ours.mean, ours.median, ours.ratio, ours.low, ours.high, honest(ours) ? "  " : " !",
                vegas(name), ratioText(relativeToVegas(name, kOurs)).c_str());
    for (const char* peer : kPeers) {
      std::printf("   %s", ratioText(relativeToVegas(name, peer)).c_str());
    }
    std::printf("\n");
  }
  std::printf("%-14s %71s", "geometric mean", ratioText(geometricMean(kOurs)).c_str());
  for (const char* peer : kPeers) std::printf("   %s", ratioText(geometricMean(peer)).c_str());
  std::printf("\n");
}

std::vector<std::string> Table::lost() const {
  std::vector<std::string> lines;
  for (const Row& row : rows_) {
    const double ours = find(row.integrand, kOurs)->rms;
    if (row.figures.rms >= ours) continue;
    lines.push_back(place() + ", " + row.integrand + ": " + row.method + " has " +
                    ratioText(row.figures.rms / ours) + " of our error");
  }
  return lines;
}

std::vector<std::string> Table::dishonest() const {
  std::vector<std::string> lines;
  for (const Row& row : rows_) {
    if (row.method != kOurs || honest(row.figures)) continue;
    lines.push_back(
        place() + ", " + row.integrand +
        text(": %.2f [%.2f, %.2f]", row.figures.ratio, row.figures.low, row.figures.high));
  }
  return lines;
}

std::string Table::verdict() const {
  const double mean = geometricMean(kOurs);
  if (std::isnan(mean)) return "";
  const double goal = goalOf(dimensions_);
  return place() + text(": %.3f of VEGAS's error (goal %.2f): %s", mean, goal,
                        mean <= goal ? "met" : "MISSED");
}

void writeTables(const std::vector<Table>& tables, const std::string& folder) {
  std::filesystem::create_directories(folder);
  std::vector<bench::Row> rows;
  for (const Table& table : tables) {
    for (const Table::Row& row : table.rows()) {
      const Figures& f = row.figures;
      rows.push_back({{"dimensions", table.dimensions()},
                      {"evaluations", table.evaluations()},
                      {"integrand", row.integrand},
                      {"method", row.method},
                      {"repetitions", row.repetitions},
                      {"rms", f.rms},
                      {"mean", f.mean},
                      {"median", f.median},
                      {"reported", f.reported}});
      // Of a method that is exact, or reports nothing, there is no ratio.
      if (std::isnan(f.ratio)) continue;
      rows.back()["ratio"] = f.ratio;
      rows.back()["ratio_low"] = f.low;
      rows.back()["ratio_high"] = f.high;
    }
  }
  writeRows({{"command", commandLine()}, {"first_seed", 1}}, rows, folder, "density");
  writeReport(folder, densitySection(tables));
}

}  // namespace bench
