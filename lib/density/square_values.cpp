// SPDX-License-Identifier: Apache-2.0
#include "density/square_values.h"

#include <algorithm>
#include <limits>
#include <new>

#include "density/point.h"

namespace awd {

SquareValues::SquareValues(std::pmr::memory_resource* memory, const BasisLevel& level,
                           int unitExponent)
    : FixedSums(unitExponent),
      memory_(memory),
      levels_{&level, &level},
      components_(std::size_t{level.count} * level.count),
      order_(commonOrder(levels_, 2)),
      nodal_(NodalSquare::fits(level)),
      sums_(static_cast<Sum*>(memory->allocate(components_ * sizeof(Sum), alignof(Sum)))) {
  for (std::size_t i = 0; i < components_; ++i) new (&sums_[i]) Sum(0);
}

SquareValues::~SquareValues() {
  memory_->deallocate(sums_, components_ * sizeof(Sum), alignof(Sum));
}

void SquareValues::record(float u, float v, double p, double f) noexcept {
  if (!accept(f) || !(f > 0.0)) return;
  double value = measure(std::min(f / p, std::numeric_limits<double>::max()));
  if (value > kLargestUnits) {
    saturate();
    value = kLargestUnits;
  }
  if (nodal_) return recordNodes(u, v, value);
  const double x[2] = {u, v};
  withOrder(order_, [&](auto order) { recordAlive<order>(x, value); });
}

/// What recordAlive<2>() does where the functions alive are those at the corners of a cell.
void SquareValues::recordNodes(float u, float v, double value) noexcept {
  const uint32_t cells = levels_[0]->cells;
  const NodalSquare::Place along[2] = {NodalSquare::placeOf(u, cells),
                                       NodalSquare::placeOf(v, cells)};
  const double t[2] = {along[0].t, along[1].t};
  Sum* below = sums_ + std::size_t{along[0].cell} * (cells + 1) + along[1].cell;
  Sum* above = below + cells + 1;
  const auto add = [&](Sum& sum, double atU, double atV) {
    const double rounded = value * (atU * atV) + 0.5;  // as below
    accumulate(sum, static_cast<int64_t>(rounded));
  };
  add(below[0], 1.0 - t[0], 1.0 - t[1]);
  add(below[1], 1.0 - t[0], t[1]);
  add(above[0], t[0], 1.0 - t[1]);
  add(above[1], t[0], t[1]);
}

template <uint32_t order>
void SquareValues::recordAlive(const double x[2], double value) noexcept {
  AxisValues at[2];
  evaluatePoint<2, order>(levels_, x, at);
  const std::size_t strides[2] = {levels_[0]->count, 1};
  forEachAlive<2>(strides, at, [&](std::size_t j, double n) {
    const double above = value * n + 0.5;  // to the nearest: std::llrint is a call
    accumulate(sums_[j], static_cast<int64_t>(above));
  });
}

double SquareValues::sum(std::size_t component) const {
  return std::ldexp(static_cast<double>(sums_[component].load(kOrder)), unitExponent());
}

double SquareValues::total() const {
  double total = 0.0;
  for (std::size_t i = 0; i < components_; ++i) total += sum(i);
  return total;
}

void SquareValues::add(const SquareValues& other) noexcept {
  for (std::size_t i = 0; i < components_; ++i) accumulate(sums_[i], other.sums_[i].load(kOrder));
  addFlaws(other);
}

void SquareValues::clear() noexcept {
  for (std::size_t i = 0; i < components_; ++i) sums_[i].store(0, kOrder);
  clearFlaws();
}

}  // namespace awd
