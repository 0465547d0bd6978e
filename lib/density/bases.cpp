// SPDX-License-Identifier: Apache-2.0
#include "density/bases.h"

#include <algorithm>

namespace awd {

CompiledFamily::CompiledFamily(std::pmr::memory_resource* memory, const AWDBasisFamily& table,
                               uint32_t maxLevel)
    : family(memory, table, maxLevel), flags(table.flags), grams(memory) {
  for (uint32_t l = family.minLevel(); l <= family.maxLevel(); ++l) {
    grams.emplace_back(memory, family.level(l));
  }
  if (flags & AWD_BASIS_NESTED) filter.emplace(memory, family);
}

Ref<DensityBases> DensityBases::make(std::pmr::memory_resource* memory, const Axis* axes,
                                     uint32_t dimensions) {
  return Ref<DensityBases>::adopt(awd::make<DensityBases>(memory, memory, axes, dimensions));
}

DensityBases::DensityBases(std::pmr::memory_resource* memory, const Axis* axes, uint32_t dimensions)
    : memory_(memory), dimensions_(dimensions), families_(memory) {
  for (uint32_t a = 0; a < dimensions; ++a) {
    // Axes of one family share its tables, up to the highest level that any of them wants.
    uint32_t maxLevel = 0;
    for (uint32_t b = 0; b < dimensions; ++b) {
      if (axes[b].table == axes[a].table) maxLevel = std::max(maxLevel, axes[b].maxLevel);
    }
    for (uint32_t b = 0; b < a && !axes_[a]; ++b) {
      if (axes[b].table == axes[a].table) axes_[a] = axes_[b];
    }
    if (axes_[a]) continue;
    families_.push_back(makeOwned<CompiledFamily>(memory, memory, *axes[a].table, maxLevel));
    axes_[a] = families_.back().get();
  }
}

void DensityBases::destroy() noexcept { unmake(memory_, this); }

bool DensityBases::nested() const {
  return std::all_of(axes_, axes_ + dimensions_,
                     [](const CompiledFamily* axis) { return axis->filter.has_value(); });
}

bool DensityBases::constant() const {
  return std::all_of(axes_, axes_ + dimensions_, [](const CompiledFamily* axis) {
    return axis->family.level(axis->family.minLevel()).order == 1;
  });
}

void DensityBases::tables(const Levels& levels, const BasisLevel** out) const {
  for (uint32_t a = 0; a < dimensions_; ++a) out[a] = &family(a).level(levels[a]);
}

Shape DensityBases::shape(const Levels& levels) const {
  Shape shape;
  shape.dimensions = dimensions_;
  for (uint32_t a = 0; a < dimensions_; ++a) shape.count[a] = family(a).level(levels[a]).count;
  return shape;
}

}  // namespace awd
