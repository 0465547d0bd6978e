// SPDX-License-Identifier: Apache-2.0
#include "density/grid_learning.h"

#include <algorithm>
#include <cmath>

#include "density/refit_learning.h"

namespace awd {

namespace {

/// The dual is reliable from that many samples per coefficient on.
constexpr double kSamplesForDual = 16.0;
/// Estimators without cascade refine when the finer level will get that many a coefficient.
constexpr uint64_t kSamplesForFiner = 8;

/// One rung up: every axis that may be refined.
bool finer(const LearningSettings& settings, uint32_t dimensions, Levels& levels) {
  bool any = false;
  for (uint32_t a = 0; a < dimensions; ++a) {
    if (levels[a] >= settings.maxLevel[a]) continue;
    ++levels[a];
    any = true;
  }
  return any;
}

/// One rung down.
bool coarser(const DensityBases& bases, Levels& levels) {
  bool any = false;
  for (uint32_t a = 0; a < bases.dimensions(); ++a) {
    if (levels[a] <= bases.family(a).minLevel()) continue;
    --levels[a];
    any = true;
  }
  return any;
}

double meanOf(const DensityBases& bases, const Levels& levels, const Coefficients& coefficients) {
  const BasisLevel* tables[kMaxDimensions];
  bases.tables(levels, tables);
  Coefficients positive(coefficients, coefficients.get_allocator());
  for (double& c : positive) c = std::max(c, 0.0);
  return integral(tables, bases.shape(levels), positive.data());
}

/// r of every rung, from the coarsest up, each shrunk towards the one before.
class Cascade {
 public:
  Cascade(const DensityBases& bases, const LearningSettings& settings)
      : bases_(bases), settings_(settings) {}

  /// The rungs of `sums`, which belong to `levels`, up to the finest that m samples bear. `levels`
  /// becomes that of the result.
  Coefficients run(const LevelSums& sums, double samples, Levels& levels, uint32_t& rungs) {
    Levels below = levels;
    const bool bears =
        static_cast<double>(sums.shape.size()) <= static_cast<double>(bearable(1)) * samples;
    if (!coarser(bases_, below)) {
      rungs = 1;
      return shrunk(sums, levels, nullptr);
    }
    LevelSums coarse = sums;
    for (uint32_t a = 0; a < bases_.dimensions(); ++a) {
      if (below[a] != levels[a]) coarse.restrict(bases_.family(a).level(below[a]), a);
    }
    Levels reached = below;
    Coefficients prior = run(coarse, samples, reached, rungs);
    if (!bears) {
      levels = reached;
      return prior;
    }
    ++rungs;
    const Coefficients refined = refineTo(bases_, reached, levels, prior);
    return shrunk(sums, levels, &refined);
  }

 private:
  /// (n_j r_j + kappa prior_j) / (n_j + kappa); without prior the mean of all samples.
  Coefficients shrunk(const LevelSums& sums, const Levels& levels, const Coefficients* prior) {
    const BasisLevel* tables[kMaxDimensions];
    bases_.tables(levels, tables);
    Coefficients r = localMeans(tables, sums, AWD_ESTIMATOR_QUASI, settings_.target);
    double value = 0.0, weight = 0.0;
    for (std::size_t i = 0; i < r.size(); ++i) {
      value += sums.value[i];
      weight += sums.weight[i];
    }
    double mean = weight > 0.0 ? value / weight : 0.0;
    if (settings_.target == AWD_TARGET_RMS) mean = std::sqrt(mean);
    for (std::size_t i = 0; i < r.size(); ++i) {
      const double towards = prior ? (*prior)[i] : mean;
      const double n = sums.weight[i] > 0.0 ? sums.count[i] : 0.0;
      const double kappa = settings_.shrinkage;
      r[i] = n + kappa > 0.0 ? (n * r[i] + kappa * towards) / (n + kappa) : towards;
    }
    return r;
  }

