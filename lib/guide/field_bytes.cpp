// SPDX-License-Identifier: Apache-2.0
// A field and its statistics as bytes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_map>

#include "basis/module.h"
#include "guide/field.h"
#include "util/error.h"

namespace awd {

namespace {

constexpr char kMagic[] = "AWDFIELD";
constexpr uint32_t kVersion = 2;
constexpr uint32_t kMostSplits = 1u << 28;
/// Of units, with room for that of any double.
constexpr int32_t kFarthestExponent = 1200;
constexpr double kLargest = std::numeric_limits<double>::max();
/// Numbers of densities in bytes: the start density has none.
constexpr uint32_t kStart = 0xffffffffu;
/// A patch at least.
constexpr std::size_t kLeastPatch = 48;

void putUnits(ByteWriter& writer, PatchUnits units) {
  writer.put(static_cast<int32_t>(units.values));
  writer.put(static_cast<int32_t>(units.lights));
}

PatchUnits getUnits(ByteReader& reader) {
  const auto exponent = [&] { return reader.get<int32_t>(-kFarthestExponent, kFarthestExponent); };
  const int values = exponent();
  return {values, exponent()};
}

void put(ByteWriter& writer, Vec3f v) {
  for (const float x : {v.x, v.y, v.z}) writer.put(static_cast<double>(x));
}

Vec3f getVector(ByteReader& reader) {
  constexpr double kFloat = std::numeric_limits<float>::max();
  float v[3];
  for (float& x : v) x = static_cast<float>(reader.get(-kFloat, kFloat));
  return load(v);
}

void putSettings(ByteWriter& writer, const FieldSettings& settings, const Family& family) {
  // Names all members: with one more this doesn't compile until that is saved too.
  const auto& [preset, map, startLevel, maxLevel, learning, alpha, patches, lower, upper,
               patchSamples, maxBytes, target, lights] = settings;
  writer.putText(family.name());
  const AWDRefitSolver* solver = learning.refitter.solver;
  writer.putText(solver ? solver->name : "");
  writer.put(preset);
  writer.put(map);
  writer.put(startLevel);
  writer.put(maxLevel);
  writer.put(learning.estimator);
  writer.put(learning.tau);
  writer.put(learning.shrinkage);
  writer.put(learning.refitShrinkage);
  writer.put(learning.maxCoefficients);
  writer.put(alpha);
  writer.put(patches);
  put(writer, lower);
  put(writer, upper);
  writer.put(patchSamples);
  writer.put(maxBytes);
  writer.put(target);
  writer.put(lights ? lights->lights() : 0u);
  if (lights) lights->put(writer);
}

FieldSettings getSettings(ByteReader& reader, std::pmr::memory_resource* memory,
                          const Finders& find, const AWDBasisFamily*& family) {
  const std::string basis(reader.getText(kLongestName));
  const std::string solver(reader.getText(kLongestName));
  family = &find.family(find.user, basis.c_str());
  FieldSettings settings;
  LearningSettings& learning = settings.learning;
  settings.preset = reader.get<int32_t>(AWD_PRESET_DEFAULT, AWD_PRESET_PAPER);
  settings.map = reader.get<int32_t>(AWD_MAP_SPHERICAL, AWD_MAP_COSINE);
  const uint32_t finest = finestFieldLevel(*family);
  settings.startLevel = reader.get<uint32_t>(family->minLevel, finest);
  settings.maxLevel = reader.get<uint32_t>(settings.startLevel, finest);
  learning.estimator = reader.get<int32_t>(AWD_ESTIMATOR_PAPER, AWD_ESTIMATOR_LUMPED);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();  // negated: no floor
  learning.tau = reader.get(-kInfinity, 1.0);
  learning.shrinkage = reader.get(0.0, kLargest);
  learning.refitShrinkage = reader.get(-1.0, kLargest);
  learning.maxCoefficients = reader.get<uint64_t>();
  settings.alpha = reader.get(0.0, 1.0);
  settings.patches = reader.get<int32_t>(AWD_PATCHES_SPATIAL, AWD_PATCHES_HOST);
  settings.lower = getVector(reader);
  settings.upper = getVector(reader);
  settings.patchSamples = reader.get<uint32_t>(1, UINT32_MAX);
  settings.maxBytes = reader.get<uint64_t>();
  settings.target = reader.get<int32_t>(AWD_TARGET_MEAN, AWD_TARGET_RMS);
  if (const auto lights = reader.get<uint32_t>(0, AWD_MOST_FIELD_LIGHTS)) {
    settings.lights = LightChoice::get(reader, memory, lights);
  }
  const Vec3f size = settings.upper - settings.lower;
  if (!isFinite(size) || size.x < 0.0f || size.y < 0.0f || size.z < 0.0f) reader.damaged();
  if (learning.estimator == AWD_ESTIMATOR_REFIT) {
    learning.refitter.solver = &find.solver(find.user, solver.c_str());
  }
  return settings;
}

void putFigures(ByteWriter& writer, const AWDFieldStatistics& lastPass) {
  // All that statistics() does not count anew; as above.
  const auto& [structSize, patches, coefficients, bytes, samples, rejected, saturated, kept, failed,
               limited, iterations, capped, nan, infinite, negative, pdf] = lastPass;
  for (const uint64_t figure : {samples, rejected, saturated, kept, failed, limited, iterations,
                                capped, nan, infinite, negative, pdf}) {
    writer.put(figure);
  }
}

AWDFieldStatistics getFigures(ByteReader& reader) {
  AWDFieldStatistics figures = {};
  for (uint64_t* figure : {&figures.samples, &figures.rejected, &figures.saturated, &figures.kept,
                           &figures.refitFailed, &figures.refitLimited, &figures.refitIterations,
                           &figures.capped, &figures.rejectedNaN, &figures.rejectedInfinite,
                           &figures.rejectedNegative, &figures.rejectedPdf}) {
    *figure = reader.get<uint64_t>();
  }
  return figures;
}

/// The splits in the order in which they were made, which is that of the leaves they made.
void putTree(ByteWriter& writer, const SpatialTree& tree) {
  writer.put(uint64_t{tree.leaves() - SpatialTree::kBins});
  for (uint32_t leaf = SpatialTree::kBins; leaf < tree.leaves(); ++leaf) {
    writer.put(tree.origin(leaf));
    writer.put(static_cast<uint8_t>(tree.side(leaf)));
  }
}

void getTree(ByteReader& reader, SpatialTree& tree) {
  const std::size_t splits = reader.getCount(sizeof(uint32_t) + 1);
  if (splits > kMostSplits) reader.damaged();
  for (std::size_t i = 0; i < splits; ++i) {
    const auto origin = reader.get<uint32_t>(0, tree.leaves() - 1);
    const auto side = reader.get<uint8_t>(0, 1);
    if (!tree.canSplit(origin)) reader.damaged();
    tree.split(origin, 1u - side);
  }
  tree.finish();
}

Coefficients getCoefficients(ByteReader& reader, std::pmr::memory_resource* memory,
                             const BasisLevel& level) {
  const std::size_t n = level.count;
  if (reader.getCount(sizeof(double)) != n * n) reader.damaged();
  Coefficients c(n * n, 0.0, memory);
  double integral = 0.0;
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = reader.get(0.0, kLargest);
    integral += c[i] * level.weights[i / n] * level.weights[i % n];
  }
  if (!(std::abs(integral - 1.0) <= 1e-9)) reader.damaged();
  return c;
}

void putKnowledge(ByteWriter& writer, const PatchKnowledge& known) {
  // As above; densities are shared, and saved on their own.
  const auto& [density, weight, mean, alpha, eighths, root, lights, lightShare] = known;
  for (const double x : {weight, mean, alpha, root, lightShare}) writer.put(x);
  for (const uint64_t count : eighths) writer.putPacked(count);
  writer.put(static_cast<uint8_t>(lights.get() != nullptr));
  if (lights) lights->put(writer);
}

PatchKnowledge getKnowledge(ByteReader& reader, std::pmr::memory_resource* memory,
                            Ref<SquareDensity> density, uint32_t lights) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();  // of sums beyond doubles
  PatchKnowledge known;
  known.density = std::move(density);
  known.weight = reader.get(0.0, kLargest);
  known.mean = reader.get(0.0, kInfinity);
  known.alpha = reader.get(0.0, 1.0);
  known.root = reader.get(0.0, kInfinity);
  known.lightShare = reader.get(0.0, 1.0);
  for (uint64_t& count : known.eighths) count = reader.getPacked();
  if (reader.get<uint8_t>(0, lights > 0 ? 1 : 0)) {
    known.lights = LightChoice::get(reader, memory, lights);
  }
  return known;
}

}  // namespace

