// SPDX-License-Identifier: Apache-2.0
// Rows brought down to tables: geometric means over the cells that share a heading.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "refit_densities.h"
#include "report.h"

namespace bench::refit {

/// Values of several kinds that are told apart by `column`, a key of the rows.
class Pivot {
 public:
  /// Rows of one cell agree in all but `column`, and what is measured.
  Pivot(const std::vector<Row>& rows, std::string column)
      : rows_(rows), column_(std::move(column)) {}

  /// Values of `figure` over the least of its cell.
  Pivot& relativeToLeast(const std::string& figure);
  /// Values of `figure` over that of the column `base`; cells without it are left out.
  Pivot& relativeTo(const std::string& figure, const std::string& base);

  /// Numbers by value, before any words.
  struct InOrder {
    bool operator()(const std::string& a, const std::string& b) const;
  };
  /// heading -> column -> geometric mean over cells; headings join the values of `keys`.
  using Table = std::map<std::string, std::map<std::string, double, InOrder>>;
  Table table(const std::vector<std::string>& keys) const;

 private:
  std::string cellOf(const Row& row) const;
  std::vector<double> values(const std::string& figure) const;

  const std::vector<Row>& rows_;
  std::string column_;
  std::vector<double> relative_;  // of each row; 0: left out
};

/// A value as text, numbers so that they sort.
std::string textOf(const Row& row, const std::string& key);

/// Tables of a part, on standard output and in the section.
void printSummary(Part part, const std::vector<Row>& rows, ReportSection& section);
/// Those of the renderer.
void printScenes(const std::vector<Row>& rows, ReportSection& section);

}  // namespace bench::refit
