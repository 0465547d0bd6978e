// SPDX-License-Identifier: Apache-2.0
#include "density/square_statistics.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>

namespace awd {

namespace {

/// One sample adds at most 2^52 units: 2^11 of the largest fit, and 2^31 of the usual ones.
constexpr double kLargestUnits = 0x1p52;
constexpr int kUsualBits = 32;

// Non-negative doubles are ordered as their bits are, so that their maximum can be had with integer
// atomics.
uint64_t bitsOf(double value) {
  uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

}  // namespace

SquareStatistics::SquareStatistics(std::pmr::memory_resource* memory, std::size_t components,
                                   int unitExponent)
    : memory_(memory),
      cells_(static_cast<Cell*>(memory->allocate(components * sizeof(Cell), alignof(Cell)))),
      components_(components),
      unitExponent_(unitExponent),
      scale_(unitExponent > -1023 && unitExponent < 1023 ? std::ldexp(1.0, -unitExponent) : 0.0) {
  for (std::size_t i = 0; i < components; ++i) new (&cells_[i]) Cell;
}

SquareStatistics::~SquareStatistics() {
  memory_->deallocate(cells_, components_ * sizeof(Cell), alignof(Cell));
}

int SquareStatistics::unitExponentFor(double magnitude) {
  if (!(magnitude > 0.0) || !std::isfinite(magnitude)) magnitude = 1.0;
  return std::ilogb(magnitude) - kUsualBits;
}

void SquareStatistics::record(std::size_t component, double value) noexcept {
  Cell& cell = cells_[component];
  cell.count.fetch_add(1, kOrder);
  if (!(value >= 0.0) || !std::isfinite(value)) {
    rejected_.fetch_add(1, kOrder);
    return;
  }
  if (value == 0.0) return;
  const uint64_t bits = bitsOf(value);
  uint64_t largest = largestBits_.load(kOrder);
  while (bits > largest && !largestBits_.compare_exchange_weak(largest, bits, kOrder)) {
  }
  double units = scale_ > 0.0 ? value * scale_ : std::ldexp(value, -unitExponent_);
  if (units > kLargestUnits) {
    units = kLargestUnits;
    saturated_.fetch_add(1, kOrder);
  }
  accumulate(cell, std::llrint(units));
}

void SquareStatistics::accumulate(Cell& cell, int64_t units) noexcept {
  // Sums only grow: in whatever order, exactly one addition takes them past the end.
  const int64_t before = cell.sum.fetch_add(units, kOrder);
  int64_t after;
  if (__builtin_add_overflow(before, units, &after)) overflowed_.store(true, kOrder);
}

double SquareStatistics::sum(std::size_t component) const {
  return std::ldexp(static_cast<double>(cells_[component].sum.load(kOrder)), unitExponent_);
}

uint64_t SquareStatistics::samples() const {
  uint64_t total = 0;
  for (std::size_t i = 0; i < components_; ++i) total += count(i);
  return total;
}

double SquareStatistics::largest() const {
  const uint64_t bits = largestBits_.load(kOrder);
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

void SquareStatistics::clear() noexcept {
  for (std::size_t i = 0; i < components_; ++i) {
    cells_[i].count.store(0, kOrder);
    cells_[i].sum.store(0, kOrder);
  }
  largestBits_.store(0, kOrder);
  overflowed_.store(false, kOrder);
  rejected_.store(0, kOrder);
  saturated_.store(0, kOrder);
}

void SquareStatistics::add(const SquareStatistics& other) noexcept {
  for (std::size_t i = 0; i < components_; ++i) {
    cells_[i].count.fetch_add(other.cells_[i].count.load(kOrder), kOrder);
    accumulate(cells_[i], other.cells_[i].sum.load(kOrder));
  }
  if (other.overflowed()) overflowed_.store(true, kOrder);
  largestBits_.store(std::max(largestBits_.load(kOrder), other.largestBits_.load(kOrder)), kOrder);
  rejected_.fetch_add(other.rejected_.load(kOrder), kOrder);
  saturated_.fetch_add(other.saturated_.load(kOrder), kOrder);
}

}  // namespace awd
