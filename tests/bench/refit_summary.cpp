// SPDX-License-Identifier: Apache-2.0
#include "refit_summary.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>

namespace bench::refit {
namespace {

/// What makes a cell, but for the method and kappa.
constexpr const char* kIdentity[] = {"part",
                                     "scene",
                                     "basis",
                                     "structure",
                                     "level",
                                     "noise",
                                     "function",
                                     "dimensions",
                                     "passes",
                                     "samples",
                                     "samples_per_coefficient"};

void addTable(const char* title, const Pivot::Table& table,
              const std::set<std::string, Pivot::InOrder>& columns, ReportSection& section) {
  ReportTable shown = {title, {"cells"}, {}};
  shown.columns.insert(shown.columns.end(), columns.begin(), columns.end());
  for (const auto& [heading, values] : table) {
    std::vector<std::string> row = {heading};
    for (const std::string& column : columns) {
      const auto found = values.find(column);
      row.push_back(found == values.end() ? "–" : shortNumber(found->second));
    }
    shown.rows.push_back(std::move(row));
  }
  section.table(shown);
}

/// On standard output, and as a table of the section.
void print(const char* title, const Pivot::Table& table, ReportSection& section) {
  std::set<std::string, Pivot::InOrder> columns;
  std::size_t width = 0;
  for (const auto& [heading, values] : table) {
    width = std::max(width, heading.size());
    for (const auto& [column, value] : values) columns.insert(column);
  }
  std::printf("\n%s\n%-*s", title, static_cast<int>(width), "");
  for (const std::string& column : columns) std::printf(" %13s", column.c_str());
  std::printf("\n");
  for (const auto& [heading, values] : table) {
    std::printf("%-*s", static_cast<int>(width), heading.c_str());
    for (const std::string& column : columns) {
      const auto found = values.find(column);
      found == values.end() ? std::printf(" %13s", "-") : std::printf(" %13.4g", found->second);
    }
    std::printf("\n");
  }
  if (!table.empty()) addTable(title, table, columns, section);
}

std::vector<Row> only(const std::vector<Row>& rows, const std::string& key,
                      const std::string& value) {
  std::vector<Row> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen),
               [&](const Row& row) { return textOf(row, key) == value; });
  return chosen;
}

std::vector<Row> having(const std::vector<Row>& rows, const char* figure) {
  std::vector<Row> chosen;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(chosen),
               [&](const Row& row) { return row.contains(figure); });
  return chosen;
}

void printShrinkage(const std::vector<Row>& rows, ReportSection& section) {
  for (const char* method : {"quasi", "refit-descent"}) {
    const std::vector<Row> chosen = only(rows, "method", method);
    if (chosen.empty()) continue;
    const std::string title =
        std::string(method) +
        ": variance of the next pass over that of the best kappa, by kappa (0: the default)";
    Pivot pivot(chosen, "shrinkage");
    pivot.relativeToLeast("variance");
    print((title + " and basis").c_str(), pivot.table({"basis", "structure"}), section);
    print((title + " and dimensions").c_str(), pivot.table({"dimensions"}), section);
    print((title + ", noise and samples a coefficient").c_str(),
          pivot.table({"noise", "samples_per_coefficient"}), section);
  }
}

/// How often Ceres found the coefficients of descent.
void printAgreement(const std::vector<Row>& all) {
  const std::vector<Row> rows = having(all, "differs_from_descent");
  double most = 0.0, converged = 0.0;
  for (const Row& row : rows) {
    most = std::max(most, row["differs_from_descent"].get<double>());
    converged += row["converged"].get<double>();
  }
  if (rows.empty()) return;
  std::printf(
      "\nCeres converged in %.2f %% of %zu cells; its coefficients differ from those of "
      "descent by at most\n%.2g of the largest\n",
      100.0 * converged / static_cast<double>(rows.size()), rows.size(), most);
}

void printMethods(const std::vector<Row>& all, ReportSection& section) {
  printAgreement(all);
  // Of fewer seeds, and else the same as descent.
  std::vector<Row> rows;
  std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
               [](const Row& row) { return textOf(row, "method") != "refit-ceres"; });
  Pivot variance(rows, "method");
  variance.relativeTo("variance", "quasi");
  Pivot error(rows, "method");
  error.relativeTo("l2", "quasi");
  print("Variance of the next pass over that of quasi",
        variance.table({"noise", "samples_per_coefficient"}), section);
  print("By basis", variance.table({"noise", "basis", "structure"}), section);
  print("By dimensions", variance.table({"noise", "dimensions"}), section);
  print("L2 error over that of quasi", error.table({"noise", "samples_per_coefficient"}), section);
}

