// SPDX-License-Identifier: Apache-2.0
// The basis of each axis of a density, compiled: what all its forks and passes share.
#pragma once

#include <memory_resource>
#include <optional>
#include <vector>

#include "basis/family.h"
#include "density/gram.h"
#include "density/shape.h"
#include "density/wavelet.h"
#include "util/context.h"

namespace awd {

/// The levels of all axes.
using Levels = std::array<uint32_t, kMaxDimensions>;

/// A family with what is derived from its tables.
struct CompiledFamily {
  CompiledFamily(std::pmr::memory_resource* memory, const AWDBasisFamily& table, uint32_t maxLevel);

  Family family;
  uint32_t flags;
  std::pmr::vector<GramSolver> grams;   ///< one a level, from the family's first
  std::optional<WaveletFilter> filter;  ///< of nested families

  const GramSolver& gram(uint32_t level) const { return grams[level - family.minLevel()]; }
};

class DensityBases final : public RefCounted {
 public:
  struct Axis {
    const AWDBasisFamily* table;
    uint32_t maxLevel;  ///< of the tables
  };
  static Ref<DensityBases> make(std::pmr::memory_resource* memory, const Axis* axes,
                                uint32_t dimensions);
  DensityBases(std::pmr::memory_resource* memory, const Axis* axes, uint32_t dimensions);

  std::pmr::memory_resource* memory() const { return memory_; }
  uint32_t dimensions() const { return dimensions_; }
  const CompiledFamily& axis(uint32_t axis) const { return *axes_[axis]; }
  const Family& family(uint32_t axis) const { return axes_[axis]->family; }
  bool nested() const;
  /// Whether all functions are piecewise constant.
  bool constant() const;

  /// Fills `out` with the tables of these levels.
  void tables(const Levels& levels, const BasisLevel** out) const;
  Shape shape(const Levels& levels) const;

 private:
  void destroy() noexcept override;

  std::pmr::memory_resource* memory_;
  uint32_t dimensions_;
  std::pmr::vector<Owned<CompiledFamily>> families_;  ///< each once
  const CompiledFamily* axes_[kMaxDimensions] = {};
};

}  // namespace awd
