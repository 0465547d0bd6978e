// SPDX-License-Identifier: Apache-2.0
// What `awd-bench density` prints and writes.
#pragma once

#include <string>
#include <vector>

#include "measure.h"

namespace bench {

/// All methods on all integrands of one dimension, at one number of evaluations.
class Table {
 public:
  Table(int dimensions, uint64_t evaluations)
      : dimensions_(dimensions), evaluations_(evaluations) {}

  void add(const Cell& cell, const Figures& figures);
  void print() const;

  /// One line for each peer and integrand where ours is the larger error.
  std::vector<std::string> lost() const;
  /// One line for each integrand on which ours misreports its error.
  std::vector<std::string> dishonest() const;
  /// "2D, 10000 evaluations: 0.16 of VEGAS's error (goal 0.33): met"; "" without VEGAS.
  std::string verdict() const;

  /// Names, in the order of measuring.
  std::vector<std::string> integrands() const;
  /// NULL if that wasn't measured.
  const Figures* find(const std::string& integrand, const std::string& method) const;
  /// RMS error of the better VEGAS; NaN if there is none.
  double vegas(const std::string& integrand) const;

  struct Row {
    std::string integrand, method;
    int repetitions;
    Figures figures;
  };
  const std::vector<Row>& rows() const { return rows_; }
  int dimensions() const { return dimensions_; }
  uint64_t evaluations() const { return evaluations_; }

 private:
  double relativeToVegas(const std::string& integrand, const std::string& method) const;
  double geometricMean(const std::string& method) const;
  std::string place() const;

  int dimensions_;
  uint64_t evaluations_;
  std::vector<Row> rows_;
};

/// density.json, density.csv and a section of the report in `folder`, which is made.
void writeTables(const std::vector<Table>& tables, const std::string& folder);

}  // namespace bench
