// SPDX-License-Identifier: Apache-2.0
#include "density/density.h"

#include <algorithm>
#include <cmath>

#include "density/grid_learning.h"
#include "density/tree_halving.h"
#include "density/tree_learning.h"
#include "util/error.h"

namespace awd {

namespace {

/// Points of a batch that are looked up in the earlier passes' densities at once.
constexpr std::size_t kBatch = 256;

}  // namespace

Density::Density(Ref<Context> context, Ref<DensityBases> bases, const DensitySettings& settings)
    : context_(std::move(context)),
      bases_(std::move(bases)),
      settings_(settings),
      levels_(settings.startLevel),
      statistics_(nullptr, {context_->memory()}),
      passes_(context_->memory(), settings.combination),
      refitMessage_(context_->memory()) {}

Ref<Density> Density::make(Ref<Context> context, Ref<DensityBases> bases,
                           const DensitySettings& settings) {
  std::pmr::memory_resource* memory = context->memory();
  Ref<Density> density = Ref<Density>::adopt(
      awd::make<Density>(memory, std::move(context), std::move(bases), settings));
  const uint32_t d = settings.dimensions;
  // The functions of every basis sum to 1, so that coefficients 1 are the constant 1.
  if (settings.structure == AWD_STRUCTURE_TREE) {
    Tree tree(memory, d, settings.startLevel.data());
    Coefficients ones(tree.leaves() * density->bases().shape({}).size(), 1.0, memory);
    density->become(density->treeModel(std::move(tree), std::move(ones)), {});
  } else {
    Coefficients ones(density->bases().shape(settings.startLevel).size(), 1.0, memory);
    density->become(density->gridModel(settings.startLevel, std::move(ones)), settings.startLevel);
  }
  return density;
}

Ref<Density> Density::fork(const Density& from) {
  std::pmr::memory_resource* memory = from.memory();
  Ref<Density> fork =
      Ref<Density>::adopt(awd::make<Density>(memory, from.context_, from.bases_, from.settings_));
  fork->passes_ = from.passes_;
  fork->learned_ = from.learned_;
  fork->adapts_ = from.adapts_;
  fork->become(from.model_, from.levels_);
  return fork;
}

void Density::destroy() noexcept {
  const Ref<Context> context = context_;  // the memory outlives the density
  unmake(context->memory(), this);
}

Model Density::gridModel(const Levels& levels, Coefficients coefficients, Scale scale) const {
  const BasisLevel* tables[kMaxDimensions];
  bases_->tables(levels, tables);
  return {GridDensity::make(memory(), tables, dimensions(), settings_.sampler,
                            std::move(coefficients), scale),
          {}};
}

Model Density::treeModel(Tree tree, Coefficients coefficients, Scale scale) const {
  const BasisLevel* tables[kMaxDimensions];
  bases_->tables({}, tables);
  return {{}, TreeDensity::make(memory(), tables, std::move(tree), std::move(coefficients), scale)};
}

Owned<DensityStatistics> Density::freshStatistics(const Model& model, std::size_t earlier) const {
  const std::size_t boxes = model.tree ? model.leaves() * (dimensions() + 1) : 0;
  return makeOwned<DensityStatistics>(memory(), memory(), model.coefficients().size(), boxes,
                                      earlier, patternOf(model), model.leaves());
}

Ref<NormalPattern> Density::patternOf(const Model& model) const {
  if (settings_.learning.estimator != AWD_ESTIMATOR_REFIT) return {};
  const BasisLevel* const* levels = model.grid ? model.grid->levels() : model.tree->levels();
  if (statistics_ && statistics_->normal.pattern->isOf(levels)) return statistics_->normal.pattern;
  return NormalPattern::make(memory(), levels, dimensions());
}

void Density::become(Model model, const Levels& levels) {
  statistics_ = freshStatistics(model, passes_.kept().size());
  model_ = std::move(model);
  levels_ = levels;
}

void Density::needNoSamples(const char* what) const {
  if (statistics_->sums.samples == 0) return;
  fail(AWD_ERROR_INVALID_OPERATION, "%llu samples have been recorded: adapt before %s",
       static_cast<unsigned long long>(statistics_->sums.samples), what);
}

void Density::sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
                     uint32_t* components) const {
  if (model_.grid) {
    model_.grid->sample(count, uniforms, points, pdfs, components);
  } else {
    model_.tree->sample(count, uniforms, points, pdfs, components);
  }
}

