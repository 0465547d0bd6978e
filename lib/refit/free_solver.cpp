// SPDX-License-Identifier: Apache-2.0
#include "refit/free_solver.h"

#include "refit/conjugate_gradients.h"

namespace awd {

namespace {

/// Direct solution up to so many operations and entries at once; up to the second pair where
/// conjugate gradients have failed.
constexpr double kOperationsAtOnce = 0x1p27, kMostOperations = 0x1p37;
constexpr uint64_t kEntriesAtOnce = uint64_t{1} << 24, kMostEntries = uint64_t{1} << 27;

/// Of a residual; who wants more digits solves for what is left.
constexpr double kReduction = 0x1p-30;
constexpr uint32_t kMostSteps = 400;

}  // namespace

void FreeSolver::prepare(const FreeSet& set, double fraction) {
  if (!cholesky_) {
    cholesky_.emplace(quadratic_);
    direct_ =
        cholesky_->operations() <= kOperationsAtOnce && cholesky_->entries() <= kEntriesAtOnce;
  }
  set_ = &set;
  fraction_ = fraction;
  if (direct_) cholesky_->factor(set.isFree, set.extra, fraction);
}

void FreeSolver::solve(std::vector<double>& r) {
  for (uint32_t j = 0; j < quadratic_.size(); ++j) {
    if (!set_->isFree[j]) r[j] = 0.0;
  }
  if (!direct_) {
    const std::vector<double> wanted = r;
    if (conjugateGradients(quadratic_, *set_, kReduction, kMostSteps, fraction_, r)) return;
    direct_ = cholesky_->operations() <= kMostOperations && cholesky_->entries() <= kMostEntries;
    if (!direct_) return;  // as near as it came
    r = wanted;
    cholesky_->factor(set_->isFree, set_->extra, fraction_);
  }
  cholesky_->solve(r);
}

}  // namespace awd
