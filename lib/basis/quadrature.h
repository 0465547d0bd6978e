// SPDX-License-Identifier: Apache-2.0
// Gauss-Legendre quadrature, exact for the product of any two functions of a family on a cell.
#pragma once

#include "basis/bernstein.h"

namespace awd {

struct GaussRule {
  GaussRule();
  double points[kMaxOrder];   ///< in (0,1), ascending
  double weights[kMaxOrder];  ///< sum to 1
};

}  // namespace awd
