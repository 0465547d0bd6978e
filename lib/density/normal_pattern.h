// SPDX-License-Identifier: Apache-2.0
// Which entries of A_jk = sum_i N_j(x_i) N_k(x_i) / p_i can differ from 0: those of pairs of
// functions of a tensor product that share a cell, a band about the diagonal on every axis. The
// matrix is symmetric; of pairs whose functions differ on axis 0 only one order is kept.
#pragma once

#include <memory_resource>
#include <vector>

#include "density/point.h"
#include "util/context.h"

namespace awd {

class NormalPattern final : public RefCounted {
 public:
  static Ref<NormalPattern> make(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                                 uint32_t dimensions);
  NormalPattern(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                uint32_t dimensions);

  /// Entries kept.
  std::size_t size() const { return size_; }
  /// The same of a level on axis 0 or another, to be multiplied, without making anything.
  static uint64_t pairsOf(const BasisLevel& level, bool first);
  const Shape& shape() const { return shape_; }
  /// Whether it is that of these levels.
  bool isOf(const BasisLevel* const* levels) const {
    return std::equal(levels, levels + shape_.dimensions, levels_);
  }

  /// Calls visit(entry, N_j N_k), or visit(entry, N_j N_k, j == k), for every pair kept of
  /// functions alive at a point.
  template <uint32_t D, class Visit>
  void forEachAlive(const double* x, const AxisValues* at, Visit&& visit) const {
    uint32_t cells[D];
    for (uint32_t a = 0; a < D; ++a) cells[a] = cellOf(*levels_[a], x[a]);
    visitAlive<D, 0>(cells, at, visit, 0, 1.0, true);
  }

  /// Calls visit(entry, j, k) for every pair kept; `both`: (k, j) has no entry of its own.
  template <class Visit>
  void forEachPair(Visit&& visit) const {
    visitPairs(visit, 0, 0, 0, 0, false);
  }

  std::size_t bytes() const;

 private:
  void destroy() noexcept override;

  static constexpr uint32_t kNone = 0xffffffffu;
  struct Pair {
    uint32_t j, k;
  };
  struct Axis {
    explicit Axis(std::pmr::memory_resource* memory) : pairs(memory), alive(memory) {}
    std::pmr::vector<Pair> pairs;
    /// The pair of rows r and s of a cell: alive[(cell * rows + r) * rows + s].
    std::pmr::vector<uint32_t> alive;
  };
  static void findPairs(const BasisLevel& level, bool first, std::pmr::vector<Pair>& pairs);

  template <uint32_t D, uint32_t A, class Visit>
  void visitAlive(const uint32_t* cells, const AxisValues* at, Visit& visit, std::size_t before,
                  double product, bool diagonal) const {
    const Axis& axis = axes_[A];
    const uint32_t rows = at[A].count;
    const uint32_t* pair = &axis.alive[std::size_t{cells[A]} * rows * rows];
    for (uint32_t r = 0; r < rows; ++r) {
      for (uint32_t s = 0; s < rows; ++s, ++pair) {
        const double value = product * (at[A].value[r] * at[A].value[s]);
        if (*pair == kNone || !(value > 0.0)) continue;
        const std::size_t entry = before * axis.pairs.size() + *pair;
        if constexpr (A + 1 < D) {
          visitAlive<D, A + 1>(cells, at, visit, entry, value, diagonal && r == s);
        } else if constexpr (std::is_invocable_v<Visit&, std::size_t, double, bool>) {
          visit(entry, value, diagonal && r == s);
        } else {
          visit(entry, value);
        }
      }
    }
  }

  template <class Visit>
  void visitPairs(Visit& visit, uint32_t a, std::size_t before, std::size_t j, std::size_t k,
                  bool both) const {
    const Axis& axis = axes_[a];
    for (std::size_t i = 0; i < axis.pairs.size(); ++i) {
      const Pair& pair = axis.pairs[i];
      const std::size_t entry = before * axis.pairs.size() + i;
      const std::size_t row = j * shape_.count[a] + pair.j;
      const std::size_t column = k * shape_.count[a] + pair.k;
      const bool unpaired = both || (a == 0 && pair.j != pair.k);
      if (a + 1 == shape_.dimensions) {
        visit(entry, row, column, unpaired);
      } else {
        visitPairs(visit, a + 1, entry, row, column, unpaired);
      }
    }
  }

  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  std::pmr::vector<Axis> axes_;
  std::size_t size_ = 1;
};

}  // namespace awd
