// SPDX-License-Identifier: Apache-2.0
#include "refit/ceres_solver.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "refit/sparse_factor.h"

namespace awd {

namespace {

/// 200 bytes each inside of Ceres.
constexpr uint64_t kMostEntries = uint64_t{1} << 22;

constexpr uint32_t kMostRounds = 200;

/// Steps after which it is looked anew which bounds hold. A Newton step is the solution where no
/// bound is in its way; where it stalls at bounds more steps lead nowhere.
constexpr int kStepsPerRound = 10;

/// The largest radius makes a step the full Newton step. A round goes on from where the former one
/// came to, and some more: it moves other unknowns.
constexpr double kLargestRadius = 1e16, kSmallestRadius = 1e-8, kWider = 100.0;

/// Gradients against the bounds' will that are taken for rounding, relative to the largest of the
/// terms that they are sums of: aimed at, and good enough where rounds no longer lower them.
constexpr double kAim = 1e-14, kGoodEnough = 1e-9;
constexpr uint32_t kPatience = 6;
/// What counts as a gain, of the sum of squares.
constexpr double kGain = 1e-13;

/// Stands for residuals that overflowed, none of which any step would want.
constexpr double kForbidding = 1e120;

/// One row of L' z - t: what is left of the k-th residual once z_i, i < k, are gone.
class Row final : public ceres::CostFunction {
 public:
  Row(const double* values, int count, double target)
      : values_(values), count_(count), target_(target) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(count, 1);
  }

  /// Always something finite: Ceres prints what is not, and an Evaluate that says it failed.
  bool Evaluate(double const* const* z, double* residual, double** jacobians) const override {
    double sum = -target_;
    for (int i = 0; i < count_; ++i) {
      sum += values_[i] * z[i][0];
      if (jacobians && jacobians[i]) jacobians[i][0] = values_[i];
    }
    *residual = std::abs(sum) < kForbidding ? sum : kForbidding;
    return true;
  }

 private:
  const double* values_;
  int count_;
  double target_;
};

class Watch final : public ceres::IterationCallback {
 public:
  Watch(const AWDRefitProblem& problem, const double& fraction)
      : problem_(problem), fraction_(fraction) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    // Nothing may be thrown through Ceres.
    cancelled = problem_.progress && !problem_.progress(problem_.user, fraction_);
    return cancelled ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
  }

  bool cancelled = false;

 private:
  const AWDRefitProblem& problem_;
  const double& fraction_;
};

ceres::Solver::Options optionsOf() {
  ceres::Solver::Options options;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  // Eigen keeps silent, whereas CHOLMOD prints when a matrix is not positive definite; and without
  // this flag Ceres lists every product of two entries of a row.
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.dynamic_sparsity = true;
  // Interpolation logs a warning when values of the line search lie on a line; the fifth step in a
  // row that rounding turned uphill is an error, which is logged.
  options.line_search_interpolation_type = ceres::BISECTION;
  options.max_num_consecutive_invalid_steps = kStepsPerRound + 1;
  options.initial_trust_region_radius = kLargestRadius;
  options.max_num_iterations = kStepsPerRound;
  options.function_tolerance = 1e-16;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-16;
  return options;
}

/// Q in the unknowns z = P S^-1 c / unit is |L' z - t|^2 / 2 and a constant, with L t = P S b /
/// unit. Ceres's trust region ends above the optimum where its Newton step would leave the bounds:
/// it moves along the step's projection, along which Q need not fall. So unknowns at their bounds
/// whose gradient holds them there are made constant: over the others the projected step does lower
/// Q (Bertsekas 1982). Then it is solved again, until the bounds are held by the right unknowns.
class CeresRefit {
 public:
  CeresRefit(const Quadratic& quadratic, std::vector<double>& c, SparseFactor factor)
      : quadratic_(quadratic), c_(c), factor_(std::move(factor)), n_(quadratic.size()) {
    scaleToUnit();
    build();
  }

  Ending run() {
    double best = HUGE_VAL;
    uint32_t patience = kPatience;
    Watch watch(quadratic_.problem(), fraction_);
    ceres::Solver::Options options = optionsOf();
    options.callbacks.push_back(&watch);
    ceres::Solver::Summary summary;
    while (true) {
      const double violation = holdBounds();
      fraction_ = std::min(std::max(std::log(violation) / std::log(kAim), 0.0), 1.0);
      patience = violation < 0.5 * best ? kPatience : patience - 1;
      best = std::min(best, violation);
      if (violation <= kAim || patience == 0 || rounds_ == kMostRounds) {
        return ending(summary, violation);
      }
      // Ceres prints what it refuses, and there must be nothing that it could.
      std::string refusal;
      if (!options.IsValid(&refusal)) return {AWD_REFIT_FAILED, iterations_, refusal};
      if (!feasible()) return {AWD_REFIT_FAILED, iterations_, "diverged"};
      ceres::Solve(options, &problem_, &summary);
      if (watch.cancelled) throw Cancelled();
      if (!summary.IsSolutionUsable() || summary.iterations.empty()) {
        return {AWD_REFIT_FAILED, iterations_, summary.message};
      }
      ++rounds_;
      iterations_ += static_cast<uint32_t>(summary.iterations.size()) - 1;
      if (summary.final_cost < (1.0 - kGain) * summary.initial_cost) {
        patience = std::max(patience, 2u);
      }
      const double radius = kWider * summary.iterations.back().trust_region_radius;
      options.initial_trust_region_radius =
          std::min(std::max(radius, kSmallestRadius), kLargestRadius);
    }
  }

