// SPDX-License-Identifier: Apache-2.0
// What a pass learns about one density: for each component, how many samples were drawn from it
// and the sum of their values. Sums are integers in a unit that is a power of two, frozen for the
// pass: they come out the same whatever the order and the threads that add.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory_resource>

namespace awd {

class SquareStatistics {
 public:
  /// unitExponent: values are summed in units of 2^unitExponent.
  SquareStatistics(std::pmr::memory_resource* memory, std::size_t components, int unitExponent);
  ~SquareStatistics();
  SquareStatistics(const SquareStatistics&) = delete;
  SquareStatistics& operator=(const SquareStatistics&) = delete;

  /// The unit for values whose mean or maximum is of this magnitude: leaves room for 2^31 samples
  /// of that magnitude, or fewer larger ones, without overflow.
  static int unitExponentFor(double magnitude);

  /// Counts a sample of this component; safe from any thread. A value that is not finite or is
  /// negative is rejected and counts as 0; one too large for the unit is clamped and counted.
  void record(std::size_t component, double value) noexcept;

  std::size_t components() const { return components_; }
  uint64_t count(std::size_t component) const { return cells_[component].count.load(kOrder); }
  /// Sum of a component's values; means nothing once a sum has overflowed.
  double sum(std::size_t component) const;
  uint64_t samples() const;
  uint64_t rejected() const { return rejected_.load(kOrder); }
  uint64_t saturated() const { return saturated_.load(kOrder); }
  /// The largest value recorded, before clamping.
  double largest() const;
  bool overflowed() const { return overflowed_.load(kOrder); }

  /// Adds another pass's figures, in the same unit.
  void add(const SquareStatistics& other) noexcept;
  /// Back to no samples.
  void clear() noexcept;
  int unitExponent() const { return unitExponent_; }
  std::size_t bytes() const { return sizeof *this + components_ * sizeof(Cell); }

 private:
  static constexpr std::memory_order kOrder = std::memory_order_relaxed;
  struct Cell {
    std::atomic<uint64_t> count{0};
    std::atomic<int64_t> sum{0};
  };

  void accumulate(Cell& cell, int64_t units) noexcept;

  std::pmr::memory_resource* memory_;
  Cell* cells_;
  std::size_t components_;
  int unitExponent_;
  double scale_;  ///< 2^-unitExponent, or 0 if that is out of range: then ldexp is used
  std::atomic<uint64_t> largestBits_{0};
  std::atomic<bool> overflowed_{false};
  std::atomic<uint64_t> rejected_{0};
  std::atomic<uint64_t> saturated_{0};
};

}  // namespace awd
