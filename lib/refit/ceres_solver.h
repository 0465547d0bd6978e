// SPDX-License-Identifier: Apache-2.0
// The solver "ceres". The only files that know Ceres and Eigen.
#pragma once

#include "refit/solver.h"

namespace awd {

Ending minimiseByCeres(const Quadratic& quadratic, std::vector<double>& c);

}  // namespace awd
