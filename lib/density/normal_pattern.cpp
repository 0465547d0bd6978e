// SPDX-License-Identifier: Apache-2.0
#include "density/normal_pattern.h"

#include <algorithm>

#include "density/tensor.h"

namespace awd {

namespace {

template <class Pair>
bool before(const Pair& one, const Pair& other) {
  return one.j != other.j ? one.j < other.j : one.k < other.k;
}

template <class Pair>
bool same(const Pair& one, const Pair& other) {
  return one.j == other.j && one.k == other.k;
}

}  // namespace

void NormalPattern::findPairs(const BasisLevel& level, bool first, std::pmr::vector<Pair>& pairs) {
  const uint32_t rows = level.alive;
  for (uint32_t cell = 0; cell < level.cells; ++cell) {
    const uint32_t* functions = &level.functions[std::size_t{cell} * rows];
    for (uint32_t r = 0; r < rows; ++r) {
      for (uint32_t s = 0; s < rows; ++s) {
        if (!first || functions[r] <= functions[s]) pairs.push_back({functions[r], functions[s]});
      }
    }
  }
  std::sort(pairs.begin(), pairs.end(), before<Pair>);
  pairs.erase(std::unique(pairs.begin(), pairs.end(), same<Pair>), pairs.end());
}

uint64_t NormalPattern::pairsOf(const BasisLevel& level, bool first) {
  std::pmr::vector<Pair> pairs(level.functions.get_allocator());
  findPairs(level, first, pairs);
  return pairs.size();
}

NormalPattern::NormalPattern(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                             uint32_t dimensions)
    : shape_(shapeOf(levels, dimensions)), axes_(memory) {
  std::copy(levels, levels + dimensions, levels_);
  axes_.reserve(dimensions);
  for (uint32_t a = 0; a < dimensions; ++a) {
    const BasisLevel& level = *levels[a];
    Axis& axis = axes_.emplace_back(memory);
    findPairs(level, a == 0, axis.pairs);
    size_ *= axis.pairs.size();
    const std::size_t rows = level.alive;
    axis.alive.assign(level.cells * rows * rows, kNone);
    for (std::size_t i = 0; i < axis.alive.size(); ++i) {
      const uint32_t* functions = &level.functions[i / (rows * rows) * rows];
      const Pair pair = {functions[i / rows % rows], functions[i % rows]};
      const auto found = std::lower_bound(axis.pairs.begin(), axis.pairs.end(), pair, before<Pair>);
      if (found == axis.pairs.end() || !same(*found, pair)) continue;
      axis.alive[i] = static_cast<uint32_t>(found - axis.pairs.begin());
    }
  }
}

Ref<NormalPattern> NormalPattern::make(std::pmr::memory_resource* memory,
                                       const BasisLevel* const* levels, uint32_t dimensions) {
  return Ref<NormalPattern>::adopt(awd::make<NormalPattern>(memory, memory, levels, dimensions));
}

void NormalPattern::destroy() noexcept { unmake(axes_.get_allocator().resource(), this); }

std::size_t NormalPattern::bytes() const {
  std::size_t bytes = sizeof *this + axes_.capacity() * sizeof(Axis);
  for (const Axis& axis : axes_) {
    bytes += axis.pairs.capacity() * sizeof(Pair) + axis.alive.capacity() * sizeof(uint32_t);
  }
  return bytes;
}

}  // namespace awd