void Density::record(std::size_t count, const double* points, const double* pdfs,
                     const uint32_t* components, const double* values) {
  DensityStatistics& statistics = *statistics_;
  statistics.needRoomFor(count);
  const AWDTarget target = settings_.learning.target;
  const bool paper = settings_.learning.estimator == AWD_ESTIMATOR_PAPER;
  if (model_.grid) {
    model_.grid->record(count, points, pdfs, paper ? components : nullptr, values, target,
                        statistics);
  } else {
    model_.tree->record(count, points, pdfs, values, target, statistics);
  }
  if (passes_.kept().empty()) return;
  double own[kBatch], theirs[kBatch];
  for (std::size_t done = 0; done < count; done += kBatch) {
    const std::size_t batch = std::min(kBatch, count - done);
    const double* at = points + done * dimensions();
    const double* p = pdfs ? pdfs + done : own;
    if (!pdfs) model_.pdf(batch, at, own);
    for (std::size_t k = 0; k < passes_.kept().size(); ++k) {
      passes_.kept()[k].p.pdf(batch, at, theirs);
      statistics.sums.addCross(k, batch, values + done, p, theirs);
    }
  }
}

void Density::join(Density& fork) {
  if (&fork == this) fail(AWD_ERROR_INVALID_ARGUMENT, "fork is the density itself");
  // Its memory is that of its device.
  if (fork.context_.get() != context_.get()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "fork is of another device than density");
  }
  if (fork.statistics_->sums.samples > 0) {
    if (!(fork.model_ == model_) || fork.adapts_ != adapts_ ||
        !statistics_->sameSizes(*fork.statistics_)) {
      fail(AWD_ERROR_INVALID_OPERATION,
           "fork has %llu samples of another p: join a fork before either of the two changes",
           static_cast<unsigned long long>(fork.statistics_->sums.samples));
    }
    statistics_->needRoomFor(fork.statistics_->sums.samples);
  }
  Owned<DensityStatistics> fresh = freshStatistics(model_, passes_.kept().size());
  Passes passes = passes_;
  if (fork.statistics_->sums.samples > 0) statistics_->add(*fork.statistics_);
  // Nothing below can fail.
  fork.statistics_ = std::move(fresh);
  fork.passes_ = std::move(passes);
  fork.bases_ = bases_;
  fork.settings_ = settings_;
  fork.levels_ = levels_;
  fork.model_ = model_;
  fork.learned_ = learned_;
  fork.adapts_ = adapts_;
}