void printTimes(const std::vector<Row>& rows, ReportSection& section) {
  for (const char* figure : {"adapt_ms", "record_ns"}) {
    Pivot pivot(rows, "method");
    pivot.relativeTo(figure, "");
    print(figure, pivot.table({"structure", "basis", "dimensions", "coefficients"}), section);
  }
}

}  // namespace

std::string textOf(const Row& row, const std::string& key) {
  if (!row.contains(key)) return "";
  const Row& value = row[key];
  if (value.is_string()) return value.get<std::string>();
  char text[32];
  std::snprintf(text, sizeof text, value.is_number_float() ? "%5g" : "%5.0f", value.get<double>());
  return text;
}

std::string Pivot::cellOf(const Row& row) const {
  std::string cell;
  for (const char* key : kIdentity) cell += textOf(row, key) + '/';
  return cell;
}

std::vector<double> Pivot::values(const std::string& figure) const {
  std::vector<double> values;
  values.reserve(rows_.size());
  for (const Row& row : rows_) values.push_back(std::max(row[figure].get<double>(), 1e-12));
  return values;
}

bool Pivot::InOrder::operator()(const std::string& a, const std::string& b) const {
  char *endA = nullptr, *endB = nullptr;
  const double valueA = std::strtod(a.c_str(), &endA), valueB = std::strtod(b.c_str(), &endB);
  const bool wordA = *endA != '\0', wordB = *endB != '\0';
  if (wordA || wordB) return wordA && wordB ? a < b : wordB;
  return valueA < valueB;
}

Pivot& Pivot::relativeToLeast(const std::string& figure) {
  relative_ = values(figure);
  std::map<std::string, double> least;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    double& best = least.emplace(cellOf(rows_[i]), relative_[i]).first->second;
    best = std::min(best, relative_[i]);
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) relative_[i] /= least[cellOf(rows_[i])];
  return *this;
}

Pivot& Pivot::relativeTo(const std::string& figure, const std::string& base) {
  relative_ = values(figure);
  if (base.empty()) return *this;
  std::map<std::string, double> bases;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (textOf(rows_[i], column_) == base) bases[cellOf(rows_[i])] = relative_[i];
  }
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const auto found = bases.find(cellOf(rows_[i]));
    relative_[i] = found == bases.end() ? 0.0 : relative_[i] / found->second;
  }
  return *this;
}

Pivot::Table Pivot::table(const std::vector<std::string>& keys) const {
  std::map<std::string, std::map<std::string, std::vector<double>>> groups;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!(relative_[i] > 0.0)) continue;
    std::string heading;
    for (const std::string& key : keys)
      heading += (heading.empty() ? "" : " ") + textOf(rows_[i], key);
    groups[heading][textOf(rows_[i], column_)].push_back(relative_[i]);
  }
  Table table;
  for (const auto& [heading, columns] : groups) {
    for (const auto& [column, values] : columns) table[heading][column] = geometricMean(values);
  }
  return table;
}

void printSummary(Part part, const std::vector<Row>& rows, ReportSection& section) {
  if (rows.empty()) return;
  std::printf("\n== %s\n", nameOf(part));
  section.heading(std::string("Part ") + nameOf(part));
  if (part == Part::kShrinkage) printShrinkage(rows, section);
  if (part == Part::kFirst || part == Part::kAdaptive) printMethods(rows, section);
  if (part == Part::kTime) printTimes(rows, section);
}

void printScenes(const std::vector<Row>& rows, ReportSection& section) {
  std::printf("\n== render\n");
  section.heading("Part render");
  for (const char* figure : {"efficiency_to_cosine", "efficiency_to_paper"}) {
    const std::vector<Row> chosen = having(rows, figure);
    Pivot pivot(chosen, "method");
    pivot.relativeTo(figure, "");
    print((std::string(figure) + ", median over seeds").c_str(),
          pivot.table({"scene", "basis", "samples_per_pixel"}), section);
  }
}

}  // namespace bench::refit
