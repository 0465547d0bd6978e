// SPDX-License-Identifier: Apache-2.0
// What the rows of `awd-bench trade` say of each scene: the front, and of each method when it
// begins to pay and how long it takes to an error.
#pragma once

#include <string>
#include <vector>

#include "pareto.h"
#include "row.h"

namespace bench::trade {

/// What methods are compared by; a row has its median under that name.
struct ErrorKind {
  const char* key;
  const char* name;
};
constexpr ErrorKind kTrimmed = {"relmse_trimmed", "trimmed relMSE"};
constexpr ErrorKind kL1 = {"l1", "L1"};

struct TimeToError {
  double target;
  double seconds;  ///< kNever: not reached within the budgets
  bool atFirst;    ///< the first budget has it: the seconds are an upper bound
};

struct MethodSummary {
  std::string method;
  std::vector<CostPoint> trimmed, l1;  ///< ascending in seconds
  BreakEven even, evenL1;              ///< with the baseline; of itself: never
  std::vector<TimeToError> times;      ///< of the trimmed relMSE, in the order of the targets
};

struct ScenePlane {
  std::string scene;
  std::vector<Row> rows;  ///< with on_front, on_front_l1 and on_front_with_memory
  std::vector<MethodSummary> methods;
};

/// rows: those of guide::Report, of any number of scenes. baseline: one of the methods.
std::vector<ScenePlane> planesOf(const std::vector<Row>& rows, const std::string& baseline,
                                 const std::vector<double>& targets);

/// In seconds, or "never", "from the first budget" or "no common time".
std::string textOf(const BreakEven& even);
/// In seconds, or "not reached"; "<=" where the first budget has the error.
std::string textOf(const TimeToError& time);

/// A flat object for each scene and method.
Row summaryRow(const ScenePlane& plane, const MethodSummary& method);

}  // namespace bench::trade
