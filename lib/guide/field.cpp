// SPDX-License-Identifier: Apache-2.0
#include "guide/field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "density/projection.h"
#include "util/error.h"

namespace awd {

namespace {

// The paper's settings, and ours where they differ.
constexpr uint32_t kStartLevel = 2;
constexpr uint32_t kPaperMaxLevel = 4;
constexpr uint32_t kDefaultMaxLevel = 3;
/// A density of a level has some 4^level coefficients: beyond this one they don't fit anywhere.
constexpr uint32_t kFinestLevel = 12;
constexpr double kPaperTau = 0.05;
/// High, since one density serves a whole piece of surface, whose places see different light. With
/// the concentric-cosine map the floor is a share of cosine sampling.
constexpr double kDefaultTau = 0.3;
/// By default a patch is refined only when the finer level would have had this many samples a
/// coefficient: below that its noise costs more than its detail brings.
constexpr uint64_t kSamplesPerCoefficient = 8;

uint32_t settleLevel(uint32_t asked, const char* name, uint32_t preset,
                     const AWDBasisFamily& family) {
  const uint32_t finest = std::min(family.maxLevel, std::max(family.minLevel, kFinestLevel));
  if (asked == 0) return std::clamp(preset, family.minLevel, finest);
  const uint32_t level = asked - 1;
  if (level < family.minLevel || level > finest) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "%s is level %u: fields with basis \"%s\" have levels %u to %u", name, level, family.name,
         family.minLevel, finest);
  }
  return level;
}

/// A magnitude to set the next pass's unit by: the mean, unless single values tower above it.
double magnitudeOf(const SquareStatistics& statistics) {
  double sum = 0.0;
  for (std::size_t i = 0; i < statistics.components(); ++i) sum += statistics.sum(i);
  const double mean = sum / static_cast<double>(std::max<uint64_t>(1, statistics.samples()));
  return std::max(mean, statistics.largest() * 0x1p-19);
}

}  // namespace

FieldSettings settle(const AWDFieldDesc& desc, const AWDBasisFamily& family) {
  if (desc.preset != AWD_PRESET_DEFAULT && desc.preset != AWD_PRESET_PAPER) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->preset is %d: not an AWD_PRESET_...", desc.preset);
  }
  if (desc.map < AWD_MAP_DEFAULT || desc.map > AWD_MAP_CONCENTRIC_COSINE) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->map is %d: not an AWD_MAP_...", desc.map);
  }
  if (!(desc.tau <= 1.0)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->tau is %g: at most 1 is allowed", desc.tau);
  }
  const bool paper = desc.preset == AWD_PRESET_PAPER;
  FieldSettings settings;
  settings.preset = desc.preset;
  settings.map = desc.map != AWD_MAP_DEFAULT ? desc.map
                 : paper                     ? AWD_MAP_SPHERICAL
                                             : AWD_MAP_CONCENTRIC_COSINE;
  settings.maxLevel = settleLevel(desc.maxLevel, "desc->maxLevel",
                                  paper ? kPaperMaxLevel : kDefaultMaxLevel, family);
  settings.startLevel = settleLevel(desc.startLevel, "desc->startLevel", kStartLevel, family);
  if (settings.startLevel > settings.maxLevel) {
    // An explicit bound at one end moves the preset's value at the other.
    if (desc.startLevel && desc.maxLevel) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "desc->startLevel is level %u, above desc->maxLevel, %u",
           settings.startLevel, settings.maxLevel);
    }
    (desc.startLevel ? settings.maxLevel : settings.startLevel) =
        desc.startLevel ? settings.startLevel : settings.maxLevel;
  }
  settings.tau = desc.tau != 0.0 ? desc.tau : paper ? kPaperTau : kDefaultTau;
  return settings;
}

Ref<Field> Field::make(Ref<Context> context, const AWDBasisFamily& family,
                       const FieldSettings& settings) {
  std::pmr::memory_resource* memory = context->memory();
  return Ref<Field>::adopt(awd::make<Field>(memory, std::move(context), family, settings));
}

