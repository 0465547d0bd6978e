// SPDX-License-Identifier: Apache-2.0
// What densities learn in `awd-bench refit`: functions on the unit cube, the noise that a host's
// estimates of them have, and what a density should have become.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/random.h"

namespace bench::refit {

struct Function {
  const char* name;
  double (*value)(const double* x, int dimensions);
  int leastDimensions;  ///< where it is not the same as another one
};

/// Of a smooth peak, a ridge along the diagonal, a ball in a dim surrounding, a wave that touches
/// 0, and two peaks of which one is 1e4 times higher.
const std::vector<Function>& functions();

/// What a value is multiplied by, independently at each evaluation; the mean is 1.
enum class Noise {
  kNone,
  kExponential,  ///< relative deviation 1
  kOutliers      ///< 300 with probability 1e-3, else about 0.7
};
constexpr Noise kNoises[] = {Noise::kNone, Noise::kExponential, Noise::kOutliers};

const char* nameOf(Noise noise);
double draw(Noise noise, awdtest::Random& random);

/// f / int f at points of equal weight: a grid up to two dimensions, else a Kronecker sequence.
class Truth {
 public:
  Truth(const Function& function, int dimensions);

  struct Distance {
    double l2;        ///< of p to f / int f, relative to the norm of the latter
    double variance;  ///< of f / p under p, relative to the square of int f
  };
  /// pdfs: p at the points.
  Distance distance(const std::vector<double>& pdfs) const;

  const std::vector<double>& points() const { return points_; }
  std::size_t count() const { return values_.size(); }

 private:
  std::vector<double> points_, values_;
};

}  // namespace bench::refit
