// SPDX-License-Identifier: Apache-2.0
#include "guide/patch_learning.h"

#include <cmath>
#include <optional>

#include "density/grid_learning.h"
#include "density/projection.h"
#include "util/error.h"

namespace awd {

namespace {

/// That the sums of refit may take in a patch.
constexpr std::size_t kMostRefitBytes = std::size_t{1} << 28;
/// A patch is refined only when the finer level would have had this many samples a coefficient:
/// below that its noise costs more than its detail brings.
constexpr double kSamplesPerCoefficient = 8.0;
/// Nor, from 8 x 8 cells on, unless the mean of its square is as large as this times the square of
/// its mean: where light comes evenly, a finer level has nothing to tell.
constexpr double kContrast = 2.0;
constexpr uint32_t kTellingLevel = 3;
/// Share of a density from there on that is spread over neighbours: at the edge of a small light a
/// function may have met nothing of what it covers, and what comes then weighs too much.
constexpr double kSpread = 0.5;
/// What the constant counts for beside a patch's own samples.
constexpr double kPriorSamples = 32.0;

/// Replaces each of n x n nodal values by itself and, to a share of kSpread, the mean of it and its
/// neighbours with weights 1, 2, 1 along each axis.
void spread(std::size_t n, Coefficients& c) {
  Coefficients blurred(c, c.get_allocator());
  for (const std::size_t stride : {std::size_t{1}, n}) {
    const Coefficients from(blurred, c.get_allocator());
    for (std::size_t i = 0; i < c.size(); ++i) {
      const std::size_t at = i / stride % n;
      const double below = from[at > 0 ? i - stride : i];
      const double above = from[at + 1 < n ? i + stride : i];
      blurred[i] = 0.25 * (below + 2.0 * from[i] + above);
    }
  }
  for (std::size_t i = 0; i < c.size(); ++i) c[i] += kSpread * (blurred[i] - c[i]);
}

}  // namespace

PatchLearning::PatchLearning(std::pmr::memory_resource* memory, const FieldSettings& settings,
                             Ref<DensityBases> bases)
    : memory_(memory), settings_(settings), bases_(std::move(bases)), patterns_(memory) {
  if (settings.learning.estimator != AWD_ESTIMATOR_REFIT) return;
  for (uint32_t l = settings.startLevel; l <= settings.maxLevel; ++l) {
    const BasisLevel* const levels[] = {&family().level(l), &family().level(l)};
    patterns_.push_back(NormalPattern::make(memory, levels, 2));
    const std::size_t bytes = patterns_.back()->size() * sizeof(int64_t);
    if (bytes > kMostRefitBytes) {
      fail(AWD_ERROR_INVALID_ARGUMENT,
           "desc->maxLevel is level %u: at level %u the estimator refit would sum %zu bytes a "
           "patch, at most %zu are allowed",
           settings.maxLevel, l, bytes, kMostRefitBytes);
    }
  }
}

Owned<PatchStatistics> PatchLearning::freshStatistics(const BasisLevel& level,
                                                      PatchUnits units) const {
  Ref<NormalPattern> pattern;
  if (!patterns_.empty()) pattern = patterns_[level.level - settings_.startLevel];
  return makeOwned<PatchStatistics>(memory_, memory_, level, settings_.learning.estimator,
                                    settings_.target, std::move(pattern),
                                    lights() ? lights()->lights() : 0, units);
}

bool PatchLearning::finerIsDue(uint32_t level, double samples, const Coefficients& c) const {
  if (level >= settings_.maxLevel) return false;
  if (settings_.preset == AWD_PRESET_PAPER) return true;
  const double n = family().level(level + 1).count;
  if (samples < kSamplesPerCoefficient * n * n) return false;
  if (level < kTellingLevel) return true;
  double sum = 0.0;
  double squares = 0.0;
  for (const double value : c) {
    sum += value;
    squares += value * value;
  }
  return squares * static_cast<double>(c.size()) >= kContrast * sum * sum;
}

Coefficients PatchLearning::lumped(const SquareValues& values, const BasisLevel& level,
                                   double samples) const {
  Coefficients c(values.components(), memory_);
  for (std::size_t j = 0; j < c.size(); ++j) c[j] = values.sum(j) / samples;
  const BasisLevel* const levels[] = {&level, &level};
  overWeights(levels, shapeOf(levels, 2), c);
  return c;
}

Coefficients PatchLearning::estimate(const PatchStatistics& statistics, const BasisLevel& level,
                                     const Refitter& refitter, RefitReport& report) const {
  if (const SquareStatistics* byComponent = statistics.byComponent()) {
    Coefficients c = project(memory_, level, bases_->axis(0).gram(level.level), *byComponent);
    if (!clampCoefficients(level, settings_.learning.tau, c)) c.clear();
    return c;
  }
  const auto samples = static_cast<double>(statistics.samples());
  if (const SquareValues* values = statistics.values()) return lumped(*values, level, samples);
  const Levels levels = {level.level, level.level};
  LearningSettings learning = settings_.learning;
  learning.minLevel = learning.maxLevel = levels;
  learning.refitter = refitter;
  LearningReport made;
  std::optional<GridState> state = learnGrid(
      *bases_, learning, levels, statistics.byFunction()->statistics(), statistics.samples(), made);
  report = std::move(made.refit);
  return state ? std::move(state->coefficients) : Coefficients(memory_);
}

double PatchLearning::alphaFor(double samples) const {
  if (!settings_.pools()) return settings_.alpha;
  return settings_.alpha + (1.0 - settings_.alpha) * kPriorSamples / (samples + kPriorSamples);
}

void PatchLearning::pool(const PatchKnowledge& known, double samples,
                         Coefficients& coefficients) const {
  // The former estimate: the density without the constant in it, times the integral.
  const double share = known.weight / (known.weight + samples);
  const double whole = learnsSquares() ? known.root : known.mean;
  const double scale = known.density && known.alpha < 1.0 ? whole / (1.0 - known.alpha) : 0.0;
  for (std::size_t j = 0; j < coefficients.size(); ++j) {
    coefficients[j] *= 1.0 - share;
    if (scale > 0.0) {
      const double above = std::max(known.density->coefficients()[j] - known.alpha, 0.0);
      const double before = scale * above;
      coefficients[j] += share * (learnsSquares() ? before * before : before);
    }
  }
}

PatchKnowledge PatchLearning::learn(const PatchKnowledge& known, const BasisLevel& level,
                                    const PatchStatistics& statistics, bool mayRefine,
                                    const Refitter& refitter, RefitReport& report) const {
  PatchKnowledge next = known;
  const auto eighths = statistics.eighths();
  for (std::size_t i = 0; i < eighths.size(); ++i) next.eighths[i] += eighths[i];
  if (const LightSums& found = statistics.lights(); found.samples() > 0 && !found.overflowed()) {
    next.lights = lights(known)->learn(*lights(), found, known.lightShare);
    next.lightShare = 1.0;
  }
  const auto samples = static_cast<double>(statistics.samples());
  if (samples == 0.0 || statistics.common().overflowed()) return next;
  // All that came was lost by rounding: the next pass, whose unit is of its magnitude, will know
  // better, and must not take it for the dark.
  if (statistics.isBelowUnit()) return next;
  next.weight = known.weight + samples;
  next.mean = (known.mean * known.weight + statistics.mean() * samples) / next.weight;

  if (!(statistics.mean() > 0.0)) {
    // Of the squares' mean as much is left.
    next.root = known.root * std::sqrt(known.weight / next.weight);
    return next;
  }
  Coefficients c = estimate(statistics, level, refitter, report);
  if (c.empty()) return next;
  if (learnsSquares()) {
    for (double& value : c) value *= statistics.squaresUnit();
  }
  if (settings_.pools()) pool(known, samples, c);
  if (learnsSquares()) {
    for (double& value : c) value = std::sqrt(std::max(value, 0.0));
    const BasisLevel* const levels[] = {&level, &level};
    next.root = integral(levels, shapeOf(levels, 2), c.data());
  }
  if (settings_.pools() && settings_.learning.tau > 0.0) {
    awd::clampCoefficients(settings_.learning.tau, learnsSquares() ? next.root : next.mean, c);
  }
  if (settings_.pools() && level.level > kTellingLevel && NodalSquare::fits(level)) {
    spread(level.count, c);
  }
  uint32_t l = level.level;
  if (mayRefine && finerIsDue(l, next.weight, c)) {
    c = refineTo(*bases_, {l, l}, {l + 1, l + 1}, c);
    ++l;
  }
  const BasisLevel& made = family().level(l);
  const BasisLevel* const levels[] = {&made, &made};
  const double whole = integral(levels, shapeOf(levels, 2), c.data());
  if (!(whole > 0.0) || !std::isfinite(whole)) return next;
  next.alpha = alphaFor(next.weight);
  if (next.alpha > 0.0) {
    for (double& value : c) value = next.alpha + (1.0 - next.alpha) * (value / whole);
  }
  next.density = SquareDensity::make(made, settings_.sampler(), std::move(c));
  return next;
}

std::size_t PatchLearning::bytesToRefine(const BasisLevel& level) const {
  if (level.level >= settings_.maxLevel) return 0;
  const auto bytesOf = [&](const BasisLevel& on) {
    const Coefficients constant(std::size_t{on.count} * on.count, 1.0, memory_);
    return freshStatistics(on, PatchUnits::of(1.0))->bytes() +
           SquareDensity::make(on, settings_.sampler(), constant)->bytes();
  };
  return bytesOf(family().level(level.level + 1)) - bytesOf(level);
}

std::size_t PatchLearning::bytes() const {
  std::size_t bytes = 0;
  for (const Ref<NormalPattern>& pattern : patterns_) bytes += pattern->bytes();
  return bytes;
}

}  // namespace awd