Field::Field(Ref<Context> context, const AWDBasisFamily& family, const FieldSettings& settings)
    : context_(std::move(context)),
      settings_(settings),
      family_(context_->memory(), family, settings.maxLevel),
      grams_(context_->memory()),
      start_(context_->memory(), family_.level(settings.startLevel)),
      unitExponent_(SquareStatistics::unitExponentFor(1.0)),
      lastPass_(),
      table_(context_->memory()) {
  for (uint32_t l = family_.minLevel(); l <= family_.maxLevel(); ++l) {
    grams_.emplace_back(context_->memory(), family_.level(l));
  }
}

void Field::destroy() noexcept {
  const Ref<Context> context = context_;  // the memory outlives the field
  unmake(context->memory(), this);
}

const SquareDensity& Field::density(uint32_t patch) const {
  const Patch* known = table_.find(patch);
  return known ? density(*known) : start_;
}

AWDDirectionSample Field::sample(uint32_t patch, Vec3f normal, const double uniforms[3]) const {
  const SquareSample point = density(patch).sample(uniforms);
  const MappedDirection mapped = mapToHemisphere(settings_.map, point.u, point.v);
  const Vec3f direction = Frame(normal).toWorld(mapped.direction);
  return {{direction.x, direction.y, direction.z},
          static_cast<float>(point.pdf / mapped.solidAngle),
          {point.u, point.v},
          point.component,
          mapped.solidAngle};
}

float Field::pdf(uint32_t patch, Vec3f normal, Vec3f direction) const {
  const Vec3f local = Frame(normal).toLocal(direction);
  if (!(local.z > 0.0f)) return 0.0f;
  float u, v;
  mapToSquare(settings_.map, local, u, v);
  return static_cast<float>(density(patch).pdf(u, v) / solidAngleAt(settings_.map, local));
}

Patch& Field::touch(uint32_t patch) {
  return table_.touch(patch, [this] {
    std::pmr::memory_resource* memory = context_->memory();
    return awd::make<Patch>(memory, memory, start_.coefficients().size(), unitExponent_);
  });
}

void Field::record(uint32_t patch, const AWDDirectionSample& sample, double value) {
  Patch& known = touch(patch);
  if (sample.component >= known.statistics->components()) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "sample->component is %u: patch %u has %zu components; was the sample drawn from it since "
         "the last adapt?",
         sample.component, patch, known.statistics->components());
  }
  // The density lives on the square: f there is f in solid angle times d omega / d(u,v).
  known.statistics->record(sample.component, value * static_cast<double>(sample.solidAngle));
}

void Field::setScale(double magnitude) {
  unitExponent_ = SquareStatistics::unitExponentFor(magnitude);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (!patch.hasBeenSeen()) {
      patch.statistics = makeOwned<SquareStatistics>(context_->memory(), context_->memory(),
                                                     patch.statistics->components(), unitExponent_);
    }
  });
}

bool Field::finerIsDue(uint32_t level, uint64_t samples) const {
  if (level >= settings_.maxLevel) return false;
  if (settings_.preset == AWD_PRESET_PAPER) return true;
  const uint64_t n = family_.level(level + 1).count;
  return samples >= kSamplesPerCoefficient * n * n;
}

Owned<SquareDensity> Field::learn(const SquareStatistics& statistics,
                                  const BasisLevel& level) const {
  std::pmr::memory_resource* memory = context_->memory();
  Owned<SquareDensity> none(nullptr, {memory});
  if (statistics.overflowed()) return none;

  std::pmr::vector<double> c =
      project(memory, level, grams_[level.level - family_.minLevel()], statistics);
  if (!clampCoefficients(level, settings_.tau, c)) return none;
  if (!finerIsDue(level.level, statistics.samples())) {
    return makeOwned<SquareDensity>(memory, level, std::move(c));
  }
  const BasisLevel& fine = family_.level(level.level + 1);
  return makeOwned<SquareDensity>(memory, fine, refine(memory, level, fine, c));
}

