// SPDX-License-Identifier: Apache-2.0
// What several processes record at once, combined by numbers that are added up or of which the
// largest is taken, such as MPI_Allreduce does. They are laid out over the patches of the densities
// that all of them have: patches first touched in this pass differ from one to the other.
#include <algorithm>

#include "guide/exchange_visitors.h"
#include "guide/field.h"
#include "util/digest.h"
#include "util/error.h"

namespace awd {

namespace {

/// What all who take part must agree in. The largest of a digest and the largest of its complement
/// are both one's own only if all are the same.
constexpr std::size_t kDigests = 4;
constexpr const char* kWhat[kDigests] = {"settings", "where patches lie",
                                         "what patches have learned",
                                         "the scale of values (awdSetFieldScale)"};
/// Before the patches: how many take part; the digests.
constexpr std::size_t kHeadSums = 1;
constexpr std::size_t kHeadMaxima = 2 * kDigests;

// These name all members: with one more they don't compile until that is told apart too.

uint64_t digestOf(const FieldSettings& settings, const Family& family) {
  const auto& [preset, map, startLevel, maxLevel, learning, alpha, patches, lower, upper,
               patchSamples, maxBytes, target, lights] = settings;
  Digest digest;
  digest.add(std::string_view(family.name()));
  for (const int32_t choice : {preset, map, learning.estimator, patches, target}) {
    digest.add(choice);
  }
  for (const uint32_t number : {startLevel, maxLevel, patchSamples}) digest.add(number);
  for (const double x : {learning.tau, learning.shrinkage, learning.refitShrinkage, alpha}) {
    digest.add(x);
  }
  const AWDRefitSolver* solver = learning.refitter.solver;
  digest.add(std::string_view(solver ? solver->name : ""));
  digest.add(learning.maxCoefficients);
  digest.add(lower);
  digest.add(upper);
  digest.add(maxBytes);
  for (uint32_t i = 0; lights && i < lights->lights(); ++i) digest.add(lights->chance(i));
  return digest.value();
}

void add(Digest& digest, const PatchKnowledge& known) {
  const auto& [density, weight, mean, alpha, eighths, root, lights, lightShare] = known;
  if (density) {
    digest.add(density->level().level);
    for (const double c : density->coefficients()) digest.add(c);
  }
  for (const double x : {weight, mean, alpha, root, lightShare}) digest.add(x);
  for (const uint64_t count : eighths) digest.add(count);
  for (uint32_t i = 0; lights && i < lights->lights(); ++i) digest.add(lights->chance(i));
}

}  // namespace

struct Field::Layout {
  std::pmr::vector<uint32_t> keys;
  /// Of a patch on each level that is in use: for its sizes, and to walk through numbers with.
  std::pmr::vector<Owned<PatchStatistics>> examples;
  std::size_t sums = kHeadSums, maxima = kHeadMaxima;

