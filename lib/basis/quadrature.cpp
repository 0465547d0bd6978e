// SPDX-License-Identifier: Apache-2.0
#include "basis/quadrature.h"

#include <cmath>

namespace awd {

GaussRule::GaussRule() {
  const double pi = std::acos(-1.0);
  constexpr int n = kMaxOrder;
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(pi * (i + 0.75) / (n + 0.5)), slope = 1.0;
    for (int step = 0; step < 8; ++step) {  // Newton on the Legendre polynomial of degree n
      double p = 1.0, before = 0.0;
      for (int k = 0; k < n; ++k) {
        const double next = ((2 * k + 1) * x * p - k * before) / (k + 1);
        before = p;
        p = next;
      }
      slope = n * (x * p - before) / (x * x - 1.0);
      x -= p / slope;
    }
    points[i] = 0.5 + 0.5 * x;
    weights[i] = 1.0 / ((1.0 - x * x) * slope * slope);
  }
}

}  // namespace awd
