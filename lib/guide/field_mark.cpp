// SPDX-License-Identifier: Apache-2.0
// What was recorded before a mark is kept apart from what came after, which can be dropped.
#include "guide/field.h"

namespace awd {

void Field::mark() {
  std::pmr::memory_resource* memory = context_->memory();
  std::pmr::vector<std::pair<Patch*, Owned<PatchStatistics>>> fresh(memory);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (patch.marked || patch.statistics->isEmpty()) return;
    fresh.emplace_back(
        &patch, learning_.freshStatistics(density(patch.known).level(), patch.statistics->units()));
  });
  // Nothing below can fail.
  table_.forEach([&](uint32_t, Patch& patch) {
    if (!patch.marked) return;
    patch.marked->add(*patch.statistics);
    patch.statistics->clear();
  });
  for (auto& [patch, statistics] : fresh) {
    patch->marked = std::move(patch->statistics);
    patch->statistics = std::move(statistics);
  }
  renewViews();
}

void Field::revert() {
  table_.forEach([](uint32_t, Patch& patch) { patch.statistics->clear(); });
  // One that was made since would begin its next pass with what its leaf's origin knew now.
  removeUnseen();
  renewViews();
}

void Field::removeUnseen() {
  table_.removeIf([](const Patch& patch) { return !patch.hasBeenSeen(); });
}

}  // namespace awd
