// SPDX-License-Identifier: Apache-2.0
// A shortcut into a tree: a grid of at most as many cells as the tree has leaves, each of which
// knows the lowest node that holds all of it. From there only what is finer than the grid is left
// to descend.
#pragma once

#include <array>
#include <memory_resource>
#include <vector>

#include "density/tree.h"

namespace awd {

class TreeIndex {
 public:
  explicit TreeIndex(const Tree& tree);

  /// As Tree::descend, with the same bits in x.
  template <uint32_t D>
  const TreeNode& descend(const Tree& tree, double* x) const {
    std::size_t cell = 0;
    for (uint32_t a = 0; a < D; ++a) {
      const auto along = static_cast<uint32_t>(x[a] * kPower[bits_[a]]);
      cell = cell << bits_[a] | (along - (along >> bits_[a]));  // x = 1 is in the last one
    }
    const Entry& entry = entries_[cell];
    for (uint32_t a = 0; a < D; ++a) {
      // Exact: a power of two, and the fraction that is left.
      const double place = x[a] * kPower[entry.depth[a]];
      const auto along = static_cast<uint32_t>(place);
      x[a] = place - (along - (along >> entry.depth[a]));
    }
    return tree.descend(x, entry.node);
  }
  std::size_t bytes() const { return entries_.capacity() * sizeof(Entry); }

 private:
  static constexpr uint32_t kMostBits = 31;
  static constexpr std::array<double, kMostBits> kPower = [] {
    std::array<double, kMostBits> powers{};
    double power = 1.0;
    for (double& p : powers) {
      p = power;
      power *= 2.0;
    }
    return powers;
  }();

  struct Entry {
    uint32_t node = 0;
    uint8_t depth[kMaxDimensions] = {};
  };

  uint32_t bits_[kMaxDimensions] = {};
  std::pmr::vector<Entry> entries_;  ///< the last axis runs fastest
};

}  // namespace awd
