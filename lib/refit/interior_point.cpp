// SPDX-License-Identifier: Apache-2.0
#include "refit/interior_point.h"

#include <algorithm>
#include <cmath>

namespace awd {

namespace {

using Vector = std::vector<double>;

constexpr uint32_t kMostSteps = 60;

/// Mean of slack times multiplier to end at. Multipliers come as small as lambda, and those of
/// unknowns that are held must still stand out against their slacks.
constexpr double kEnough = 1e-18;

/// Of slacks and multipliers at the start, at least: far enough from the border to have a way.
constexpr double kStart = 0.1;

/// How far to go towards the border, at least.
constexpr double kShy = 0.9;

/// s = x - lower and z = g(x), both positive, with s z -> 0. Both are counted in units of their
/// unknown, so that the way is the same whatever the units of A, b and x.
class CentralPath {
 public:
  CentralPath(const Quadratic& quadratic, FreeSolver& solver, FreeSet& set, Vector& x)
      : quadratic_(quadratic), solver_(solver), set_(set), x_(x), n_(quadratic.size()) {
    std::fill(set.isFree.begin(), set.isFree.end(), 1);
    for (uint32_t j = 0; j < n_; ++j) {
      const double magnitude = quadratic.magnitude(j, x.data());
      const double curvature = quadratic.diagonal(j);
      unit_[j] = magnitude > 0.0 ? magnitude * magnitude / curvature : 1.0;
      slack_[j] = std::max(x[j] - quadratic.lower(j), kStart * std::sqrt(unit_[j] / curvature));
      multiplier_[j] =
          std::max(quadratic.gradient(j, x.data()), kStart * std::sqrt(unit_[j] * curvature));
    }
  }

  void run(double fraction) {
    for (uint32_t step = 0; step < kMostSteps && !near(); ++step) {
      for (uint32_t j = 0; j < n_; ++j) set_.extra[j] = multiplier_[j] / slack_[j];
      solver_.prepare(set_, fraction);
      // Straight to s z = 0, to see how far that leads; then to where it leads, corrected by what
      // that step showed of the curvature of s z.
      for (uint32_t j = 0; j < n_; ++j) product_[j] = -slack_[j] * multiplier_[j];
      findDirection();
      const double ahead = gap(reach());
      const double centre = std::pow(ahead / gap_, 3) * gap_;
      for (uint32_t j = 0; j < n_; ++j) {
        product_[j] =
            centre * unit_[j] - slack_[j] * multiplier_[j] - slackStep_[j] * multiplierStep_[j];
      }
      findDirection();
      const double part = std::min(1.0, std::max(kShy, 1.0 - gap_) * reach());
      for (uint32_t j = 0; j < n_; ++j) {
        slack_[j] += part * slackStep_[j];
        multiplier_[j] += part * multiplierStep_[j];
      }
    }
    for (uint32_t j = 0; j < n_; ++j) {
      set_.isFree[j] = slack_[j] * quadratic_.diagonal(j) > multiplier_[j];
      x_[j] = quadratic_.lower(j) + slack_[j];
    }
  }

 private:
  /// Updates x, the residual of z = g(x) and the gap; whether both are small.
  bool near() {
    for (uint32_t j = 0; j < n_; ++j) x_[j] = quadratic_.lower(j) + slack_[j];
    bool small = true;
    for (uint32_t j = 0; j < n_; ++j) {
      residual_[j] = quadratic_.gradient(j, x_.data()) - multiplier_[j];
      small = small && residual_[j] * residual_[j] < kEnough * unit_[j] * quadratic_.diagonal(j);
    }
    gap_ = gap(0.0);
    return small && gap_ < kEnough;
  }

  /// Solves A ds - dz = -residual, z ds + s dz = product.
  void findDirection() {
    for (uint32_t j = 0; j < n_; ++j) slackStep_[j] = product_[j] / slack_[j] - residual_[j];
    solver_.solve(slackStep_);
    for (uint32_t j = 0; j < n_; ++j) {
      multiplierStep_[j] = (product_[j] - multiplier_[j] * slackStep_[j]) / slack_[j];
    }
  }

  /// Part of the step that leads to the border, at most all of it.
  double reach() const {
    double part = 1.0;
    for (uint32_t j = 0; j < n_; ++j) {
      if (slackStep_[j] < 0.0) part = std::min(part, -slack_[j] / slackStep_[j]);
      if (multiplierStep_[j] < 0.0) part = std::min(part, -multiplier_[j] / multiplierStep_[j]);
    }
    return part;
  }

  /// Mean of s z after a part of the step.
  double gap(double part) const {
    double sum = 0.0;
    for (uint32_t j = 0; j < n_; ++j) {
      sum += (slack_[j] + part * slackStep_[j]) * (multiplier_[j] + part * multiplierStep_[j]) /
             unit_[j];
    }
    return sum / n_;
  }

  const Quadratic& quadratic_;
  FreeSolver& solver_;
  FreeSet& set_;
  Vector& x_;
  uint32_t n_;
  Vector unit_ = Vector(n_);  ///< of s z
  Vector slack_ = Vector(n_), multiplier_ = Vector(n_), residual_ = Vector(n_);
  Vector product_ = Vector(n_), slackStep_ = Vector(n_), multiplierStep_ = Vector(n_);
  double gap_ = 0.0;
};

}  // namespace

void followCentralPath(const Quadratic& quadratic, FreeSolver& solver, double fraction,
                       FreeSet& set, Vector& x) {
  CentralPath(quadratic, solver, set, x).run(fraction);
}

}  // namespace awd
