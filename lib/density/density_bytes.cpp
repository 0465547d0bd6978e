// SPDX-License-Identifier: Apache-2.0
// A density and its statistics as bytes.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "basis/module.h"
#include "density/density.h"
#include "density/leaf_sampler.h"
#include "density/refit_bytes.h"
#include "density/statistics_bytes.h"
#include "util/error.h"
#include "util/random.h"

namespace awd {

namespace {

constexpr char kDensityMagic[] = "AWDDENSI";
constexpr char kStatisticsMagic[] = "AWDSTATI";
constexpr uint32_t kVersion = 1;

void putSettings(ByteWriter& writer, const DensitySettings& settings, const DensityBases& bases) {
  const LearningSettings& learning = settings.learning;
  writer.put(settings.dimensions);
  writer.put(settings.structure);
  writer.put(settings.sampler);
  writer.put(settings.combination);
  writer.put(learning.estimator);
  writer.put(learning.target);
  writer.put(learning.tau);
  writer.put(learning.shrinkage);
  writer.put(learning.maxCoefficients);
  writer.put(settings.passSamples);
  writer.put(learning.refitShrinkage);
  writer.put(learning.refitBytes);
  const AWDRefitSolver* solver = learning.refitter.solver;
  writer.putText(solver ? solver->name : "");
  for (uint32_t a = 0; a < settings.dimensions; ++a) {
    writer.putText(bases.family(a).name());
    writer.put(settings.startLevel[a]);
    writer.put(learning.minLevel[a]);
    writer.put(learning.maxLevel[a]);
  }
}

/// Settings, and the families that they name.
DensitySettings getSettings(ByteReader& reader, const Finders& find,
                            const AWDBasisFamily** families) {
  DensitySettings settings;
  LearningSettings& learning = settings.learning;
  settings.dimensions = reader.get<uint32_t>(1, kMaxDimensions);
  settings.structure = reader.get<int32_t>(AWD_STRUCTURE_GRID, AWD_STRUCTURE_TREE);
  settings.sampler = reader.get<int32_t>(AWD_SAMPLER_INVERSE_CDF, AWD_SAMPLER_COMPONENT);
  settings.combination = reader.get<int32_t>(AWD_COMBINE_COUNT, AWD_COMBINE_CROSS_VARIANCE);
  learning.estimator = reader.get<int32_t>(AWD_ESTIMATOR_DEFAULT, AWD_ESTIMATOR_REFIT);
  learning.target = reader.get<int32_t>(AWD_TARGET_MEAN, AWD_TARGET_RMS);
  learning.tau = reader.get<double>();
  learning.shrinkage = reader.get<double>();
  learning.maxCoefficients = reader.get<uint64_t>(1, uint64_t{1} << 30);
  settings.passSamples = reader.get<uint64_t>();
  learning.refitShrinkage = reader.get(-1.0, std::numeric_limits<double>::max());
  learning.refitBytes = reader.get<uint64_t>();
  const std::string solver(reader.getText(kLongestName));
  if (learning.estimator == AWD_ESTIMATOR_REFIT) {
    learning.refitter.solver = &find.solver(find.user, solver.c_str());
  }
  const bool tree = settings.structure == AWD_STRUCTURE_TREE;
  const bool paper = learning.estimator == AWD_ESTIMATOR_PAPER;
  const bool component = settings.sampler == AWD_SAMPLER_COMPONENT;
  if (!(learning.tau <= 1.0) || !(learning.shrinkage >= 0.0) ||
      !std::isfinite(learning.shrinkage) || (tree && component) || (paper && !component)) {
    reader.damaged();
  }
  uint64_t size = 1;
  for (uint32_t a = 0; a < settings.dimensions; ++a) {
    const std::string name(reader.getText(kLongestName));
    const AWDBasisFamily& family = find.family(find.user, name.c_str());
    families[a] = &family;
    if (tree && !(family.flags & AWD_BASIS_NESTED)) reader.damaged();
    const uint32_t least = tree ? 0 : family.minLevel;
    const uint32_t most = tree ? kMostHalvings : family.maxLevel;
    settings.startLevel[a] = reader.get<uint32_t>(least, most);
    learning.minLevel[a] = reader.get<uint32_t>(least, settings.startLevel[a]);
    learning.maxLevel[a] = reader.get<uint32_t>(settings.startLevel[a], most);
    size *= family.count(tree ? 0 : learning.maxLevel[a]);
    if (size > learning.maxCoefficients) reader.damaged();
  }
  if (tree && size > kMostLeafCoefficients) reader.damaged();
  return settings;
}

void putTree(ByteWriter& writer, const Tree& tree) {
  writer.put(uint64_t{tree.nodes().size()});
  for (const TreeNode& node : tree.nodes()) {
    writer.put(node.axis);
    writer.put(node.child);
  }
}

/// The same nodes in the same order.
Tree getTree(ByteReader& reader, std::pmr::memory_resource* memory, uint32_t dimensions) {
  const std::size_t count = reader.getCount(2 * sizeof(uint32_t));
  if (count == 0 || count > uint64_t{1} << 31) reader.damaged();
  std::pmr::vector<TreeNode> nodes(count, memory);
  for (TreeNode& node : nodes) {
    node.axis = reader.get<uint32_t>();
    node.child = reader.get<uint32_t>();
  }
  // Every node but the first has one parent, before it; no box is halved beyond all measure.
  std::pmr::vector<TreeBox> boxes(count, memory);
  std::pmr::vector<bool> reached(count, false, memory);
  reached[0] = true;
  for (std::size_t i = 0; i < count; ++i) {
    const TreeNode& node = nodes[i];
    if (!reached[i]) reader.damaged();
    if (node.leaf()) continue;
    if (node.axis >= dimensions || node.child <= i || node.child >= count - 1 ||
        reached[node.child] || reached[node.child + 1] ||
        boxes[i].depth[node.axis] >= kMostHalvings) {
      reader.damaged();
    }
    for (uint32_t half = 0; half < 2; ++half) {
      reached[node.child + half] = true;
      boxes[node.child + half] = boxes[i].half(node.axis, half);
    }
  }
  return {dimensions, std::move(nodes)};
}

Coefficients getCoefficients(ByteReader& reader, std::pmr::memory_resource* memory,
                             std::size_t size) {
  if (reader.getCount(sizeof(double)) != size) reader.damaged();
  Coefficients c(size, 0.0, memory);
  double largest = 0.0;
  for (double& value : c) {
    value = reader.get<double>();
    if (!(value >= 0.0) || !std::isfinite(value)) reader.damaged();
    largest = std::max(largest, value);
  }
  if (!(largest > 0.0)) reader.damaged();
  return c;
}

Model checkIntegral(ByteReader& reader, Model model) {
  const double zero[kMaxDimensions] = {};
  const double one[kMaxDimensions] = {1.0, 1.0, 1.0, 1.0, 1.0, 1.0};
  if (!(std::abs(model.mass(zero, one) - 1.0) <= 1e-9)) reader.damaged();
  return model;
}

}  // namespace

uint64_t Density::layout() const {
  uint64_t key = 0;
  const auto mix = [&key](uint64_t number) { key = mixBits(key ^ mixBits(number + 1)); };
  mix(settings_.dimensions);
  mix(static_cast<uint64_t>(settings_.structure));
  mix(static_cast<uint64_t>(settings_.learning.target));
  mix(settings_.learning.estimator == AWD_ESTIMATOR_PAPER);
  mix(settings_.learning.estimator == AWD_ESTIMATOR_REFIT);
  mix(passes_.kept().size());
  for (uint32_t a = 0; a < settings_.dimensions; ++a) {
    for (const char c : bases_->family(a).name()) mix(static_cast<unsigned char>(c));
    mix(levels_[a]);
  }
  if (model_.tree) {
    for (const TreeNode& node : model_.tree->tree().nodes()) {
      mix(node.axis);
      mix(node.child);
    }
  }
  return key;
}

std::pmr::vector<char> Density::statisticsBytes() const {
  ByteWriter writer(memory(), kStatisticsMagic, kVersion);
  writer.put(layout());
  put(writer, *statistics_);
  return writer.finish();
}

void Density::takeStatistics(const void* bytes, std::size_t size, bool instead) {
  ByteReader reader(bytes, size, kStatisticsMagic, kVersion, "statistics of a density");
  if (reader.get<uint64_t>() != layout()) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "bytes are statistics of a density of other bases, levels, boxes, target or estimator");
  }
  Owned<DensityStatistics> taken = freshStatistics(model_, passes_.kept().size());
  get(reader, *taken);
  reader.finish();
  if (instead) {
    statistics_ = std::move(taken);
  } else {
    statistics_->needRoomFor(taken->sums.samples);
    statistics_->add(*taken);
  }
}

