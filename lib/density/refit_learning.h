// SPDX-License-Identifier: Apache-2.0
// What grids and trees have in common when they learn by the estimator `refit`.
#pragma once

#include "density/learning.h"

namespace awd {

/// From the coefficients of the cascade, in place, to those of the refit, which the floor tau
/// bounds from below and the cascade pulls. weights: their w_j, of sum 1. Leaves them as they are
/// if their integral is not positive and finite. smooth: not piecewise constant.
void refitFromCascade(const LearningSettings& settings, bool smooth, double samples,
                      const NormalEquations& equations, const Coefficients& weights,
                      Coefficients& coefficients, RefitReport& report);

}  // namespace awd
