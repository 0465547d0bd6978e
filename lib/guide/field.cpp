// SPDX-License-Identifier: Apache-2.0
#include "guide/field.h"

#include <algorithm>
#include <cstring>

#include "util/error.h"

namespace awd {

namespace {

Ref<DensityBases> compile(std::pmr::memory_resource* memory, const AWDBasisFamily& family,
                          uint32_t maxLevel) {
  const DensityBases::Axis axes[] = {{&family, maxLevel}, {&family, maxLevel}};
  return DensityBases::make(memory, axes, 2);
}

}  // namespace

Ref<Field> Field::make(Ref<Context> context, const AWDBasisFamily& family,
                       const FieldSettings& settings) {
  std::pmr::memory_resource* memory = context->memory();
  return Ref<Field>::adopt(awd::make<Field>(memory, std::move(context), family, settings));
}

Field::Field(Ref<Context> context, const AWDBasisFamily& family, const FieldSettings& settings)
    : context_(std::move(context)),
      settings_(settings),
      learning_(context_->memory(), settings_,
                compile(context_->memory(), family, settings.maxLevel)),
      units_(PatchUnits::of(1.0)),
      lastPass_(),
      table_(context_->memory()),
      views_(context_->memory()) {
  const BasisLevel& level = learning_.startLevel();
  // The functions sum to 1, so that coefficients 1 are the constant 1.
  start_ = SquareDensity::make(
      level, settings_.sampler(),
      Coefficients(std::size_t{level.count} * level.count, 1.0, context_->memory()));
  if (settings_.patches == AWD_PATCHES_SPATIAL) {
    tree_.emplace(context_->memory(), settings_.lower, settings_.upper);
  }
}

void Field::destroy() noexcept {
  const Ref<Context> context = context_;  // the memory outlives the field
  unmake(context->memory(), this);
}

const Patch* Field::nearest(uint32_t key) const {
  for (;;) {
    if (const Patch* patch = table_.find(key)) return patch;
    if (!tree_ || key >= tree_->leaves() || tree_->origin(key) == key) return nullptr;
    key = tree_->origin(key);
  }
}

PatchView Field::viewOf(uint32_t key) const {
  const Patch* origin = nearest(key);
  const SquareDensity& current = origin ? density(origin->known) : *start_;
  PatchView view;
  view.density = &current;
  view.nodalTables = current.nodal().data();
  view.nodalCells = static_cast<uint16_t>(current.level().cells);
  view.lights = origin ? learning_.lights(origin->known) : learning_.lights();
  if (!origin) return view;
  if (const Patch* patch = table_.find(key)) view.statistics = patch->statistics.get();
  view.mean = static_cast<float>(origin->known.mean);
  view.known = origin->known.weight > 0.0;
  return view;
}

void Field::renewViews() {
  for (uint32_t leaf = 0; leaf < views_.size(); ++leaf) {
    PatchView& view = views_[leaf];
    if (!view.statistics) continue;
    Patch* patch = table_.find(leaf);
    view.statistics = patch ? patch->statistics.get() : nullptr;
  }
}

AWDDirectionSample Field::sample(const PatchView& view, Vec3f normal,
                                 const double uniforms[3]) const {
  SquareSample point;
  if (view.nodalTables) {
    const NodalSquare::Sample drawn = view.nodal().sample(uniforms[0], uniforms[1]);
    point = {drawn.u, drawn.v, AWD_INVALID_ID, static_cast<double>(drawn.pdf)};
  } else {
    point = view.density->sample(uniforms);
  }
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

AWDDirectionSample Field::mapDirection(uint32_t patch, Vec3f normal, Vec3f direction) const {
  AWDDirectionSample sample = {
      {direction.x, direction.y, direction.z}, 0.0f, {}, AWD_INVALID_ID, 0.0f};
  const Vec3f local = Frame(normal).toLocal(direction);
  if (!(local.z > 0.0f)) return sample;
  float* at = sample.square;
  mapToSquare(settings_.map, local, at[0], at[1]);
  sample.solidAngle = solidAngleAt(settings_.map, local);
  sample.pdf = static_cast<float>(density(patch).pdf(at[0], at[1]) / sample.solidAngle);
  return sample;
}

Patch& Field::touch(uint32_t key) {
  return table_.touch(key, [&] { return newPatch(key); });
}

PatchUnits Field::unitsOf(uint32_t key) const {
  const Patch* patch = nearest(key);
  return patch ? patch->statistics->units() : units_;
}

Patch* Field::newPatch(uint32_t key) const {
  std::pmr::memory_resource* memory = context_->memory();
  const Patch* from = nearest(key);
  const PatchKnowledge known = from ? from->known : PatchKnowledge();
  Patch* made = awd::make<Patch>(memory, memory,
                                 learning_.freshStatistics(density(known).level(), unitsOf(key)));
  // A part of a patch that had no sample there: its density, to begin with, and no more.
  made->known.density = known.density;
  made->known.lights = known.lights;
  made->known.lightShare = 0.0;
  made->known.alpha = known.alpha;
  return made;
}

void Field::checkPatch(uint32_t patch) const {
  if (tree_ && keyOf(patch) >= tree_->leaves()) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "patch is %u: the field has none of this number; ask awdFindPatch again after each adapt",
         patch);
  }
  if (!tree_ && (patch | AWD_PATCH_BACK) == AWD_INVALID_ID) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "patch is 0x%x: numbers of patches are below 2^31 - 1", patch);
  }
}