std::pmr::vector<char> Field::bytesOf() const {
  std::pmr::memory_resource* memory = context_->memory();
  ByteWriter writer(memory, kMagic, kVersion);
  putSettings(writer, settings_, family());
  putUnits(writer, units_);
  putFigures(writer, lastPass_);
  if (tree_) putTree(writer, *tree_);
  writer.put(static_cast<uint8_t>(!views_.empty()));

  // Each density once, in the order of the first patches that have them.
  std::pmr::unordered_map<const SquareDensity*, uint32_t> numbers(memory);
  std::pmr::vector<const SquareDensity*> densities(memory);
  uint64_t patches = 0;
  table_.forEach([&](uint32_t, const Patch& patch) {
    const SquareDensity* density = patch.known.density.get();
    const auto next = static_cast<uint32_t>(densities.size());
    if (density && numbers.emplace(density, next).second) densities.push_back(density);
    ++patches;
  });
  writer.put(uint64_t{densities.size()});
  for (const SquareDensity* density : densities) {
    writer.put(density->level().level);
    writer.put(uint64_t{density->coefficients().size()});
    for (const double c : density->coefficients()) writer.put(c);
  }

  writer.put(patches);
  table_.forEach([&](uint32_t key, const Patch& patch) {
    const SquareDensity* density = patch.known.density.get();
    writer.put(key);
    writer.put(density ? numbers.at(density) : kStart);
    putKnowledge(writer, patch.known);
    writer.put(patch.learned);
    writer.put(static_cast<uint8_t>(patch.seen));
    writer.put(static_cast<uint8_t>(key < views_.size() && views_[key].statistics));
    putUnits(writer, patch.statistics->units());
    patch.statistics->put(writer);
    writer.put(static_cast<uint8_t>(patch.marked != nullptr));
    if (patch.marked) patch.marked->put(writer);
  });
  return writer.finish();
}

