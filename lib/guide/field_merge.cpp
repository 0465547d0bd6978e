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

void checkSettings(const FieldSettings& a, const FieldSettings& b) {
  const auto check = [](bool same, const char* what) {
    if (!same) differs(what);
  };
  const LearningSettings& ours = a.learning;
  const LearningSettings& theirs = b.learning;
  check(a.preset == b.preset, "its preset");
  check(a.map == b.map, "its map");
  check(a.startLevel == b.startLevel && a.maxLevel == b.maxLevel, "its levels");
  check(ours.estimator == theirs.estimator, "its estimator");
  check(ours.tau == theirs.tau, "tau");
  check(ours.shrinkage == theirs.shrinkage && ours.refitShrinkage == theirs.refitShrinkage,
        "shrinkage");
  check(ours.refitter.solver == theirs.refitter.solver, "refitSolver");
  check(a.target == b.target, "target");
  check(a.alpha == b.alpha, "alpha");
  check(a.patches == b.patches && a.patchSamples == b.patchSamples, "the kind of its patches");
  check(a.lower == b.lower && a.upper == b.upper, "its box");
  check(a.maxBytes == b.maxBytes, "maxBytes");
  const uint32_t lights = a.lights ? a.lights->lights() : 0;
  check(lights == (b.lights ? b.lights->lights() : 0), "lightCount");
  check(lights == 0 || *a.lights == *b.lights, "lightPowers");
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
  const auto unitOf = [key](const Field& field) {
    const Patch* nearest = field.nearest(key);
    return nearest ? nearest->statistics->units() : field.units_;
  };
  if (!(unitOf(*this) == unitOf(other))) {
    differs("the scale of its values (awdSetFieldScale)");
  }
}

void Field::checkMerge(const Field& other) const {
  if (&other == this) fail(AWD_ERROR_INVALID_ARGUMENT, "other is field itself");
  if (family().name() != other.family().name()) differs("its basis");
  checkSettings(settings_, other.settings_);
  if (!(units_ == other.units_)) differs("the scale of its values (awdSetFieldScale)");
  if (tree_) checkTrees(*tree_, *other.tree_);
  table_.forEach([&](uint32_t key, const Patch&) { checkMerge(other, key); });
  other.table_.forEach([&](uint32_t key, const Patch&) { checkMerge(other, key); });
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
