// SPDX-License-Identifier: Apache-2.0
// The estimator `refit`: coefficients that minimise the weighted squared residual of the samples,
//   sum_i (f_i - sum_j c_j N_j(x_i))^2 / p_i + lambda S0 sum_j w_j (c_j - prior_j)^2,  c_j >=
//   least,
// from the sums A_jk = sum_i N_j N_k / p_i and b_j = sum_i f_i N_j / p_i; no sample is kept. A
// solver of the refit module does the work.
#pragma once

#include <memory_resource>
#include <string>
#include <vector>

#include "density/binned_sum.h"
#include "density/normal_pattern.h"
#include "density/tensor.h"
#include "refit/refit_module.h"

namespace awd {

/// A solver, and how it tells the host of its progress; returns 0 to give up.
struct Refitter {
  const AWDRefitSolver* solver = nullptr;
  int32_t (*progress)(void* user, double fraction) = nullptr;
  void* user = nullptr;
};

/// A and b as plain numbers in units that go together, rows as the module wants them.
struct NormalEquations {
  explicit NormalEquations(std::pmr::memory_resource* memory)
      : rowBegin(memory), columns(memory), values(memory), rhs(memory) {}
  /// In the same memory, where vectors copied by default would be in that of the process.
  NormalEquations(const NormalEquations& other)
      : rowBegin(other.rowBegin, other.rowBegin.get_allocator()),
        columns(other.columns, other.columns.get_allocator()),
        values(other.values, other.values.get_allocator()),
        rhs(other.rhs, other.rhs.get_allocator()),
        energy(other.energy) {}
  NormalEquations& operator=(const NormalEquations& other) = delete;
  NormalEquations(NormalEquations&& other) = default;
  NormalEquations& operator=(NormalEquations&& other) = delete;
  ~NormalEquations() = default;

  /// Of a grid: A times 2^-exponent.
  void takeMatrix(const NormalPattern& pattern, const std::pmr::vector<BinnedSum>& products,
                  int exponent);
  /// Appends a block of `size` rows that no other row touches.
  void appendBlock(const double* block, std::size_t size);

  std::pmr::vector<uint64_t> rowBegin;
  std::pmr::vector<uint32_t> columns;
  std::pmr::vector<double> values;
  Coefficients rhs;
  double energy = 0.0;  ///< sum f^2 / p
};

/// How it went.
struct RefitReport {
  AWDRefitStatus status = AWD_REFIT_NONE;
  uint32_t iterations = 0;
  uint64_t atBound = 0;
  double lambda = 0.0;
  double objective = 0.0;  ///< residual over that of c = 0, without the term of lambda
  std::string message;
};

/// What the coefficients are pulled towards and may not fall below.
struct RefitPrior {
  const Coefficients& coefficients;  ///< of a finite positive integral
  const Coefficients& weights;       ///< w_j, of sum 1
  double least;
};

/// kappa n / m, never 0: a function that no sample has seen goes by its prior alone.
double refitLambda(double kappa, double coefficients, double samples);

/// The coefficients; those of the prior, raised to the least, if the solver fails. `start`: what
/// the solver begins with, empty for the prior. Throws AWD_ERROR_CANCELLED.
Coefficients refit(const Refitter& refitter, const NormalEquations& equations,
                   const RefitPrior& prior, double lambda, const Coefficients& start,
                   RefitReport& report);

/// The same with lambda = kappa n / m, or if kappa is negative with that of the noise: what a first
/// fit with next to no pull leaves of sum f^2 / p is what no coefficients explain, and the more
/// that is the less a sample is worth beside the prior.
Coefficients refit(const Refitter& refitter, const NormalEquations& equations,
                   const RefitPrior& prior, double kappa, double samples, RefitReport& report);

}  // namespace awd
