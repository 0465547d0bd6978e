// SPDX-License-Identifier: Apache-2.0
// What a pass learns about one density under the estimator `paper`: for each component, how many
// samples were drawn from it and the sum of their values.
#pragma once

#include <memory_resource>

#include "density/fixed_sums.h"

namespace awd {

class SquareStatistics final : public FixedSums {
 public:
  /// unitExponent: values are summed in units of 2^unitExponent.
  SquareStatistics(std::pmr::memory_resource* memory, std::size_t components, int unitExponent);
  ~SquareStatistics();
  SquareStatistics(const SquareStatistics&) = delete;
  SquareStatistics& operator=(const SquareStatistics&) = delete;

  /// Counts a sample of this component; safe from any thread. A value that is not finite or is
  /// negative is rejected and counts as 0; one too large for the unit is clamped and counted.
  void record(std::size_t component, double value) noexcept;

  std::size_t components() const { return components_; }
  uint64_t count(std::size_t component) const { return cells_[component].count.load(kOrder); }
  /// Sum of a component's values; means nothing once a sum has overflowed.
  double sum(std::size_t component) const;
  /// The sum of all values.
  double total() const;
  uint64_t samples() const;

  /// Adds another pass's figures, in the same unit.
  void add(const SquareStatistics& other) noexcept;
  /// As of SquareValues.
  template <class Visitor>
  void visit(Visitor& visitor) {
    for (std::size_t i = 0; i < components_; ++i) {
      visitor.count(cells_[i].count);
      visitor.sum(cells_[i].sum);
    }
    visitFlaws(visitor);
  }
  /// Back to no samples.
  void clear() noexcept;
  void put(ByteWriter& writer) const;
  /// Of as many sums.
  void get(ByteReader& reader);
  std::size_t bytes() const { return sizeof *this + components_ * sizeof(Cell); }

 private:
  struct Cell {
    std::atomic<uint64_t> count{0};
    std::atomic<int64_t> sum{0};
  };

  std::pmr::memory_resource* memory_;
  Cell* cells_;
  std::size_t components_;
};

}  // namespace awd
