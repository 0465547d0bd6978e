// SPDX-License-Identifier: Apache-2.0
#include "refit/problem_check.h"

#include <cfloat>
#include <cinttypes>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <vector>

namespace awd {

namespace {

constexpr uint64_t kMostUnknowns = 0x7fffffff;

/// Of A_jk - A_kj, and of A_jk^2 - A_jj A_kk, relative to the diagonal.
constexpr double kSlack = 1e-10;

/// Terms of Q larger than this could overflow when they are squared or summed.
constexpr double kLargestTerm = 1e280;

[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...) {
  char buffer[192];
  va_list values;
  va_start(values, format);
  std::vsnprintf(buffer, sizeof buffer, format, values);
  va_end(values);
  return buffer;
}

std::string headFault(const AWDRefitProblem& p) {
  if (p.structSize < sizeof(AWDRefitProblem)) {
    return text("structSize is %zu: must be %zu or more", p.structSize, sizeof(AWDRefitProblem));
  }
  if (p.unknowns < 1 || p.unknowns > kMostUnknowns) {
    return text("unknowns is %" PRIu64 ": must be 1 to %" PRIu64, p.unknowns, kMostUnknowns);
  }
  if (!p.rowBegin) return "rowBegin is NULL";
  if (!p.columns) return "columns is NULL";
  if (!p.values) return "values is NULL";
  if (!p.rhs) return "rhs is NULL";
  if (!p.lower) return "lower is NULL";
  if (!p.start) return "start is NULL";
  if (p.rowBegin[0] != 0) return text("rowBegin[0] is %" PRIu64 ": must be 0", p.rowBegin[0]);
  return {};
}

/// Order of the columns, numbers that are none, and the diagonal.
std::string rowFault(const AWDRefitProblem& p, uint64_t j, double& diagonal) {
  const uint64_t begin = p.rowBegin[j], end = p.rowBegin[j + 1];
  if (end < begin || end - begin > p.unknowns) {
    return text("rowBegin[%" PRIu64 "] is %" PRIu64 " after %" PRIu64 ": must ascend", j + 1, end,
                begin);
  }
  diagonal = 0.0;
  for (uint64_t i = begin; i < end; ++i) {
    if (p.columns[i] >= p.unknowns || (i > begin && p.columns[i] <= p.columns[i - 1])) {
      return text("columns[%" PRIu64 "] is %u in row %" PRIu64
                  ": must ascend and be below %" PRIu64,
                  i, p.columns[i], j, p.unknowns);
    }
    if (!std::isfinite(p.values[i])) {
      return text("values[%" PRIu64 "] is %g in row %" PRIu64 ": must be finite", i, p.values[i],
                  j);
    }
    if (p.columns[i] == j) diagonal = p.values[i];
  }
  if (!(diagonal >= DBL_MIN)) {
    return text("the diagonal of row %" PRIu64 " is %g: must be positive", j, diagonal);
  }
  return {};
}

std::string vectorFault(const AWDRefitProblem& p, uint64_t j, double diagonal) {
  const struct {
    const char* name;
    double value;
    double term;  ///< the square root of what it adds to Q
  } entries[] = {{"rhs", p.rhs[j], std::abs(p.rhs[j]) / std::sqrt(diagonal)},
                 {"lower", p.lower[j], std::abs(p.lower[j]) * std::sqrt(diagonal)},
                 {"start", p.start[j], std::abs(p.start[j]) * std::sqrt(diagonal)}};
  for (const auto& e : entries) {
    if (!std::isfinite(e.value)) {
      return text("%s[%" PRIu64 "] is %g: must be finite", e.name, j, e.value);
    }
    if (!(e.term <= std::sqrt(kLargestTerm))) {
      return text("%s[%" PRIu64 "] is %g where the diagonal is %g: scale the problem", e.name, j,
                  e.value, diagonal);
    }
  }
  if (p.start[j] < p.lower[j]) {
    return text("start[%" PRIu64 "] is %.17g: must not be below its bound %.17g", j, p.start[j],
                p.lower[j]);
  }
  return {};
}

/// Both halves of A are there and agree, and no 2 x 2 minor is negative.
std::string symmetryFault(const AWDRefitProblem& p, const std::vector<double>& diagonal) {
  // Rows in ascending order meet the entries of any one column in ascending order.
  std::vector<uint64_t> next(p.rowBegin, p.rowBegin + p.unknowns);
  for (uint64_t j = 0; j < p.unknowns; ++j) {
    for (uint64_t i = p.rowBegin[j]; i < p.rowBegin[j + 1]; ++i) {
      const uint32_t k = p.columns[i];
      const uint64_t other = next[k]++;
      if (other >= p.rowBegin[k + 1] || p.columns[other] != j) {
        return text("row %" PRIu64 " has column %u, but row %u lacks column %" PRIu64
                    ": both halves are wanted",
                    j, k, k, j);
      }
      const double geometric = std::sqrt(diagonal[j]) * std::sqrt(diagonal[k]);
      if (std::abs(p.values[i] - p.values[other]) > kSlack * geometric) {
        return text("row %" PRIu64 ", column %u is %.17g but its mirror %.17g: must be equal", j, k,
                    p.values[i], p.values[other]);
      }
      if (std::abs(p.values[i]) > (1.0 + kSlack) * geometric) {
        return text("row %" PRIu64
                    ", column %u is %g between diagonals %g and %g: not positive "
                    "definite",
                    j, k, p.values[i], diagonal[j], diagonal[k]);
      }
    }
  }
  return {};
}

}  // namespace

std::string problemFault(const AWDRefitProblem& problem) {
  std::string fault = headFault(problem);
  if (!fault.empty()) return fault;
  std::vector<double> diagonal(problem.unknowns);
  for (uint64_t j = 0; j < problem.unknowns; ++j) {
    fault = rowFault(problem, j, diagonal[j]);
    if (fault.empty()) fault = vectorFault(problem, j, diagonal[j]);
    if (!fault.empty()) return fault;
  }
  return symmetryFault(problem, diagonal);
}

bool hasStart(const AWDRefitProblem& problem) {
  return problem.structSize >= sizeof(AWDRefitProblem) && problem.unknowns >= 1 &&
         problem.unknowns <= kMostUnknowns && problem.start;
}

}  // namespace awd