Owned<PatchStatistics> Field::getStatistics(ByteReader& reader, const BasisLevel& level,
                                            PatchUnits units) const {
  // Every sum takes a byte at least: no patch is given more memory than its bytes answer for.
  if (reader.remaining() < std::size_t{level.count} * level.count) reader.damaged();
  Owned<PatchStatistics> statistics = learning_.freshStatistics(level, units);
  statistics->get(reader);
  return statistics;
}

Ref<Field> Field::load(Ref<Context> context, const void* bytes, std::size_t size,
                       const Finders& find) {
  std::pmr::memory_resource* memory = context->memory();
  ByteReader reader(bytes, size, kMagic, kVersion, "a saved field");
  const AWDBasisFamily* family;
  const FieldSettings settings = getSettings(reader, memory, find, family);
  Ref<Field> field = make(std::move(context), *family, settings);
  field->units_ = getUnits(reader);
  field->lastPass_ = getFigures(reader);
  if (field->tree_) getTree(reader, *field->tree_);
  const bool adapted = reader.get<uint8_t>(0, field->tree_ ? 1 : 0) != 0;

  const std::size_t count = reader.getCount(sizeof(double));
  std::pmr::vector<Ref<SquareDensity>> densities(memory);
  for (std::size_t i = 0; i < count; ++i) {
    const BasisLevel& level =
        field->family().level(reader.get<uint32_t>(settings.startLevel, settings.maxLevel));
    densities.push_back(SquareDensity::make(level, settings.sampler(),
                                            getCoefficients(reader, memory, level), Scale::asIs));
  }

  // Patches touched since the last adapt are not yet in the views that it left.
  struct Late {
    uint32_t key;
    Owned<Patch> patch;
  };
  std::pmr::vector<Late> late(memory);
  const auto place = [&](uint32_t key, Owned<Patch>& patch) {
    field->table_.touch(key, [&] { return patch.release(); });
  };
  const std::size_t patches = reader.getCount(kLeastPatch);
  uint64_t leastKey = 0;
  for (std::size_t i = 0; i < patches; ++i) {
    const auto key = reader.get<uint32_t>();
    if (key < leastKey || (field->tree_ && key >= field->tree_->leaves())) reader.damaged();
    leastKey = uint64_t{key} + 1;
    const auto number = reader.get<uint32_t>();
    if (number != kStart && number >= densities.size()) reader.damaged();
    PatchKnowledge known =
        getKnowledge(reader, memory, number == kStart ? Ref<SquareDensity>() : densities[number],
                     field->lights());
    const auto learned = reader.get<uint64_t>();
    const bool seen = reader.get<uint8_t>(0, 1) != 0;
    const bool viewed = reader.get<uint8_t>(0, adapted && seen ? 1 : 0) != 0;
    const PatchUnits units = getUnits(reader);
    const BasisLevel& level = field->density(known).level();
    Owned<Patch> patch =
        makeOwned<Patch>(memory, memory, field->getStatistics(reader, level, units));
    if (reader.get<uint8_t>(0, 1)) patch->marked = field->getStatistics(reader, level, units);
    patch->known = std::move(known);
    patch->learned = learned;
    patch->seen = seen;
    if (adapted && !viewed) {
      late.push_back({key, std::move(patch)});
    } else {
      place(key, patch);
    }
  }
  reader.finish();
  if (adapted) field->views_.resize(field->tree_->leaves());
  for (uint32_t leaf = 0; leaf < field->views_.size(); ++leaf) {
    field->views_[leaf] = field->viewOf(leaf);
  }
  for (Late& next : late) {
    // Samples are drawn by the view, and recorded by the patch.
    if (&field->density(next.patch->known) != field->views_[next.key].density) reader.damaged();
    place(next.key, next.patch);
  }
  return field;
}

}  // namespace awd