  bool has(uint32_t key) const { return std::binary_search(keys.begin(), keys.end(), key); }
  /// Calls visit(key, statistics of its level, its sums, its maxima) for all patches.
  template <class Number, class Visit>
  void forEach(const Field& field, Number* s, Number* m, Visit&& visit) const {
    s += kHeadSums;
    m += kHeadMaxima;
    for (const uint32_t key : keys) {
      PatchStatistics& example = exampleOf(field, key);
      ExchangeCounter size;
      example.visit(size);
      visit(key, example, s, m);
      s += size.sums;
      m += size.maxima;
    }
  }
  PatchStatistics& exampleOf(const Field& field, uint32_t key) const {
    const Patch* patch = field.nearest(key);
    const BasisLevel& level = (patch ? field.density(patch->known) : *field.start_).level();
    return *examples[level.level - field.settings_.startLevel];
  }
};

Field::Layout Field::layOut(const Exchanged& exchanged) const {
  std::pmr::memory_resource* memory = context_->memory();
  Layout layout = {std::pmr::vector<uint32_t>(memory),
                   std::pmr::vector<Owned<PatchStatistics>>(memory)};
  if (tree_) {
    for (uint32_t leaf = 0; leaf < tree_->leaves(); ++leaf) layout.keys.push_back(leaf);
  } else {
    layout.keys.assign(exchanged.patches, exchanged.patches + exchanged.count);
  }
  for (uint32_t l = settings_.startLevel; l <= settings_.maxLevel; ++l) {
    layout.examples.push_back(learning_.freshStatistics(family().level(l), units_));
  }
  for (const uint32_t key : layout.keys) {
    ExchangeCounter size;
    layout.exampleOf(*this, key).visit(size);
    layout.sums += size.sums;
    layout.maxima += size.maxima;
  }
  return layout;
}

std::array<uint64_t, kDigests> Field::digests(const Layout& layout) const {
  Digest places, knowledge, units;
  units.add(units_.values);
  units.add(units_.lights);
  for (const uint32_t key : layout.keys) {
    places.add(tree_ ? tree_->origin(key) : key);
    if (tree_) places.add(tree_->side(key));
    const Patch* patch = table_.find(key);
    knowledge.add(patch && patch->seen);
    if (patch && patch->seen) add(knowledge, patch->known);
    units.add(unitsOf(key).values);
    units.add(unitsOf(key).lights);
  }
  return {digestOf(settings_, family()), places.value(), knowledge.value(), units.value()};
}

Field::ExchangeSize Field::exchangeSize(const Exchanged& exchanged) const {
  const Layout layout = layOut(exchanged);
  return {layout.sums, layout.maxima};
}

void Field::exportRecords(const Exchanged& exchanged, uint64_t* sums, uint64_t* maxima) const {
  const Layout layout = layOut(exchanged);
  table_.forEach([&](uint32_t key, const Patch& patch) {
    if (patch.statistics->isEmpty() || layout.has(key)) return;
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "patches lacks patch %u, which has records: give all in which any process may record",
         numberOf(key));
  });
  sums[0] = 1;
  const auto own = digests(layout);
  for (std::size_t i = 0; i < kDigests; ++i) {
    maxima[2 * i] = own[i];
    maxima[2 * i + 1] = ~own[i];
  }
  layout.forEach(*this, sums, maxima,
                 [&](uint32_t key, PatchStatistics& example, auto* s, auto* m) {
                   Patch* patch = table_.find(key);
                   ExchangeWriter writer = {s, m};
                   (patch ? *patch->statistics : example).visit(writer);
                 });
}

void Field::importRecords(const Exchanged& exchanged, const uint64_t* sums,
                          const uint64_t* maxima) {
  const Layout layout = layOut(exchanged);
  const auto own = digests(layout);
  for (std::size_t i = 0; i < kDigests; ++i) {
    if (maxima[2 * i] == own[i] && maxima[2 * i + 1] == ~own[i]) continue;
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "numbers come from fields that differ from this one in %s: all must come from the same "
         "saved field, or have been adapted to the same records",
         kWhat[i]);
  }
  if (sums[0] == 0) fail(AWD_ERROR_INVALID_ARGUMENT, "numbers come from no field at all");

  // All that can fail comes first.
  std::pmr::vector<Newcomer> newcomers(context_->memory());
  layout.forEach(*this, sums, maxima,
                 [&](uint32_t key, PatchStatistics& example, const uint64_t* s, const uint64_t* m) {
                   ExchangeChecker checker = {s, m};
                   example.visit(checker);
                   if (!checker.good) {
                     fail(AWD_ERROR_INVALID_ARGUMENT,
                          "numbers of patch %u make no sense: the first are to be added up, of "
                          "the others the largest is to be taken",
                          numberOf(key));
                   }
                   const bool any = std::any_of(s, checker.sums, [](uint64_t n) { return n != 0; });
                   if (!any || table_.find(key)) return;
                   Owned<Patch> made(newPatch(key), {context_->memory()});
                   ExchangeReader reader = {s, m};
                   made->statistics->visit(reader);
                   newcomers.push_back({key, std::move(made)});
                 });
  for (const Newcomer& newcomer : newcomers) table_.reserve(newcomer.key);

  layout.forEach(*this, sums, maxima,
                 [&](uint32_t key, PatchStatistics&, const uint64_t* s, const uint64_t* m) {
                   Patch* patch = table_.find(key);
                   if (!patch) return;
                   ExchangeReader reader = {s, m};
                   patch->statistics->visit(reader);
                 });
  for (Newcomer& newcomer : newcomers) {
    table_.touch(newcomer.key, [&] { return newcomer.patch.release(); });
  }
  removeUnseen();
  renewViews();
}

}  // namespace awd
