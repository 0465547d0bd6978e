// SPDX-License-Identifier: Apache-2.0
// Adding up what several fields of the same densities have recorded.
#include <algorithm>

#include "guide/field.h"
#include "util/error.h"

namespace awd {

namespace {

[[noreturn]] void differs(const char* what) {
  fail(
      AWD_ERROR_INVALID_ARGUMENT,
      "other differs from field in %s: both must come from the same saved field, and not have been "
      "adapted since",
      what);
}

void checkTrees(const SpatialTree& a, const SpatialTree& b) {
  bool same = a.leaves() == b.leaves();
  for (uint32_t leaf = 0; same && leaf < a.leaves(); ++leaf) {
    same = a.origin(leaf) == b.origin(leaf) && a.side(leaf) == b.side(leaf);
  }
  if (!same) differs("where its patches lie");
}

bool sameKnowledge(const PatchKnowledge& a, const PatchKnowledge& b) {
  const bool sameLights =
      a.lights && b.lights ? *a.lights == *b.lights : a.lights.get() == b.lights.get();
  return a.weight == b.weight && a.mean == b.mean && a.alpha == b.alpha && a.eighths == b.eighths &&
         a.root == b.root && sameLights && a.lightShare == b.lightShare;
}

bool sameDensity(const SquareDensity& a, const SquareDensity& b) {
  return &a == &b || (a.level().level == b.level().level && a.coefficients() == b.coefficients());
}

}  // namespace

void Field::checkMerge(const Field& other, uint32_t key) const {
  const auto densityOf = [key](const Field& field) -> const SquareDensity& {
    const Patch* nearest = field.nearest(key);
    return nearest ? field.density(nearest->known) : *field.start_;
  };
  const Patch* ours = table_.find(key);
  const Patch* theirs = other.table_.find(key);
  // One that only one of them has touched was made just now, and knows nothing of its own.
  const Patch* either = ours ? ours : theirs;
  const bool same = ours && theirs ? sameKnowledge(ours->known, theirs->known)
                                   : either->known.weight == 0.0 && !either->seen;
  if (!same || !sameDensity(densityOf(*this), densityOf(other))) {
    fail(
        AWD_ERROR_INVALID_ARGUMENT,
        "other differs from field in what patch %u has learned: both must come from the same saved "
        "field, and not have been adapted since",
        numberOf(key));
  }
  if (!(unitsOf(key) == other.unitsOf(key))) {
    differs("the scale of its values (awdSetFieldScale)");
  }
}

void Field::checkMerge(const Field& other) const {
  if (&other == this) fail(AWD_ERROR_INVALID_ARGUMENT, "other is field itself");
  if (const char* what = differenceTo(other)) differs(what);
  if (settings_.maxBytes != other.settings_.maxBytes) differs("maxBytes");
  if (!(units_ == other.units_)) differs("the scale of its values (awdSetFieldScale)");
  if (tree_) checkTrees(*tree_, *other.tree_);
  table_.forEach([&](uint32_t key, const Patch&) { checkMerge(other, key); });
  other.table_.forEach([&](uint32_t key, const Patch&) { checkMerge(other, key); });
}

const char* Field::differenceTo(const Field& other) const {
  if (family().name() != other.family().name()) return "its basis";
  return differenceOf(settings_, other.settings_);
}

void Field::merge(const Field& other) {
  checkMerge(other);
  // What needs memory first: the sums are then added without a failure.
  other.table_.forEach([&](uint32_t key, const Patch&) { touch(key); });
  other.table_.forEach([&](uint32_t key, const Patch& patch) {
    PatchStatistics& sums = *table_.find(key)->statistics;
    sums.add(*patch.statistics);
    if (patch.marked) sums.add(*patch.marked);
  });
}

}  // namespace awd