Field::Successor Field::succeed(Patch& patch) const {
  std::pmr::memory_resource* memory = context_->memory();
  const SquareStatistics* statistics = patch.statistics.get();
  Owned<SquareStatistics> whole(nullptr, {memory});
  if (patch.marked) {
    whole = makeOwned<SquareStatistics>(memory, memory, statistics->components(),
                                        statistics->unitExponent());
    whole->add(*patch.marked);
    whole->add(*statistics);
    statistics = whole.get();
  }
  Successor next = {&patch,
                    learn(*statistics, density(patch).level()),
                    Owned<SquareStatistics>(nullptr, {memory}),
                    statistics->samples(),
                    statistics->rejected(),
                    statistics->saturated()};
  const SquareDensity& density = next.density ? *next.density : this->density(patch);
  next.statistics = makeOwned<SquareStatistics>(
      memory, memory, density.coefficients().size(),
      statistics->largest() > 0.0 ? SquareStatistics::unitExponentFor(magnitudeOf(*statistics))
                                  : statistics->unitExponent());
  return next;
}

AWDFieldStatistics Field::adapt() {
  std::pmr::memory_resource* memory = context_->memory();
  // All is made first and put in place after, so that a failure on the way changes nothing.
  std::pmr::vector<Patch*> sampled(memory);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (patch.samples() > 0) sampled.push_back(&patch);
  });
  std::pmr::vector<std::optional<Successor>> successors(sampled.size(), memory);

  constexpr std::size_t kBlock = 64;
  const std::size_t blocks = (sampled.size() + kBlock - 1) / kBlock;
  Progress progress(*context_, "adapt", this, blocks);
  context_->parallel().forEach(blocks, [&](std::size_t block) {
    if (progress.cancelled()) return;
    const std::size_t end = std::min(sampled.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i) successors[i] = succeed(*sampled[i]);
    progress.step();
  });
  progress.throwIfCancelled();

  lastPass_ = {};
  for (std::optional<Successor>& next : successors) {
    Patch& patch = *next->patch;
    lastPass_.samples += next->samples;
    lastPass_.rejected += next->rejected;
    lastPass_.saturated += next->saturated;
    if (next->density) {
      patch.density = std::move(next->density);
      patch.learned = next->samples;
    } else {
      ++lastPass_.kept;
    }
    patch.statistics = std::move(next->statistics);
    patch.marked.reset();
    patch.seen = true;
  }
  return statistics();
}

AWDFieldStatistics Field::statistics() const {
  AWDFieldStatistics figures = lastPass_;
  figures.bytes = sizeof *this + table_.bytes();
  table_.forEach([&](uint32_t, const Patch& patch) {
    figures.bytes += patch.bytes();
    if (!patch.hasBeenSeen()) return;
    ++figures.patches;
    figures.coefficients += density(patch).coefficients().size();
  });
  return figures;
}

void Field::mark() {
  std::pmr::memory_resource* memory = context_->memory();
  std::pmr::vector<std::pair<Patch*, Owned<SquareStatistics>>> fresh(memory);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (patch.marked || patch.statistics->samples() == 0) return;
    fresh.emplace_back(&patch,
                       makeOwned<SquareStatistics>(memory, memory, patch.statistics->components(),
                                                   patch.statistics->unitExponent()));
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
}

void Field::revert() {
  table_.forEach([](uint32_t, Patch& patch) { patch.statistics->clear(); });
}

AWDPatchInfo Field::patchInfo(uint32_t patch) const {
  const Patch* known = table_.find(patch);
  const BasisLevel& level = density(patch).level();
  return {sizeof(AWDPatchInfo), family_.name().c_str(),       level.level,
          level.count,          known ? known->samples() : 0, known ? known->learned : 0};
}

std::pmr::vector<uint32_t> Field::patches() const {
  std::pmr::vector<uint32_t> numbers(context_->memory());
  table_.forEach([&](uint32_t number, const Patch& patch) {
    if (patch.hasBeenSeen()) numbers.push_back(number);
  });
  return numbers;
}

void Field::pdfImage(uint32_t patch, uint32_t n, float* pixels, std::size_t rowStride) const {
  const SquareDensity& shown = density(patch);
  const auto middle = [n](uint32_t i) {
    return (static_cast<float>(i) + 0.5f) / static_cast<float>(n);
  };
  char* row = reinterpret_cast<char*>(pixels);
  for (uint32_t i = 0; i < n; ++i, row += rowStride) {
    for (uint32_t k = 0; k < n; ++k) {
      const auto value = static_cast<float>(shown.pdf(middle(k), middle(i)));
      std::memcpy(row + k * sizeof(float), &value, sizeof value);
    }
  }
}

}  // namespace awd
