// SPDX-License-Identifier: Apache-2.0
#include "refit/descent.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "refit/interior_point.h"
#include "refit/pivoting.h"

namespace awd {

namespace {

/// Sweeps before the first polish, and between two.
constexpr int kFirstSweeps = 6, kSweeps = 2;
constexpr uint32_t kMostRounds = 40;

/// A violation that is nothing but rounding; of a row of many entries that of a random walk.
constexpr double kRounding = 0x1p-51;
/// Where rounds no longer lower it, a violation up to this is as good as can be.
constexpr double kStagnation = 0x1p-34;
constexpr uint32_t kPatience = 4;

class Descent {
 public:
  Descent(const Quadratic& quadratic, std::vector<double>& c)
      : quadratic_(quadratic), c_(c), solver_(quadratic), set_(quadratic.size()) {
    uint64_t longest = 0;
    const AWDRefitProblem& p = quadratic.problem();
    for (uint64_t j = 0; j < p.unknowns; ++j) {
      longest = std::max(longest, p.rowBegin[j + 1] - p.rowBegin[j]);
    }
    rounding_ = kRounding * std::sqrt(static_cast<double>(longest) + 1.0);
  }

  Ending run() {
    double best = HUGE_VAL;
    uint32_t patience = kPatience;
    while (true) {
      for (int i = 0; i < (polishes_ == 0 ? kFirstSweeps : kSweeps); ++i) sweep();
      violation_ = quadratic_.optimality(c_).violation;
      if (violation_ <= rounding_) return ending(AWD_REFIT_CONVERGED);
      if (!std::isfinite(violation_)) {
        return {AWD_REFIT_FAILED, sweeps_, "diverged: the matrix is not positive definite"};
      }
      patience = violation_ < 0.5 * best ? kPatience : patience - 1;
      best = std::min(best, violation_);
      if (patience == 0 || polishes_ == kMostRounds) {
        return ending(violation_ <= kStagnation ? AWD_REFIT_CONVERGED : AWD_REFIT_LIMIT);
      }
      polish();
    }
  }

 private:
  /// Each unknown in turn to its own optimum; there and back in turns.
  void sweep() {
    const uint32_t n = quadratic_.size();
    const bool back = sweeps_ % 2 != 0;
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t j = back ? n - 1 - i : i;
      const double next = c_[j] - quadratic_.gradient(j, c_.data()) / quadratic_.diagonal(j);
      c_[j] = std::max(next, quadratic_.lower(j));
    }
    ++sweeps_;
    reportProgress(quadratic_.problem(), fraction());
  }

  /// To the optimum at once, if the bounds that hold there can be found.
  void polish() {
    ++polishes_;
    std::vector<double> x = c_;
    for (uint32_t j = 0; j < quadratic_.size(); ++j) {
      set_.isFree[j] = c_[j] > quadratic_.lower(j) || quadratic_.gradient(j, c_.data()) < 0.0;
    }
    if (pivot(quadratic_, solver_, fraction(), set_, x)) return takeIfLower(x);
    x = c_;
    ++paths_;
    followCentralPath(quadratic_, solver_, fraction(), set_, x);
    takeIfLower(x);
    if (pivot(quadratic_, solver_, fraction(), set_, x)) takeIfLower(x);
  }

  void takeIfLower(const std::vector<double>& x) {
    const uint32_t n = quadratic_.size();
    std::vector<double> gradient(n), step(n);
    for (uint32_t j = 0; j < n; ++j) {
      gradient[j] = quadratic_.gradient(j, c_.data());
      step[j] = std::max(x[j], quadratic_.lower(j)) - c_[j];
    }
    if (!(quadratic_.change(gradient, step) < 0.0)) return;
    for (uint32_t j = 0; j < n; ++j) c_[j] = std::max(x[j], quadratic_.lower(j));
  }

  /// How many of the digits to be had are there.
  double fraction() const {
    return std::min(std::max(std::log(violation_) / std::log(rounding_), 0.0), 1.0);
  }

  Ending ending(AWDRefitStatus status) const {
    char message[160];
    std::snprintf(
        message, sizeof message,
        "%s after %u sweeps, %u polishes and %u central paths; gradient %.1e of its terms",
        status == AWD_REFIT_CONVERGED ? "converged" : "stopped", sweeps_, polishes_, paths_,
        violation_);
    return {status, sweeps_, message};
  }

  const Quadratic& quadratic_;
  std::vector<double>& c_;
  FreeSolver solver_;
  FreeSet set_;
  double rounding_ = kRounding;
  double violation_ = 1.0;
  uint32_t sweeps_ = 0, polishes_ = 0, paths_ = 0;
};

}  // namespace

Ending minimiseByDescent(const Quadratic& quadratic, std::vector<double>& c) {
  return Descent(quadratic, c).run();
}

}  // namespace awd
