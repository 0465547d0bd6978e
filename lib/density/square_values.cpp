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
  const double x[2] = {u, v};
  withOrder(order_, [&](auto order) { recordAlive<order>(x, value); });
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