void Field::checkRecord(uint32_t patch, const AWDDirectionSample& sample) const {
  checkPatch(patch);
  if (settings_.sampler() != AWD_SAMPLER_COMPONENT) return;
  const std::size_t components = density(patch).coefficients().size();
  if (sample.component >= components) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "sample->component is %u: patch %u has %zu components; was the sample drawn from it since "
         "the last adapt?",
         sample.component, patch, components);
  }
}

void Field::record(uint32_t patch, const PatchView& view, const AWDDirectionSample& sample,
                   double value) {
  checkRecord(patch, sample);
  PatchStatistics& sums = view.statistics ? *view.statistics : *touch(keyOf(patch)).statistics;
  // The density lives on the square: f there is f in solid angle times d omega / d(u,v).
  sums.record(tree_ ? patch % SpatialTree::kEighths : 0, sample,
              value * static_cast<double>(sample.solidAngle));
}

void Field::reject(uint32_t patch) {
  touch(keyOf(patch)).statistics->reject(tree_ ? patch % SpatialTree::kEighths : 0);
}

void Field::setScale(double magnitude) {
  const PatchUnits units = PatchUnits::of(magnitude);
  std::pmr::vector<std::pair<Patch*, Owned<PatchStatistics>>> fresh(context_->memory());
  table_.forEach([&](uint32_t, Patch& patch) {
    if (patch.hasBeenSeen()) return;
    fresh.emplace_back(&patch, learning_.freshStatistics(density(patch.known).level(), units));
  });
  // Nothing below can fail.
  units_ = units;
  for (auto& [patch, statistics] : fresh) {
    patch->statistics = std::move(statistics);
    patch->marked.reset();
  }
  renewViews();
}

bool Field::mayRefine(const std::pmr::vector<std::pair<uint32_t, Patch*>>& patches) const {
  if (settings_.maxBytes == std::numeric_limits<uint64_t>::max()) return true;
  uint64_t bytes = statistics().bytes - table_.bytes();
  // Finding out takes a density of each level.
  std::pmr::vector<std::size_t> ofLevels(context_->memory());
  for (const auto& [key, patch] : patches) {
    const BasisLevel& level = density(patch->known).level();
    while (ofLevels.size() <= level.level) {
      const auto next = static_cast<uint32_t>(ofLevels.size());
      const bool used = next >= settings_.startLevel;
      ofLevels.push_back(used ? learning_.bytesToRefine(family().level(next)) : 0);
    }
    bytes += ofLevels[level.level];
  }
  return bytes <= settings_.maxBytes;
}

Field::Successor Field::succeed(uint32_t key, Patch& patch, bool mayRefine,
                                const Refitter& refitter) const {
  const BasisLevel& level = density(patch.known).level();
  const PatchStatistics* statistics = patch.statistics.get();
  Owned<PatchStatistics> whole(nullptr, {context_->memory()});
  if (patch.marked) {
    whole = learning_.freshStatistics(level, statistics->units());
    whole->add(*patch.marked);
    whole->add(*statistics);
    statistics = whole.get();
  }
  const FixedSums& common = statistics->common();
  RefitReport refit;
  PatchKnowledge known =
      learning_.learn(patch.known, level, *statistics, mayRefine, refitter, refit);
  const BasisLevel& next = density(known).level();
  std::array<uint64_t, kRejections> rejected = common.rejections();
  const auto ofLights = statistics->lights().rejections();
  for (std::size_t i = 0; i < rejected.size(); ++i) rejected[i] += ofLights[i];
  return {key,
          &patch,
          std::move(known),
          learning_.freshStatistics(next, statistics->nextUnits()),
          statistics->samples(),
          rejected,
          common.saturated() + statistics->lights().saturated(),
          std::move(refit)};
}