void Density::putModel(ByteWriter& writer, const Model& model) const {
  if (model.grid) {
    for (uint32_t a = 0; a < dimensions(); ++a) writer.put(model.grid->levels()[a]->level);
  } else {
    putTree(writer, model.tree->tree());
  }
  writer.put(uint64_t{model.coefficients().size()});
  for (const double c : model.coefficients()) writer.put(c);
}

Model Density::getModel(ByteReader& reader) const {
  if (settings_.structure == AWD_STRUCTURE_TREE) {
    Tree tree = getTree(reader, memory(), dimensions());
    const std::size_t size = tree.leaves() * bases_->shape({}).size();
    Model model = treeModel(std::move(tree), getCoefficients(reader, memory(), size), Scale::asIs);
    return checkIntegral(reader, std::move(model));
  }
  Levels levels{};
  for (uint32_t a = 0; a < dimensions(); ++a) {
    levels[a] = reader.get<uint32_t>(bases_->family(a).minLevel(), bases_->family(a).maxLevel());
  }
  Coefficients c = getCoefficients(reader, memory(), bases_->shape(levels).size());
  return checkIntegral(reader, gridModel(levels, std::move(c), Scale::asIs));
}

std::pmr::vector<char> Density::bytesOf() const {
  ByteWriter writer(memory(), kDensityMagic, kVersion);
  putSettings(writer, settings_, *bases_);
  writer.put(learned_);
  writer.put(adapts_);
  putModel(writer, model_);
  const Passes::Totals& totals = passes_.totals();
  writer.put(totals.samples);
  writer.put(totals.passes);
  put(writer, totals.sum);
  put(writer, totals.variance);
  writer.put(uint64_t{passes_.kept().size()});
  for (const Passes::Pass& pass : passes_.kept()) {
    writer.put(pass.samples);
    put(writer, pass.mean);
    putModel(writer, pass.p);
  }
  if (!passes_.kept().empty()) {
    writer.put(passes_.lastPass().samples);
    put(writer, passes_.lastPass().mean);
    for (const long double moment : passes_.lastPass().secondMoments) put(writer, moment);
  }
  put(writer, *statistics_);
  return writer.finish();
}

