// SPDX-License-Identifier: Apache-2.0
// From a pass's samples to the next pass's density: project and clamp (section "Adaptive pdfs"
// of the paper).
#pragma once

#include <memory_resource>
#include <vector>

#include "density/gram.h"
#include "density/square_density.h"
#include "density/square_statistics.h"

namespace awd {

/// The paper's estimate of the coefficients of f: b_jk = (1/n_jk) sum w_j w_k f over the n_jk
/// samples drawn from component (j,k), 0 where there are none; then G c = b on both axes.
/// Coefficients can come out negative. Scaled by a power of two so that the largest b is near 1.
std::pmr::vector<double> project(std::pmr::memory_resource* memory, const BasisLevel& level,
                                 const GramSolver& gram, const SquareStatistics& statistics);

/// Raises coefficients below tau times the mean of max(c, 0); tau <= 0: negative ones to 0. False
/// if there is no usable mean: all zero, or not finite.
bool clampCoefficients(const BasisLevel& level, double tau, std::pmr::vector<double>& coefficients);

}  // namespace awd
