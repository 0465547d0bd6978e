// SPDX-License-Identifier: Apache-2.0
// Functions on the unit cube whose integrals are known.
#pragma once

#include <array>
#include <vector>

namespace bench {

constexpr int kMostDimensions = 6;

/// The first six are Genz's families (A. Genz, A package for testing multiple integration
/// subroutines, 1987) with parameters a and u.
enum class Family {
  kOscillatory,    ///< cos(2 pi u_1 + sum a_i x_i)
  kProductPeak,    ///< prod 1 / (a_i^-2 + (x_i - u_i)^2)
  kCornerPeak,     ///< (1 + sum a_i x_i)^-(d + 1)
  kGaussian,       ///< exp(-sum a_i^2 (x_i - u_i)^2)
  kC0,             ///< exp(-sum a_i |x_i - u_i|)
  kDiscontinuous,  ///< exp(sum a_i x_i) where x_1 <= u_1 and x_2 <= u_2, else 0
  kRidge,          ///< exp(-r^2 / (2 0.1^2)), r the distance from the diagonal
  kTwoPeaks        ///< Gaussians of deviation 0.1 at 1/3 and 2/3 of the diagonal
};

class Integrand {
 public:
  /// One instance for each family and dimension: a_i and u_i are uniform in [0,1), seeded by the
  /// two, and a is then scaled to Genz's difficulty, sum a_i = h / d^e with (h, e) of his table:
  /// (110, 1.5), (600, 2), (600, 2), (100, 1), (150, 2), (100, 2).
  Integrand(Family family, int dimensions);

  double operator()(const double* x) const;

  int dimensions() const { return dimensions_; }
  double integral() const { return integral_; }
  const char* name() const;

 private:
  double exactIntegral() const;

  Family family_;
  int dimensions_;
  std::array<double, kMostDimensions> a_{}, u_{};
  double integral_ = 0.0;
};

std::vector<Integrand> allIntegrands(int dimensions);

}  // namespace bench
