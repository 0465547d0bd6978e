// SPDX-License-Identifier: Apache-2.0
#include "density/refit.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "basis/module.h"
#include "util/error.h"

namespace awd {

namespace {

/// Far below what any sample weighs, and well above rounding.
constexpr double kLeastLambda = 0x1p-30;
/// kappa of the first fit, and of the second by the share of f^2 that is noise.
constexpr double kFirstKappa = 0.05;
constexpr double kKappaOfNoise = 8.0;
/// The first fit has explained noise too where coefficients are many, by more than can be told
/// where samples are fewer than this share beyond them.
constexpr double kLeastFreedom = 0.125;

/// c' A c
long double quadraticForm(const NormalEquations& equations, const Coefficients& c) {
  long double form = 0.0L;
  for (std::size_t j = 0; j < c.size(); ++j) {
    long double row = 0.0L;
    for (uint64_t i = equations.rowBegin[j]; i < equations.rowBegin[j + 1]; ++i) {
      row += static_cast<long double>(equations.values[i]) * c[equations.columns[i]];
    }
    form += row * c[j];
  }
  return form;
}

/// Residual over that of c = 0.
double relativeResidual(const NormalEquations& equations, const Coefficients& c) {
  long double product = 0.0L;
  for (std::size_t j = 0; j < c.size(); ++j) {
    product += static_cast<long double>(equations.rhs[j]) * c[j];
  }
  const long double residual = equations.energy - 2.0L * product + quadraticForm(equations, c);
  if (!(equations.energy > 0.0)) return 0.0;
  return std::max(static_cast<double>(residual / equations.energy), 0.0);
}

bool allFinite(const Coefficients& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

double dot(const Coefficients& a, const Coefficients& b) {
  double sum = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}

}  // namespace

double refitLambda(double kappa, double coefficients, double samples) {
  return std::max(kappa * coefficients / samples, kLeastLambda);
}

void NormalEquations::takeMatrix(const NormalPattern& pattern,
                                 const std::pmr::vector<BinnedSum>& products, int exponent) {
  rowBegin.assign(pattern.shape().size() + 1, 0);
  pattern.forEachPair([&](std::size_t, std::size_t j, std::size_t k, bool both) {
    ++rowBegin[j + 1];
    if (both) ++rowBegin[k + 1];
  });
  for (std::size_t j = 1; j < rowBegin.size(); ++j) rowBegin[j] += rowBegin[j - 1];
  columns.resize(rowBegin.back());
  values.resize(rowBegin.back());
  // Pairs come in ascending order of their rows on each axis, and so do the columns of a row.
  std::pmr::vector<uint64_t> next(rowBegin.begin(), rowBegin.end() - 1, rowBegin.get_allocator());
  pattern.forEachPair([&](std::size_t entry, std::size_t j, std::size_t k, bool both) {
    const double value = products[entry].plain(exponent);
    columns[next[j]] = static_cast<uint32_t>(k);
    values[next[j]++] = value;
    if (!both) return;
    columns[next[k]] = static_cast<uint32_t>(j);
    values[next[k]++] = value;
  });
}

void NormalEquations::appendBlock(const double* block, std::size_t size) {
  if (rowBegin.empty()) rowBegin.push_back(0);
  const std::size_t first = rowBegin.size() - 1;
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = 0; k < size; ++k) {
      // Symmetric to the bit, which rounding may have left it short of.
      const double value = 0.5 * (block[j * size + k] + block[k * size + j]);
      if (value == 0.0 && j != k) continue;
      columns.push_back(static_cast<uint32_t>(first + k));
      values.push_back(value);
    }
    rowBegin.push_back(columns.size());
  }
}

