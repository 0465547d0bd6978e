// SPDX-License-Identifier: Apache-2.0
#include "guide/field.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "density/grid_learning.h"
#include "density/projection.h"
#include "density/settings.h"
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
/// That the sums of refit may take in a patch.
constexpr std::size_t kMostRefitBytes = std::size_t{1} << 28;
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

Ref<DensityBases> compile(std::pmr::memory_resource* memory, const AWDBasisFamily& family,
                          uint32_t maxLevel) {
  const DensityBases::Axis axes[] = {{&family, maxLevel}, {&family, maxLevel}};
  return DensityBases::make(memory, axes, 2);
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
  if (desc.estimator < AWD_ESTIMATOR_DEFAULT || desc.estimator > AWD_ESTIMATOR_REFIT) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "desc->estimator is %d: not an AWD_ESTIMATOR_...",
         desc.estimator);
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
  LearningSettings& learning = settings.learning;
  learning.tau = desc.tau != 0.0 ? desc.tau : paper ? kPaperTau : kDefaultTau;
  learning.estimator =
      desc.estimator != AWD_ESTIMATOR_DEFAULT ? desc.estimator : AWD_ESTIMATOR_PAPER;
  settleShrinkage(desc.shrinkage, family.order == 1, learning);
  learning.maxCoefficients = UINT64_MAX;
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
      bases_(compile(context_->memory(), family, settings.maxLevel)),
      patterns_(context_->memory()),
      start_(context_->memory(), this->family().level(settings.startLevel)),
      unitExponent_(FixedSums::unitExponentFor(1.0)),
      lastPass_(),
      table_(context_->memory()) {
  if (settings.learning.estimator != AWD_ESTIMATOR_REFIT) return;
  for (uint32_t l = settings.startLevel; l <= settings.maxLevel; ++l) {
    const BasisLevel* const levels[] = {&this->family().level(l), &this->family().level(l)};
    patterns_.push_back(NormalPattern::make(context_->memory(), levels, 2));
    const std::size_t bytes = patterns_.back()->size() * sizeof(int64_t);
    if (bytes > kMostRefitBytes) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->maxLevel is level %u: at level %u the estimator refit would sum %zu bytes a "
           "patch, at most %zu are allowed",
           settings.maxLevel, l, bytes, kMostRefitBytes);
    }
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
    return awd::make<Patch>(memory, memory, freshStatistics(start_.level(), unitExponent_));
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
  known.statistics->record(sample, value * static_cast<double>(sample.solidAngle));
}

void Field::setScale(double magnitude) {
  unitExponent_ = FixedSums::unitExponentFor(magnitude);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (!patch.hasBeenSeen()) patch.statistics = freshStatistics(start_.level(), unitExponent_);
  });
}

Owned<PatchStatistics> Field::freshStatistics(const BasisLevel& level, int unitExponent) const {
  std::pmr::memory_resource* memory = context_->memory();
  if (settings_.learning.estimator == AWD_ESTIMATOR_PAPER) {
    return makeOwned<PatchStatistics>(memory, memory, level, unitExponent);
  }
  Ref<NormalPattern> pattern;
  if (!patterns_.empty()) pattern = patterns_[level.level - settings_.startLevel];
  return makeOwned<PatchStatistics>(memory, memory, level, std::move(pattern), unitExponent);
}

bool Field::finerIsDue(uint32_t level, uint64_t samples) const {
  if (level >= settings_.maxLevel) return false;
  if (settings_.preset == AWD_PRESET_PAPER) return true;
  const uint64_t n = family().level(level + 1).count;
  return samples >= kSamplesPerCoefficient * n * n;
}

Coefficients Field::estimate(const PatchStatistics& statistics, const BasisLevel& level,
                             const Refitter& refitter, RefitReport& report) const {
  std::pmr::memory_resource* memory = context_->memory();
  if (const SquareStatistics* byComponent = statistics.byComponent()) {
    Coefficients c = project(memory, level, bases_->axis(0).gram(level.level), *byComponent);
    if (!clampCoefficients(level, settings_.learning.tau, c)) c.clear();
    return c;
  }
  const Levels levels = {level.level, level.level};
  LearningSettings learning = settings_.learning;
  learning.minLevel = learning.maxLevel = levels;
  learning.refitter = refitter;
  LearningReport made;
  std::optional<GridState> state = learnGrid(
      *bases_, learning, levels, statistics.byFunction()->statistics(), statistics.samples(), made);
  report = std::move(made.refit);
  return state ? std::move(state->coefficients) : Coefficients(memory);
}

