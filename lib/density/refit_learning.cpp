// SPDX-License-Identifier: Apache-2.0
#include "density/refit_learning.h"

#include <cmath>

#include "density/estimators.h"

namespace awd {

void refitFromCascade(const LearningSettings& settings, bool smooth, double samples,
                      const NormalEquations& equations, const Coefficients& weights,
                      Coefficients& coefficients, RefitReport& report) {
  double mean = 0.0;
  for (std::size_t j = 0; j < weights.size(); ++j) mean += weights[j] * coefficients[j];
  if (!(mean > 0.0) || !std::isfinite(mean)) return;
  const double tau = settleTau(settings.tau, AWD_ESTIMATOR_REFIT, smooth, settings.shrinkage > 0.0,
                               samples, static_cast<double>(coefficients.size()));
  double least = tau * mean;
  const bool squares = settings.target == AWD_TARGET_RMS;  // what is fitted is f^2
  if (squares) {
    least *= least;
    for (double& c : coefficients) c *= c;
  }
  coefficients = refit(settings.refitter, equations, {coefficients, weights, least},
                       settings.refitShrinkage, samples, report);
  if (squares) {
    for (double& c : coefficients) c = std::sqrt(c);
  }
}

}  // namespace awd
