// SPDX-License-Identifier: Apache-2.0
#include "density/square_statistics.h"

#include <new>

namespace awd {

SquareStatistics::SquareStatistics(std::pmr::memory_resource* memory, std::size_t components,
                                   int unitExponent)
    : FixedSums(unitExponent),
      memory_(memory),
      cells_(static_cast<Cell*>(memory->allocate(components * sizeof(Cell), alignof(Cell)))),
      components_(components) {
  for (std::size_t i = 0; i < components; ++i) new (&cells_[i]) Cell;
}

SquareStatistics::~SquareStatistics() {
  memory_->deallocate(cells_, components_ * sizeof(Cell), alignof(Cell));
}

void SquareStatistics::record(std::size_t component, double value) noexcept {
  Cell& cell = cells_[component];
  cell.count.fetch_add(1, kOrder);
  if (!accept(value) || value == 0.0) return;
  double units = measure(value);
  if (units > kLargestUnits) {
    units = kLargestUnits;
    saturate();
  }
  accumulate(cell.sum, std::llrint(units));
}

double SquareStatistics::sum(std::size_t component) const {
  return std::ldexp(static_cast<double>(cells_[component].sum.load(kOrder)), unitExponent());
}

double SquareStatistics::total() const {
  double total = 0.0;
  for (std::size_t i = 0; i < components_; ++i) total += sum(i);
  return total;
}

uint64_t SquareStatistics::samples() const {
  uint64_t total = 0;
  for (std::size_t i = 0; i < components_; ++i) total += count(i);
  return total;
}

void SquareStatistics::clear() noexcept {
  for (std::size_t i = 0; i < components_; ++i) {
    cells_[i].count.store(0, kOrder);
    cells_[i].sum.store(0, kOrder);
  }
  clearFlaws();
}

void SquareStatistics::add(const SquareStatistics& other) noexcept {
  for (std::size_t i = 0; i < components_; ++i) {
    cells_[i].count.fetch_add(other.cells_[i].count.load(kOrder), kOrder);
    accumulate(cells_[i].sum, other.cells_[i].sum.load(kOrder));
  }
  addFlaws(other);
}

}  // namespace awd