Owned<SquareDensity> Field::learn(const PatchStatistics& statistics, const BasisLevel& level,
                                  const Refitter& refitter, RefitReport& report) const {
  std::pmr::memory_resource* memory = context_->memory();
  Owned<SquareDensity> none(nullptr, {memory});
  if (statistics.common().overflowed()) return none;
  Coefficients c = estimate(statistics, level, refitter, report);
  if (c.empty()) return none;
  if (!finerIsDue(level.level, statistics.samples())) {
    return makeOwned<SquareDensity>(memory, level, std::move(c));
  }
  const uint32_t next = level.level + 1;
  c = refineTo(*bases_, {level.level, level.level}, {next, next}, c);
  return makeOwned<SquareDensity>(memory, family().level(next), std::move(c));
}

Field::Successor Field::succeed(Patch& patch, const Refitter& refitter) const {
  const BasisLevel& level = density(patch).level();
  const PatchStatistics* statistics = patch.statistics.get();
  Owned<PatchStatistics> whole(nullptr, {context_->memory()});
  if (patch.marked) {
    whole = freshStatistics(level, statistics->common().unitExponent());
    whole->add(*patch.marked);
    whole->add(*statistics);
    statistics = whole.get();
  }
  const FixedSums& common = statistics->common();
  RefitReport refit;
  Owned<SquareDensity> learned = learn(*statistics, level, refitter, refit);
  const BasisLevel& next = learned ? learned->level() : level;
  const int unitExponent = common.largest() > 0.0
                               ? FixedSums::unitExponentFor(statistics->magnitude())
                               : common.unitExponent();
  return {&patch,
          std::move(learned),
          freshStatistics(next, unitExponent),
          statistics->samples(),
          common.rejected(),
          common.saturated(),
          refit.status,
          refit.iterations};
}

AWDFieldStatistics Field::adapt() {
  std::pmr::memory_resource* memory = context_->memory();
  // All is made first and put in place after, so that a failure on the way changes nothing.
  std::pmr::vector<Patch*> sampled(memory);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (patch.samples() > 0) sampled.push_back(&patch);
  });
  std::pmr::vector<std::optional<Successor>> successors(sampled.size(), memory);

  const std::size_t each = patterns_.empty() ? 64 : 1;  // a refit takes long
  const std::size_t blocks = (sampled.size() + each - 1) / each;
  Progress progress(*context_, "adapt", this, blocks);
  Refitter refitter = settings_.learning.refitter;
  refitter.user = &progress;
  refitter.progress = [](void* user, double) -> int32_t {
    return !static_cast<const Progress*>(user)->cancelled();
  };
  context_->parallel().forEach(blocks, [&](std::size_t block) {
    if (progress.cancelled()) return;
    const std::size_t end = std::min(sampled.size(), (block + 1) * each);
    for (std::size_t i = block * each; i < end; ++i) {
      successors[i] = succeed(*sampled[i], refitter);
    }
    progress.step();
  });
  progress.throwIfCancelled();

  lastPass_ = {};
  for (std::optional<Successor>& next : successors) {
    Patch& patch = *next->patch;
    lastPass_.samples += next->samples;
    lastPass_.rejected += next->rejected;
    lastPass_.saturated += next->saturated;
    lastPass_.refitFailed += next->refitStatus == AWD_REFIT_FAILED;
    lastPass_.refitLimited += next->refitStatus == AWD_REFIT_LIMIT;
    lastPass_.refitIterations += next->refitIterations;
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
  for (const Ref<NormalPattern>& pattern : patterns_) figures.bytes += pattern->bytes();
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
  std::pmr::vector<std::pair<Patch*, Owned<PatchStatistics>>> fresh(memory);
  table_.forEach([&](uint32_t, Patch& patch) {
    if (patch.marked || patch.statistics->samples() == 0) return;
    fresh.emplace_back(
        &patch, freshStatistics(density(patch).level(), patch.statistics->common().unitExponent()));
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
  return {sizeof(AWDPatchInfo), family().name().c_str(),      level.level,
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
