// SPDX-License-Identifier: Apache-2.0
#include "refit_functions.h"

#include <cmath>

namespace bench::refit {
namespace {

constexpr std::size_t kLine = 8192;       // points in one dimension
constexpr std::size_t kSquare = 256;      // along an axis in two
constexpr std::size_t kMany = 1u << 17u;  // in more

double bell(const double* x, int d, double centre, double deviation) {
  double squares = 0.0;
  for (int i = 0; i < d; ++i) squares += (x[i] - centre) * (x[i] - centre);
  return std::exp(-0.5 * squares / (deviation * deviation));
}

double peak(const double* x, int d) { return 0.02 + bell(x, d, 0.37, 0.15); }

double ridge(const double* x, int d) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < d; ++i) {
    sum += x[i];
    squares += x[i] * x[i];
  }
  return 0.01 + std::exp(-0.5 * (squares - sum * sum / d) / (0.07 * 0.07));
}

double ball(const double* x, int d) {
  double squares = 0.0;
  for (int i = 0; i < d; ++i) squares += (x[i] - 0.45) * (x[i] - 0.45);
  return squares < 0.33 * 0.33 ? 1.0 : 0.01;
}

double wave(const double* x, int d) {
  double phase = 0.4;
  for (int i = 0; i < d; ++i) phase += 2.0 * M_PI * (i == 0 ? 2.0 : 1.0) * x[i];
  return 1.0 + std::cos(phase);
}

double twoPeaks(const double* x, int d) {
  return bell(x, d, 0.3, 0.1) + 1e-4 * bell(x, d, 0.75, 0.1);
}

/// Points of Kronecker's sequence with the powers of 1/g, g the positive root of g^(d+1) = g + 1.
std::vector<double> kronecker(int d) {
  double g = 1.5;
  for (int i = 0; i < 64; ++i) g = std::pow(1.0 + g, 1.0 / (d + 1));
  std::vector<double> points;
  points.reserve(kMany * static_cast<std::size_t>(d));
  for (std::size_t i = 1; i <= kMany; ++i) {
    double step = 1.0;
    for (int a = 0; a < d; ++a) {
      step /= g;
      const double at = 0.5 + static_cast<double>(i) * step;
      points.push_back(at - std::floor(at));
    }
  }
  return points;
}

std::vector<double> pointsOf(int d) {
  std::vector<double> points;
  if (d == 1) {
    for (std::size_t i = 0; i < kLine; ++i)
      points.push_back((static_cast<double>(i) + 0.5) / kLine);
    return points;
  }
  if (d > 2) return kronecker(d);
  for (std::size_t i = 0; i < kSquare; ++i) {
    for (std::size_t k = 0; k < kSquare; ++k) {
      points.push_back((static_cast<double>(i) + 0.5) / kSquare);
      points.push_back((static_cast<double>(k) + 0.5) / kSquare);
    }
  }
  return points;
}

}  // namespace

const std::vector<Function>& functions() {
  static const std::vector<Function> all = {{"peak", peak, 1},
                                            {"ridge", ridge, 2},
                                            {"ball", ball, 1},
                                            {"wave", wave, 1},
                                            {"two peaks", twoPeaks, 1}};
  return all;
}

const char* nameOf(Noise noise) {
  if (noise == Noise::kNone) return "none";
  return noise == Noise::kExponential ? "exponential" : "outliers";
}

double draw(Noise noise, awdtest::Random& random) {
  constexpr double kChance = 1e-3, kFactor = 300.0;
  const double u = random.uniform();
  if (noise == Noise::kNone) return 1.0;
  if (noise == Noise::kExponential) return -std::log1p(-u);
  return u < kChance ? kFactor : (1.0 - kChance * kFactor) / (1.0 - kChance);
}

Truth::Truth(const Function& function, int dimensions) : points_(pointsOf(dimensions)) {
  const std::size_t count = points_.size() / static_cast<std::size_t>(dimensions);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    values_.push_back(
        function.value(&points_[i * static_cast<std::size_t>(dimensions)], dimensions));
    sum += values_.back();
  }
  for (double& value : values_) value *= static_cast<double>(count) / sum;
}

Truth::Distance Truth::distance(const std::vector<double>& pdfs) const {
  double squares = 0.0, errors = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double f = values_[i], error = pdfs[i] - f;
    squares += f * f;
    errors += error * error;
    // int f^2/p - 1 = int (f - p)^2 / p, which can't cancel.
    moment += error * error / pdfs[i];
  }
  return {std::sqrt(errors / squares), moment / static_cast<double>(values_.size())};
}

}  // namespace bench::refit
