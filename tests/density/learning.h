// SPDX-License-Identifier: Apache-2.0
// What the tests of learning share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "density/densities.h"

namespace awdtest {

constexpr double kNone = -1.0;  // no floor, no cascade

class Learning : public testing::Test {
 protected:
  /// One pass over `f` with evenly spaced uniforms (of two numbers: a square of them).
  static AWDDensityReport evenPass(AWDDensity density, size_t count, const Function& f) {
    const uint32_t width = infoOf(density).uniforms;
    const auto side = width == 1 ? count : static_cast<size_t>(std::sqrt(double(count)));
    std::vector<double> uniforms;
    for (size_t i = 0; i < side; ++i) {
      for (size_t k = 0; k < (width == 1 ? 1 : side); ++k) {
        uniforms.push_back((double(i) + 0.5) / double(side));
        if (width > 1) uniforms.push_back((double(k) + 0.5) / double(side));
      }
    }
    Samples samples = drawWith(density, uniforms);
    samples.evaluate(f);
    record(density, samples);
    return adapt(density);
  }

  Device device_ = newDevice(1u);
};

inline double square(const double* x) { return x[0] * x[0]; }

inline void expectNear(const std::vector<double>& seen, const std::vector<double>& expected,
                       double tolerance) {
  ASSERT_EQ(seen.size(), expected.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(seen[i], expected[i], tolerance * (1.0 + std::fabs(expected[i]))) << i;
  }
}

/// Mean of (f/p)^2 over mean^2, less 1: the variance of one sample in units of the squared
/// integral.
inline double relativeVariance(AWDDensity density, Random& random, const Function& f) {
  const Samples samples = draw(density, 3000, random, f);
  double mean = 0.0, squares = 0.0;
  for (size_t i = 0; i < samples.size(); ++i) {
    const double ratio = samples.values[i] / samples.pdfs[i];
    mean += ratio;
    squares += ratio * ratio;
  }
  return squares * double(samples.size()) / (mean * mean) - 1.0;
}

}  // namespace awdtest
