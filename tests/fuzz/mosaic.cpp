// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "basis_table.h"

namespace fuzz {

namespace {

/// Value of a polynomial of `order` Bernstein coefficients, by de Casteljau.
double bernstein(const double* b, uint32_t order, double t) {
  double p[AWD_BASIS_MAX_ORDER + 1];
  std::copy(b, b + order, p);
  for (uint32_t left = order - 1; left > 0; --left) {
    for (uint32_t k = 0; k < left; ++k) p[k] = (1.0 - t) * p[k] + t * p[k + 1];
  }
  return p[0];
}

}  // namespace

void Mosaic::read(Bytes& bytes) {
  cells = 1 + bytes.below(6);
  order = 1 + bytes.below(4);
  alive = 1 + bytes.below(4);
  // Rows slide over the functions from cell to cell, as those of splines do, or stay.
  const uint32_t step = bytes.below(alive + 1);
  count = (cells - 1) * step + alive;
  b.assign(std::size_t{cells} * alive * order, 0.0);
  for (uint32_t c = 0; c < cells; ++c) {
    first.push_back(c * step);
    for (uint32_t k = 0; k < order; ++k) {
      double sum = 0.0;
      for (uint32_t a = 0; a < alive; ++a) {
        double raw = std::abs(bytes.real());
        if (!(raw < 1e6)) raw = 1.0;
        b[(std::size_t{c} * alive + a) * order + k] = raw;
        sum += raw;
      }
      for (uint32_t a = 0; a < alive; ++a) {
        double& coefficient = b[(std::size_t{c} * alive + a) * order + k];
        coefficient = sum > 0.0 ? coefficient / sum : 1.0 / alive;
      }
    }
  }
}

double Mosaic::value(uint32_t cell, uint32_t row, double t) const {
  return bernstein(&b[(std::size_t{cell} * alive + row) * order], order, t);
}

double Mosaic::mass(uint32_t cell, uint32_t row, double t) const {
  double sums[AWD_BASIS_MAX_ORDER + 1] = {0.0};
  const double* from = &b[(std::size_t{cell} * alive + row) * order];
  for (uint32_t k = 0; k < order; ++k) sums[k + 1] = sums[k] + from[k] / order;
  return bernstein(sums, order + 1, t);
}

}  // namespace fuzz