 private:
  /// Ceres's tolerances are absolute: everything is made of the order of 1.
  void scaleToUnit() {
    const AWDRefitProblem& p = quadratic_.problem();
    double largest = 0.0;
    for (uint32_t j = 0; j < n_; ++j) {
      const double s = factor_.scale[j];
      largest = std::max(
          {largest, std::abs(p.rhs[j] * s), std::abs(p.lower[j] / s), std::abs(p.start[j] / s)});
    }
    const double unit = largest > 0.0 ? largest : 1.0;
    Eigen::VectorXd target(n_);
    for (uint32_t i = 0; i < n_; ++i) {
      const int j = factor_.unknown[i];
      factor_.scale[j] *= unit;
      z_.push_back(c_[j] / factor_.scale[j]);
      lower_.push_back(p.lower[j] / factor_.scale[j]);
      target[i] = p.rhs[j] * factor_.scale[j] / (unit * unit);
    }
    target_ = factor_.lower.triangularView<Eigen::Lower>().solve(target);
  }

  void build() {
    for (uint32_t i = 0; i < n_; ++i) {
      problem_.AddParameterBlock(&z_[i], 1);
      problem_.SetParameterLowerBound(&z_[i], 0, lower_[i]);
    }
    const auto& lower = factor_.lower;
    std::vector<double*> blocks;
    for (uint32_t k = 0; k < n_; ++k) {
      const int begin = lower.outerIndexPtr()[k], count = lower.outerIndexPtr()[k + 1] - begin;
      blocks.clear();
      for (int i = begin; i < begin + count; ++i) blocks.push_back(&z_[lower.innerIndexPtr()[i]]);
      problem_.AddResidualBlock(new Row(lower.valuePtr() + begin, count, target_[k]), nullptr,
                                blocks);
    }
  }

  /// Fetches c, holds what is at its bound for good reason; returns the largest gradient of others.
  double holdBounds() {
    const AWDRefitProblem& p = quadratic_.problem();
    for (uint32_t i = 0; i < n_; ++i) {
      const int j = factor_.unknown[i];
      c_[j] = z_[i] <= lower_[i] ? p.lower[j] : std::max(z_[i] * factor_.scale[j], p.lower[j]);
    }
    double violation = 0.0, largest = 0.0;
    for (uint32_t i = 0; i < n_; ++i) {
      const auto j = static_cast<uint32_t>(factor_.unknown[i]);
      const double g = quadratic_.gradient(j, c_.data());
      const bool held = c_[j] <= p.lower[j] && g > 0.0;
      if (held) {
        problem_.SetParameterBlockConstant(&z_[i]);
      } else {
        problem_.SetParameterBlockVariable(&z_[i]);
        const double room = quadratic_.diagonal(j) * (c_[j] - p.lower[j]);
        violation = std::max(violation, (g > 0.0 ? std::min(g, room) : -g) * factor_.scale[j]);
      }
      largest = std::max(largest, quadratic_.magnitude(j, c_.data()) * factor_.scale[j]);
    }
    return largest > 0.0 ? violation / largest : 0.0;
  }

  bool feasible() const {
    for (uint32_t i = 0; i < n_; ++i) {
      if (!std::isfinite(z_[i]) || z_[i] < lower_[i]) return false;
    }
    return true;
  }

  Ending ending(const ceres::Solver::Summary& summary, double violation) const {
    char message[192];
    std::snprintf(message, sizeof message, "%s in %u rounds; gradient %.1e of its terms; %s",
                  violation <= kGoodEnough ? "converged" : "stopped", rounds_, violation,
                  rounds_ > 0 ? summary.message.c_str() : "optimal at the start");
    return {violation <= kGoodEnough ? AWD_REFIT_CONVERGED : AWD_REFIT_LIMIT, iterations_, message};
  }

  const Quadratic& quadratic_;
  std::vector<double>& c_;
  SparseFactor factor_;
  uint32_t n_;
  std::vector<double> z_, lower_;
  Eigen::VectorXd target_;
  ceres::Problem problem_;
  double fraction_ = 0.0;
  uint32_t rounds_ = 0, iterations_ = 0;
};

}  // namespace

Ending minimiseByCeres(const Quadratic& quadratic, std::vector<double>& c) {
  reportProgress(quadratic.problem(), 0.0);
  SparseFactor factor = sparseFactor(quadratic, kMostEntries);
  if (factor.entries > kMostEntries) {
    char message[160];
    std::snprintf(message, sizeof message,
                  "the matrix's factor would have more than %" PRIu64
                  " entries: take the solver descent",
                  kMostEntries);
    return {AWD_REFIT_FAILED, 0, message};
  }
  if (factor.lower.rows() == 0) {
    return {AWD_REFIT_FAILED, 0, "the matrix is not positive definite to rounding"};
  }
  return CeresRefit(quadratic, c, std::move(factor)).run();
}

}  // namespace awd
