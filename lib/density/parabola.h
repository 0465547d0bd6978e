// SPDX-License-Identifier: Apache-2.0
// Inverting the integral of a parabola, split so that a block of samples takes the usual steps
// without branches, and only those that these leave off the target go on alone.
#pragma once

#include <cmath>
#include <limits>

namespace awd {

/// Newton's method for integral(t) = target, kept within a shrinking bracket. `total` is the
/// integral up to 1.
template <class Integral, class Density>
double newton(double t, double target, double total, Integral&& integral, Density&& density) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double miss = integral(t) - target;
    if (std::abs(miss) <= 4.0 * epsilon * total) break;
    (miss > 0.0 ? high : low) = t;
    double next = t - miss / density(t);
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= epsilon * t) break;
    t = next;
  }
  return t;
}

/// F(t) = u F(1), F the integral of the parabola with Bernstein coefficients b0, b1, b2.
class ParabolaCdf {
 public:
  ParabolaCdf(double b0, double b1, double b2, double u)
      : b0_(b0),
        b2_(b2),
        c1_(b1 - b0),
        c2_((b2 - b1) - c1_),
        third_(c2_ * (1.0 / 3.0)),
        u_(u),
        total_((b0 + b1 + b2) * (1.0 / 3.0)) {}

  /// Two steps of Householder's method of fourth order, from the straight line between the ends.
  /// Leaves rounding only unless the density is much bent: then it may be anything, even NaN.
  double guess() const {
    double t = line();
    for (int i = 0; i < 2; ++i) {
      // With f the miss: t -= f (f'^2 - f f''/2) / (f'^3 - f f' f'' + f^2 f'''/6).
      const double off = miss(t);
      const double slope = density(t);
      const double square = slope * slope;
      const double bend = off * (c1_ + t * c2_);
      t -= off * (square - bend) / (slope * (square - 2.0 * bend) + third_ * off * off);
    }
    return t;
  }

  /// Whether a guess is one but for rounding. Without `&&`, which is a branch.
  bool solvedBy(double t) const {
    return (t > 0.0) & (t <= 1.0) & (std::abs(miss(t)) <= kTolerance * total_);
  }

  /// For guesses that are none.
  double solve() const {
    const double start = line();
    return newton(
        start > 0.0 && start <= 1.0 ? start : u_, u_ * total_, total_,
        [this](double t) { return integral(t); }, [this](double t) { return density(t); });
  }

 private:
  static constexpr double kTolerance = 8.0 * std::numeric_limits<double>::epsilon();

  /// The inverse for the line, as invertLinearCdf has it; NaN if both ends are 0.
  double line() const {
    return u_ * (b0_ + b2_) / (b0_ + std::sqrt((1.0 - u_) * b0_ * b0_ + u_ * b2_ * b2_));
  }
  double integral(double t) const { return t * (b0_ + t * (c1_ + t * third_)); }
  double density(double t) const { return b0_ + t * (2.0 * c1_ + t * c2_); }
  double miss(double t) const { return integral(t) - u_ * total_; }

  double b0_, b2_, c1_, c2_, third_, u_, total_;
};

}  // namespace awd