  const DensityBases& bases_;
  const LearningSettings& settings_;
};

/// The refit on the level that was recorded, pulled towards the cascade.
Coefficients refitGrid(const DensityBases& bases, const LearningSettings& settings,
                       const Levels& levels, const LevelSums& sums,
                       const DensityStatistics& statistics, LearningReport& report) {
  const auto samples = static_cast<double>(statistics.sums.samples);
  Levels reached = levels;
  Coefficients c = Cascade(bases, settings).run(sums, samples, reached, report.estimatedLevels);
  c = refineTo(bases, reached, levels, c);
  const BasisLevel* tables[kMaxDimensions];
  bases.tables(levels, tables);
  Coefficients weights(c.size(), 1.0, c.get_allocator());
  timesWeights(tables, sums.shape, weights);
  NormalEquations equations(c.get_allocator().resource());
  equations.takeMatrix(*statistics.normal.pattern, statistics.normal.products, sums.weightExponent);
  equations.rhs = sums.value;
  equations.energy = statistics.normal.energy.plain(2 * sums.valueExponent - sums.weightExponent);
  refitFromCascade(settings, !bases.constant(), samples, equations, weights, c, report.refit);
  return c;
}

}  // namespace

Coefficients refineTo(const DensityBases& bases, Levels from, const Levels& to,
                      const Coefficients& coefficients) {
  Shape shape = bases.shape(from);
  Coefficients out(coefficients, coefficients.get_allocator());
  for (uint32_t a = 0; a < bases.dimensions(); ++a) {
    for (; from[a] < to[a]; ++from[a]) {
      const Family& family = bases.family(a);
      out = refineAlong(family.level(from[a]), family.level(from[a] + 1), a, shape, out);
    }
  }
  return out;
}

Levels levelsFor(const DensityBases& bases, const LearningSettings& settings, Levels levels,
                 uint64_t samples) {
  const uint64_t most = std::min(bearable(samples), settings.maxCoefficients);
  for (uint32_t a = 0; a < bases.dimensions(); ++a) {
    levels[a] = std::max(levels[a], settings.minLevel[a]);
  }
  for (Levels next = levels; finer(settings, bases.dimensions(), next);) {
    if (bases.shape(next).size() > most) break;
    levels = next;
  }
  return levels;
}

std::optional<GridState> learnGrid(const DensityBases& bases, const LearningSettings& settings,
                                   const Levels& levels, const DensityStatistics& statistics,
                                   uint64_t nextSamples, LearningReport& report) {
  const auto samples = static_cast<double>(statistics.sums.samples);
  std::pmr::memory_resource* memory = statistics.tallies.get_allocator().resource();
  const LevelSums sums(memory, bases.shape(levels), statistics.tallies);
  const auto n = static_cast<double>(sums.shape.size());

  report.estimator = settings.estimator;
  if (settings.estimator == AWD_ESTIMATOR_DEFAULT) {
    Levels next = levels;
    const bool capped = !finer(settings, bases.dimensions(), next) ||
                        bases.shape(next).size() > settings.maxCoefficients;
    report.estimator =
        capped && samples >= kSamplesForDual * n ? AWD_ESTIMATOR_RATIO : AWD_ESTIMATOR_QUASI;
  }

  GridState state = {levels, Coefficients(memory)};
  Levels next;
  if (report.estimator == AWD_ESTIMATOR_QUASI) {
    if (settings.shrinkage > 0.0) {
      Cascade cascade(bases, settings);
      state.coefficients = cascade.run(sums, samples, state.levels, report.estimatedLevels);
    } else {
      const BasisLevel* tables[kMaxDimensions];
      bases.tables(levels, tables);
      state.coefficients = localMeans(tables, sums, report.estimator, settings.target);
      report.estimatedLevels = 1;
    }
    next = levelsFor(bases, settings, state.levels, nextSamples);
  } else if (report.estimator == AWD_ESTIMATOR_REFIT) {
    state.coefficients = refitGrid(bases, settings, levels, sums, statistics, report);
    next = levelsFor(bases, settings, levels, nextSamples);
  } else {
    const BasisLevel* tables[kMaxDimensions];
    bases.tables(levels, tables);
    state.coefficients = localMeans(tables, sums, report.estimator, settings.target);
    project(bases, levels, sums.shape, state.coefficients);
    report.estimatedLevels = 1;
    next = levels;
    Levels above = levels;
    if (finer(settings, bases.dimensions(), above) &&
        bases.shape(above).size() <=
            std::min(nextSamples / kSamplesForFiner, settings.maxCoefficients)) {
      next = above;
    }
  }

  const double mean = meanOf(bases, state.levels, state.coefficients);
  if (!(mean > 0.0) || !std::isfinite(mean)) return std::nullopt;
  report.tau = settleTau(settings.tau, report.estimator, !bases.constant(),
                         shrinks(report.estimator) && settings.shrinkage > 0.0, samples,
                         static_cast<double>(state.coefficients.size()));
  report.negative = clampCoefficients(report.tau, mean, state.coefficients);
  state.coefficients = refineTo(bases, state.levels, next, state.coefficients);
  state.levels = next;
  return state;
}

}  // namespace awd
