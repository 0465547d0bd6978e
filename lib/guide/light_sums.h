// SPDX-License-Identifier: Apache-2.0
// What the shadow rays of a patch bring during a pass, light by light: the sums of their squares.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <vector>

#include "density/fixed_sums.h"

namespace awd {

class LightSums : public FixedSums {
 public:
  LightSums(std::pmr::memory_resource* memory, uint32_t lights, int unitExponent)
      : FixedSums(unitExponent), cells_(lights, memory) {}

  /// For values of this root mean square: room for 2^31 of them, or 2^11 that are 2^10 times it.
  static int unitExponentFor(double magnitude) {
    return FixedSums::unitExponentFor(magnitude) + kUsualBits / 2;
  }

  void record(uint32_t light, double value) noexcept {
    cells_[light].count.fetch_add(1, kOrder);
    if (!accept(value) || !(value > 0.0)) return;
    double units = measure(value);
    if (units > kLargestRoot) {
      saturate();
      units = kLargestRoot;
    }
    const double rounded = units * units + 0.5;  // to the nearest: std::llrint is a call
    accumulate(cells_[light].sum, static_cast<int64_t>(rounded));
  }

  uint32_t lights() const { return static_cast<uint32_t>(cells_.size()); }
  uint64_t count(uint32_t light) const { return cells_[light].count.load(kOrder); }
  uint64_t samples() const {
    uint64_t sum = 0;
    for (const Cell& cell : cells_) sum += cell.count.load(kOrder);
    return sum;
  }
  /// The sum of the squares of a light's values.
  double squares(uint32_t light) const {
    const int64_t sum = std::max<int64_t>(cells_[light].sum.load(kOrder), 0);  // forged, if less
    return std::ldexp(static_cast<double>(sum), 2 * unitExponent());
  }
  /// A magnitude to set the next pass's unit by; 0 where there was no light.
  double magnitude() const;

  /// Of as many lights and the same unit.
  void add(const LightSums& other) noexcept;
  /// As of SquareValues.
  template <class Visitor>
  void visit(Visitor& visitor) {
    if (cells_.empty()) return;
    for (Cell& cell : cells_) {
      visitor.count(cell.count);
      visitor.sum(cell.sum);
    }
    visitFlaws(visitor);
  }
  void clear() noexcept;
  void put(ByteWriter& writer) const;
  void get(ByteReader& reader);
  std::size_t bytes() const { return cells_.size() * sizeof(Cell); }

 private:
  struct Cell {
    std::atomic<int64_t> sum{0};
    std::atomic<uint64_t> count{0};
  };
  /// Of kLargestUnits, which squares may reach.
  static constexpr double kLargestRoot = 0x1p26;

  std::pmr::vector<Cell> cells_;
};

}  // namespace awd