Coefficients refit(const Refitter& refitter, const NormalEquations& equations,
                   const RefitPrior& prior, double lambda, const Coefficients& start,
                   RefitReport& report) {
  const std::size_t n = prior.coefficients.size();
  Coefficients fallback(prior.coefficients, prior.coefficients.get_allocator());
  for (double& c : fallback) c = std::max(c, prior.least);
  report = {};
  report.lambda = lambda;

  // Scaled so that the mean of the unknowns is 1, and that of the diagonal of A about 1.
  const double mean = dot(prior.coefficients, prior.weights);
  double weight = 0.0;  // S0: the functions sum to 1
  for (const double value : equations.values) weight += value;
  const double rowScale = static_cast<double>(n) / weight;
  NormalEquations scaled(equations);
  for (double& value : scaled.values) value *= rowScale;
  Coefficients lower(n, prior.least / mean, fallback.get_allocator());
  Coefficients begin(start.empty() ? fallback : start, fallback.get_allocator());
  for (std::size_t j = 0; j < n; ++j) {
    const double pull = lambda * prior.weights[j] * static_cast<double>(n);
    const double towards = prior.coefficients[j] / mean;
    begin[j] /= mean;
    scaled.rhs[j] = scaled.rhs[j] * rowScale / mean + pull * towards;
    for (uint64_t i = scaled.rowBegin[j]; i < scaled.rowBegin[j + 1]; ++i) {
      if (scaled.columns[i] == j) scaled.values[i] += pull;
    }
  }

  AWDRefitProblem problem = {};
  problem.structSize = sizeof problem;
  problem.unknowns = n;
  problem.rowBegin = scaled.rowBegin.data();
  problem.columns = scaled.columns.data();
  problem.values = scaled.values.data();
  problem.rhs = scaled.rhs.data();
  problem.lower = lower.data();
  problem.start = begin.data();
  problem.progress = refitter.progress;
  problem.user = refitter.user;
  AWDRefitOutcome outcome = {};
  outcome.structSize = sizeof outcome;
  Coefficients c(n, 0.0, fallback.get_allocator());
  const AWDResult result = refitter.solver->solve(&problem, c.data(), &outcome);
  outcome.message[sizeof outcome.message - 1] = '\0';
  if (result == AWD_ERROR_CANCELLED)
    fail(AWD_ERROR_CANCELLED, "adapt: cancelled by the progress callback");
  if (result == AWD_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();

  report.status = result == AWD_SUCCESS ? outcome.status : AWD_REFIT_FAILED;
  report.iterations = outcome.iterations;
  report.atBound = outcome.atBound;
  report.message = printable(outcome.message, sizeof outcome.message);
  for (double& value : c) value *= mean;
  if (report.status != AWD_REFIT_CONVERGED && report.status != AWD_REFIT_LIMIT) {
    report.status = AWD_REFIT_FAILED;
  } else if (!allFinite(c)) {
    report.status = AWD_REFIT_FAILED;
    report.message = "the solver's coefficients are not finite";
  }
  if (report.status == AWD_REFIT_FAILED) c = fallback;
  for (double& value : c) value = std::max(value, prior.least);
  report.objective = relativeResidual(equations, c);
  return c;
}

Coefficients refit(const Refitter& refitter, const NormalEquations& equations,
                   const RefitPrior& prior, double kappa, double samples, RefitReport& report) {
  const auto n = static_cast<double>(prior.coefficients.size());
  const Coefficients none(prior.coefficients.get_allocator());
  if (kappa >= 0.0) {
    return refit(refitter, equations, prior, refitLambda(kappa, n, samples), none, report);
  }
  Coefficients first =
      refit(refitter, equations, prior, refitLambda(kFirstKappa, n, samples), none, report);
  if (report.status == AWD_REFIT_FAILED) return first;
  const uint32_t iterations = report.iterations;
  const double freedom = std::max(1.0 - n / samples, kLeastFreedom);
  // No more than what the prior leaves, which the samples have hardly been fitted to.
  const double noise =
      std::min(report.objective / freedom, relativeResidual(equations, prior.coefficients));
  const double lambda = refitLambda(kKappaOfNoise * std::min(noise, 1.0), n, samples);
  Coefficients second = refit(refitter, equations, prior, lambda, first, report);
  report.iterations += iterations;
  return second;
}

}  // namespace awd