Ref<Density> Density::load(Ref<Context> context, const void* bytes, std::size_t size,
                           const Finders& find) {
  std::pmr::memory_resource* memory = context->memory();
  ByteReader reader(bytes, size, kDensityMagic, kVersion, "a saved density");
  const AWDBasisFamily* families[kMaxDimensions];
  const DensitySettings settings = getSettings(reader, find, families);
  Ref<DensityBases> bases = compileBases(memory, settings, families);
  Ref<Density> density = Ref<Density>::adopt(
      awd::make<Density>(memory, std::move(context), std::move(bases), settings));
  density->learned_ = reader.get<uint64_t>();
  density->adapts_ = reader.get<uint64_t>();
  Model model = density->getModel(reader);

  Passes::Totals totals;
  totals.samples = reader.get<uint64_t>();
  totals.passes = reader.get<uint64_t>(0, totals.samples);
  totals.sum = getLong(reader);
  totals.variance = getLong(reader);
  const std::size_t kept = reader.getCount(sizeof(double));
  const bool keeps = settings.combination == AWD_COMBINE_CROSS_VARIANCE;
  if (kept > (keeps ? Passes::kKept : 0)) reader.damaged();
  std::pmr::vector<Passes::Pass> passes(memory);
  for (std::size_t k = 0; k < kept; ++k) {
    const auto samples = reader.get<uint64_t>(1, totals.samples);
    const long double mean = getLong(reader);
    passes.push_back({density->getModel(reader), samples, mean});
  }
  Passes::LastPass last(memory);
  if (kept > 0) {
    last.samples = reader.get<uint64_t>(1, totals.samples);
    last.mean = getLong(reader);
    for (std::size_t k = 0; k < kept; ++k) last.secondMoments.push_back(getLong(reader));
  }
  density->passes_.load(totals, std::move(passes), std::move(last));

  Levels levels{};
  if (model.grid) {
    for (uint32_t a = 0; a < settings.dimensions; ++a) levels[a] = model.grid->levels()[a]->level;
  }
  if (settings.learning.estimator == AWD_ESTIMATOR_REFIT &&
      refitBytes(density->bases(), levels) * static_cast<double>(model.leaves()) >
          2.0 * static_cast<double>(reader.remaining())) {
    reader.damaged();  // sums that are not there
  }
  density->become(std::move(model), levels);
  get(reader, *density->statistics_);
  reader.finish();
  return density;
}

}  // namespace awd
