// SPDX-License-Identifier: Apache-2.0
#include "refit/conjugate_gradients.h"

#include "refit/solver.h"

namespace awd {

namespace {

using Vector = std::vector<double>;

/// z = ((D + L) D^-1 (D + L'))^-1 r with (A + E)_FF = L + D + L'.
void precondition(const Quadratic& quadratic, const FreeSet& set, const Vector& r, Vector& z) {
  const uint32_t n = quadratic.size();
  for (uint32_t j = 0; j < n; ++j) {
    z[j] = 0.0;
    if (!set.isFree[j]) continue;
    z[j] = (r[j] - quadratic.rowTimesBelow(j, z.data())) / (quadratic.diagonal(j) + set.extra[j]);
  }
  for (uint32_t j = n; j-- > 0;) {
    if (!set.isFree[j]) continue;
    z[j] -= quadratic.rowTimesAbove(j, z.data()) / (quadratic.diagonal(j) + set.extra[j]);
  }
}

double inner(const Vector& a, const Vector& b) {
  double sum = 0.0;
  for (std::size_t j = 0; j < a.size(); ++j) sum += a[j] * b[j];
  return sum;
}

}  // namespace

bool conjugateGradients(const Quadratic& quadratic, const FreeSet& set, double reduction,
                        uint32_t mostSteps, double fraction, Vector& r) {
  const uint32_t n = quadratic.size();
  Vector x(n, 0.0), z(n), image(n, 0.0);
  precondition(quadratic, set, r, z);
  Vector direction = z;
  double energy = inner(r, z);
  const double enough = energy * reduction * reduction;
  bool reached = !(energy > 0.0);
  for (uint32_t step = 0; !reached && step < mostSteps; ++step) {
    for (uint32_t j = 0; j < n; ++j) {
      if (!set.isFree[j]) continue;
      image[j] = quadratic.rowTimes(j, direction.data()) + set.extra[j] * direction[j];
    }
    const double curvature = inner(direction, image);
    if (!(curvature > 0.0)) break;  // singular to rounding: as far as it goes
    const double alpha = energy / curvature;
    for (uint32_t j = 0; j < n; ++j) {
      x[j] += alpha * direction[j];
      r[j] -= alpha * image[j];
    }
    precondition(quadratic, set, r, z);
    const double next = inner(r, z);
    reached = !(next > enough);
    for (uint32_t j = 0; j < n; ++j) direction[j] = z[j] + next / energy * direction[j];
    energy = next;
    reportProgress(quadratic.problem(), fraction);
  }
  r.swap(x);
  return reached;
}

}  // namespace awd