AWDDensityReport Density::adapt() {
  const PassSums& sums = statistics_->sums;
  const uint64_t next = std::max(settings_.passSamples, 2 * sums.samples);
  LearningReport made;
  Progress progress(*context_, "adapt", this, 1);
  LearningSettings learning = settings_.learning;
  learning.refitter.user = &progress;
  learning.refitter.progress = [](void* user, double fraction) -> int32_t {
    auto* told = static_cast<Progress*>(user);
    told->report(fraction);
    return !told->cancelled();
  };
  Model model = model_;
  Levels levels = levels_;
  bool kept = true;
  if (sums.samples > sums.rejected && model_.grid) {
    if (auto state = learnGrid(*bases_, learning, levels_, *statistics_, next, made)) {
      model = gridModel(state->levels, std::move(state->coefficients));
      levels = state->levels;
      kept = false;
    }
  } else if (sums.samples > sums.rejected) {
    if (auto state = learnTree(*bases_, learning, *model_.tree, *statistics_, next, made)) {
      model = treeModel(std::move(state->tree), std::move(state->coefficients));
      kept = false;
    }
  }
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
  report.samples = sums.samples;
  report.rejected = sums.rejected;
  report.coefficients = model.coefficients().size();
  report.kept = kept;
  if (!kept) {
    report.negative = made.negative;
    report.coarsened = made.coarsened;
    report.split = made.split;
    report.tau = made.tau;
    report.estimator = made.estimator;
    report.estimatedLevels = made.estimatedLevels;
    report.refitStatus = made.refit.status;
    report.refitIterations = made.refit.iterations;
    report.refitAtBound = made.refit.atBound;
    report.refitLambda = made.refit.lambda;
    report.refitObjective = made.refit.objective;
  }

  std::pmr::string message(made.refit.message, memory());
  Passes passes = passes_;
  passes.finish(sums, model_);
  Owned<DensityStatistics> fresh = freshStatistics(model, passes.kept().size());
  // Nothing below can fail.
  if (!kept) learned_ = report.samples;
  ++adapts_;
  passes_ = std::move(passes);
  statistics_ = std::move(fresh);
  model_ = std::move(model);
  levels_ = levels;
  refitMessage_ = std::move(message);
  report.refitMessage = refitMessage_.c_str();
  return report;
}

void Density::refine(uint32_t axis) {
  needNoSamples("refining");
  if (axis != AWD_ALL_AXES && axis >= dimensions()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "axis is %u: the density has %u, AWD_ALL_AXES are all", axis,
         dimensions());
  }
  const LearningSettings& learning = settings_.learning;
  Model model = model_;
  Levels levels = levels_;
  uint64_t size = model.coefficients().size();
  for (uint32_t a = 0; a < dimensions(); ++a) {
    if (axis != AWD_ALL_AXES && axis != a) continue;
    const uint32_t level = model.grid ? levels[a] : axisInfo(a).level;
    if (level >= learning.maxLevel[a]) {
      fail(
          AWD_ERROR_INVALID_OPERATION,
          "axis %u is at level %u, the highest that maxLevel, maxCoefficients and refitBytes allow",
          a, level);
    }
    if (model.grid) {
      Levels finer = levels;
      ++finer[a];
      size = bases_->shape(finer).size();
      if (size > learning.maxCoefficients) break;
      model = gridModel(finer, refineTo(*bases_, levels, finer, model.coefficients()));
      levels = finer;
    } else {
      size *= 2;
      if (size > learning.maxCoefficients) break;
      TreeState state = halveLeaves(*bases_, *model.tree, a);
      model = treeModel(std::move(state.tree), std::move(state.coefficients));
    }
  }
  if (size > learning.maxCoefficients) {
    fail(AWD_ERROR_INVALID_OPERATION, "%llu coefficients: maxCoefficients is %llu",
         static_cast<unsigned long long>(size),
         static_cast<unsigned long long>(learning.maxCoefficients));
  }
  become(std::move(model), levels);
}

void Density::setCoefficients(const double* coefficients, std::size_t count) {
  needNoSamples("setting coefficients");
  const std::size_t n = model_.coefficients().size();
  if (count != n) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "count is %zu: the density has %zu coefficients", count, n);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!(coefficients[i] >= 0.0) || !std::isfinite(coefficients[i])) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "coefficients[%zu] is %g: it must be finite and not negative", i, coefficients[i]);
    }
    largest = std::max(largest, coefficients[i]);
  }
  if (!(largest > 0.0)) fail(AWD_ERROR_INVALID_ARGUMENT, "coefficients are all 0");
  Coefficients given(coefficients, coefficients + n, memory());
  become(model_.grid ? gridModel(levels_, std::move(given))
                     : treeModel(model_.tree->tree(), std::move(given)),
         levels_);
  learned_ = 0;
}

}  // namespace awd