std::pmr::vector<Field::Successor> Field::learnAll() {
  std::pmr::memory_resource* memory = context_->memory();
  std::pmr::vector<std::pair<uint32_t, Patch*>> sampled(memory);
  table_.forEach([&](uint32_t key, Patch& patch) {
    if (patch.hasRecords()) sampled.emplace_back(key, &patch);
  });
  std::pmr::vector<std::optional<Successor>> made(sampled.size(), memory);

  const bool refine = mayRefine(sampled);
  const bool refits = settings_.learning.estimator == AWD_ESTIMATOR_REFIT;
  const std::size_t each = refits ? 1 : 64;  // a refit takes long
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
      made[i] = succeed(sampled[i].first, *sampled[i].second, refine, refitter);
    }
    progress.step();
  });
  progress.throwIfCancelled();

  std::pmr::vector<Successor> successors(memory);
  successors.reserve(made.size());
  for (std::optional<Successor>& next : made) successors.push_back(std::move(*next));
  return successors;
}

void Field::take(Successor& next) {
  Patch& patch = *next.patch;
  lastPass_.samples += next.samples;
  lastPass_.rejectedNaN += next.rejected[static_cast<std::size_t>(Rejection::kNaN)];
  lastPass_.rejectedInfinite += next.rejected[static_cast<std::size_t>(Rejection::kInfinite)];
  lastPass_.rejectedNegative += next.rejected[static_cast<std::size_t>(Rejection::kNegative)];
  lastPass_.rejectedPdf += next.rejected[static_cast<std::size_t>(Rejection::kPdf)];
  for (const uint64_t count : next.rejected) lastPass_.rejected += count;
  lastPass_.saturated += next.saturated;
  lastPass_.refitFailed += next.refit.status == AWD_REFIT_FAILED;
  lastPass_.refitLimited += next.refit.status == AWD_REFIT_LIMIT;
  lastPass_.refitIterations += next.refit.iterations;
  if (next.known.density.get() != patch.known.density.get()) {
    patch.learned = next.samples;
  } else {
    ++lastPass_.kept;
  }
  patch.known = std::move(next.known);
  patch.statistics = std::move(next.statistics);
  patch.marked.reset();
  patch.seen = true;
}

AWDFieldStatistics Field::adapt() {
  // All is made first and put in place after, so that a failure on the way changes nothing.
  std::pmr::vector<Successor> successors = learnAll();
  uint64_t capped = 0;
  if (tree_) {
    SpatialTree tree(context_->memory(), *tree_);
    std::pmr::vector<Newcomer> newcomers = splitAll(tree, successors, capped);
    tree.finish();
    for (const Newcomer& newcomer : newcomers) table_.reserve(newcomer.key);
    views_.reserve(tree.leaves());
    *tree_ = std::move(tree);
    views_.resize(tree_->leaves());
    for (Newcomer& newcomer : newcomers) {
      table_.touch(newcomer.key, [&] { return newcomer.patch.release(); });
    }
  }
  lastPass_ = {};
  lastPass_.capped = capped;
  for (Successor& next : successors) take(next);
  removeUnseen();  // or views would keep what knows nothing
  for (uint32_t leaf = 0; leaf < views_.size(); ++leaf) views_[leaf] = viewOf(leaf);
  return statistics();
}

bool Field::hasRecords() const {
  bool any = false;
  table_.forEach([&](uint32_t, const Patch& patch) { any |= patch.hasRecords(); });
  return any;
}

AWDFieldStatistics Field::statistics() const {
  AWDFieldStatistics figures = lastPass_;
  figures.bytes = sizeof *this + table_.bytes() + learning_.bytes() + (tree_ ? tree_->bytes() : 0);
  table_.forEach([&](uint32_t, const Patch& patch) {
    figures.bytes += patch.bytes() + memoryOf(patch.known);
    if (!patch.hasBeenSeen()) return;
    ++figures.patches;
    figures.coefficients += density(patch.known).coefficients().size();
  });
  return figures;
}

AWDPatchInfo Field::patchInfo(uint32_t patch) const {
  const Patch* known = table_.find(keyOf(patch));
  const BasisLevel& level = density(patch).level();
  return {sizeof(AWDPatchInfo), family().name().c_str(),      level.level,
          level.count,          known ? known->samples() : 0, known ? known->learned : 0};
}

std::pmr::vector<uint32_t> Field::patches() const {
  std::pmr::vector<uint32_t> numbers(context_->memory());
  table_.forEach([&](uint32_t key, const Patch& patch) {
    if (patch.hasBeenSeen()) numbers.push_back(numberOf(key));
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
