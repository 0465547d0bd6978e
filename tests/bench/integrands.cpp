// SPDX-License-Identifier: Apache-2.0
#include "integrands.h"

#include <cmath>
#include <iterator>
#include <random>

namespace bench {
namespace {

constexpr int kFamilies = 8;
constexpr const char* kNames[kFamilies] = {"oscillatory", "product peak", "corner peak",
                                           "gaussian",    "C0",           "discontinuous",
                                           "ridge",       "two peaks"};
constexpr double kWidth = 0.1;  // of ridge and peaks

struct Difficulty {
  double h, e;
};
constexpr Difficulty kDifficulties[] = {{110.0, 1.5}, {600.0, 2.0}, {600.0, 2.0},
                                        {100.0, 1.0}, {150.0, 2.0}, {100.0, 2.0}};

/// int of exp(-(x - centre)^2 / (2 kWidth^2)) over [0,1].
double bell(double centre) {
  const double s = kWidth * std::sqrt(2.0);
  return kWidth * std::sqrt(0.5 * M_PI) * (std::erf((1.0 - centre) / s) + std::erf(centre / s));
}

/// With s = sum x_i: exp(-(|x|^2 - s^2/d) / (2 w^2)) is sqrt(d / (2 pi w^2)) times the integral
/// over t of prod exp(-(x_i - t)^2 / (2 w^2)), so that one integral over t remains. The trapezoidal
/// rule takes it to machine precision: the integrand is analytic and vanishes at both ends.
double ridgeIntegral(int d) {
  constexpr int kSteps = 3000;
  constexpr double kFrom = -1.0, kTo = 2.0;
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    sum += std::pow(bell(kFrom + (kTo - kFrom) * i / kSteps), d);
  }
  return sum * (kTo - kFrom) / kSteps * std::sqrt(d / (2.0 * M_PI)) / kWidth;
}

}  // namespace

Integrand::Integrand(Family family, int dimensions) : family_(family), dimensions_(dimensions) {
  const auto index = static_cast<unsigned>(family);
  std::mt19937_64 random(100 * index + static_cast<unsigned>(dimensions));
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  double sum = 0.0;
  for (int i = 0; i < dimensions; ++i) {
    sum += a_[i] = uniform();
    u_[i] = uniform();
  }
  if (index < std::size(kDifficulties)) {
    const Difficulty& difficulty = kDifficulties[index];
    for (double& a : a_) a *= difficulty.h / std::pow(dimensions, difficulty.e) / sum;
  }
  integral_ = exactIntegral();
}

const char* Integrand::name() const { return kNames[static_cast<int>(family_)]; }

double Integrand::operator()(const double* x) const {
  const int d = dimensions_;
  double sum = 0.0, squares = 0.0, product = 1.0;
  switch (family_) {
    case Family::kOscillatory:
      for (int i = 0; i < d; ++i) sum += a_[i] * x[i];
      return std::cos(2.0 * M_PI * u_[0] + sum);
    case Family::kProductPeak:
      for (int i = 0; i < d; ++i) {
        product *= 1.0 / (a_[i] * a_[i]) + (x[i] - u_[i]) * (x[i] - u_[i]);
      }
      return 1.0 / product;
    case Family::kCornerPeak:
      for (int i = 0; i < d; ++i) sum += a_[i] * x[i];
      return std::pow(1.0 + sum, -(d + 1));
    case Family::kGaussian:
      for (int i = 0; i < d; ++i) sum += a_[i] * a_[i] * (x[i] - u_[i]) * (x[i] - u_[i]);
      return std::exp(-sum);
    case Family::kC0:
      for (int i = 0; i < d; ++i) sum += a_[i] * std::fabs(x[i] - u_[i]);
      return std::exp(-sum);
    case Family::kDiscontinuous:
      if (x[0] > u_[0] || (d > 1 && x[1] > u_[1])) return 0.0;
      for (int i = 0; i < d; ++i) sum += a_[i] * x[i];
      return std::exp(sum);
    case Family::kRidge:
      for (int i = 0; i < d; ++i) {
        sum += x[i];
        squares += x[i] * x[i];
      }
      return std::exp((sum * sum / d - squares) / (2.0 * kWidth * kWidth));
    case Family::kTwoPeaks:
      for (int i = 0; i < d; ++i) {
        sum += (x[i] - 1.0 / 3.0) * (x[i] - 1.0 / 3.0);
        squares += (x[i] - 2.0 / 3.0) * (x[i] - 2.0 / 3.0);
      }
      return std::exp(-sum / (2.0 * kWidth * kWidth)) +
             std::exp(-squares / (2.0 * kWidth * kWidth));
  }
  return 0.0;
}

double Integrand::exactIntegral() const {
  const int d = dimensions_;
  double product = 1.0;
  switch (family_) {
    case Family::kOscillatory: {
      // int of exp(i a x) is exp(i a/2) sin(a/2) / (a/2).
      double phase = 2.0 * M_PI * u_[0];
      for (int i = 0; i < d; ++i) {
        phase += 0.5 * a_[i];
        product *= std::sin(0.5 * a_[i]) / (0.5 * a_[i]);
      }
      return product * std::cos(phase);
    }
    case Family::kProductPeak:
      for (int i = 0; i < d; ++i) {
        product *= a_[i] * (std::atan(a_[i] * (1.0 - u_[i])) + std::atan(a_[i] * u_[i]));
      }
      return product;
    case Family::kCornerPeak: {
      // Integrating d times leaves a signed sum over the corners.
      double sum = 0.0;
      for (unsigned corner = 0; corner < 1u << d; ++corner) {
        double at = 1.0, sign = 1.0;
        for (int i = 0; i < d; ++i) {
          if ((corner >> i & 1u) == 0) continue;
          at += a_[i];
          sign = -sign;
        }
        sum += sign / at;
      }
      for (int i = 0; i < d; ++i) product *= a_[i] * (i + 1);
      return sum / product;
    }
    case Family::kGaussian:
      for (int i = 0; i < d; ++i) {
        product *= 0.5 * std::sqrt(M_PI) / a_[i] *
                   (std::erf(a_[i] * (1.0 - u_[i])) + std::erf(a_[i] * u_[i]));
      }
      return product;
    case Family::kC0:
      for (int i = 0; i < d; ++i) {
        product *= -(std::expm1(-a_[i] * u_[i]) + std::expm1(-a_[i] * (1.0 - u_[i]))) / a_[i];
      }
      return product;
    case Family::kDiscontinuous:
      for (int i = 0; i < d; ++i) product *= std::expm1(a_[i] * (i < 2 ? u_[i] : 1.0)) / a_[i];
      return product;
    case Family::kRidge:
      return ridgeIntegral(d);
    case Family::kTwoPeaks:
      return std::pow(bell(1.0 / 3.0), d) + std::pow(bell(2.0 / 3.0), d);
  }
  return 0.0;
}

std::vector<Integrand> allIntegrands(int dimensions) {
  std::vector<Integrand> all;
  all.reserve(kFamilies);
  for (int i = 0; i < kFamilies; ++i) all.emplace_back(static_cast<Family>(i), dimensions);
  return all;
}

}  // namespace bench
