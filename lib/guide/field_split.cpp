// SPDX-License-Identifier: Apache-2.0
// Patches of many samples become two, four or eight, each with what the whole knew.
#include <algorithm>
#include <cmath>

#include "guide/field.h"

namespace awd {

double Field::patchSamples(uint32_t leaves) const {
  // From here on patches grow as well as their number, each by the square root of the samples'
  // growth or so: beyond the caches of a processor more of them cost more than they bring.
  constexpr double kManyLeaves = 512.0;
  return settings_.patchSamples * std::sqrt(std::max(1.0, leaves / kManyLeaves));
}

std::pmr::vector<Field::Newcomer> Field::splitAll(SpatialTree& tree,
                                                  std::pmr::vector<Successor>& successors,
                                                  uint64_t& capped) const {
  std::pmr::memory_resource* memory = context_->memory();
  std::pmr::vector<Newcomer> newcomers(memory);
  std::pmr::vector<Part> parts(memory);
  const double mostSamples = patchSamples(tree.leaves());
  // Without the table, whose nodes also tell of passes that were given up.
  uint64_t bytes = statistics().bytes - table_.bytes();
  for (const Successor& next : successors) {
    bytes += next.statistics->bytes() + memoryOf(next.known);
    bytes -= next.patch->bytes() - sizeof(Patch) + memoryOf(next.patch->known);
  }
  for (Successor& next : successors) {
    const uint64_t each = sizeof(Patch) + next.statistics->bytes() + memoryOf(next.known);
    const PatchKnowledge whole = next.known;
    // As doubles: bytes and numbers from elsewhere may have counts whose sum has no integer.
    const auto countOf = [&](uint32_t first, uint32_t eighths) {
      double sum = 0.0;
      for (uint32_t i = first; i < first + eighths; ++i) {
        sum += static_cast<double>(whole.eighths[i]);
      }
      return sum;
    };
    const auto settle = [&](const Part& part) {
      // Counts begin anew in a leaf that is a part of the former one: its eighths are smaller.
      if (part.eighths < SpatialTree::kEighths) part.known->eighths = {};
      part.known->weight = part.weight;
      part.known->lightShare =
          whole.weight > 0.0 ? whole.lightShare * (part.weight / whole.weight) : whole.lightShare;
    };
    parts.push_back({next.key, &next.known, 0, SpatialTree::kEighths,
                     countOf(0, SpatialTree::kEighths), whole.weight});
    while (!parts.empty()) {
      Part part = parts.back();
      parts.pop_back();
      // None are counted where shadow rays alone fell since counts began anew.
      const bool large = part.weight > mostSamples && part.eighths > 1 && part.samples > 0.0;
      if (!large || !tree.canSplit(part.leaf)) {
        settle(part);
        continue;
      }
      const uint32_t half = part.eighths / 2;
      const double counts[] = {countOf(part.firstEighth, half),
                               countOf(part.firstEighth + half, half)};
      if (counts[0] > 0.0 && counts[1] > 0.0) {
        if (bytes + each > settings_.maxBytes) {
          ++capped;
          settle(part);
          continue;
        }
        bytes += each;
      }
      const uint32_t keeper = counts[0] > 0.0 ? 0 : 1;
      const uint32_t other = tree.split(part.leaf, keeper);
      const auto share = [&](uint32_t side) {
        return part.weight * (counts[side] / part.samples);  // no more than the whole by rounding
      };
      parts.push_back({part.leaf, part.known, part.firstEighth + keeper * half, half,
                       counts[keeper], share(keeper)});
      if (!(counts[1 - keeper] > 0.0)) continue;
      Owned<Patch> made = makeOwned<Patch>(
          memory, memory,
          learning_.freshStatistics(density(whole).level(), next.statistics->units()));
      made->known = whole;
      made->seen = true;
      made->learned = next.samples;
      parts.push_back({other, &made->known, part.firstEighth + (1 - keeper) * half, half,
                       counts[1 - keeper], share(1 - keeper)});
      newcomers.push_back({other, std::move(made)});
    }
  }
  return newcomers;
}

}  // namespace awd
