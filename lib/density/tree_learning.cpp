// SPDX-License-Identifier: Apache-2.0
#include "density/tree_learning.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "density/energy.h"
#include "density/estimators.h"
#include "density/leaf_sampler.h"
#include "density/refit_learning.h"
#include "density/tree_matrices.h"
#include "density/tree_sums.h"

namespace awd {

namespace {

/// No more boxes than give each coefficient that many samples of the next pass.
constexpr uint64_t kSamplesPerCoefficient = 2;
/// Boxes are halved until what is left to gain is this share of the integral.
constexpr double kGainWorthAnything = 1e-3;

/// A box of the tree that is being made, on its way to being a leaf.
struct Box {
  uint32_t node = 0;  ///< in the new tree
  uint32_t depth[kMaxDimensions] = {};
  double potential = 0.0;  ///< volume (rms - what the density does already)
  /// What halving along each axis would gain of it, and the lower half's share of the rest.
  double gain[kMaxDimensions] = {};
  double lowerShare[kMaxDimensions] = {};
  std::size_t coefficients = 0;  ///< where in the learner's pool
};

/// The dual of a leaf, in place: from local means r_j to c with G c = b, b_j = w_j r_j.
void projectLeaf(const DensityBases& bases, const Shape& shape, double* means) {
  Coefficients c(means, means + shape.size(), bases.memory());
  project(bases, Levels{}, shape, c);
  std::copy(c.begin(), c.end(), means);
}

/// Order of halving: by potential, ties by age so that nothing depends on a heap's whims.
struct LessUrgent {
  bool operator()(const Box& a, const Box& b) const {
    return a.potential != b.potential ? a.potential < b.potential : a.node > b.node;
  }
};

class TreeLearner {
 public:
  TreeLearner(const DensityBases& bases, const LearningSettings& settings,
              const TreeDensity& density, const DensityStatistics& statistics)
      : bases_(bases),
        settings_(settings),
        old_(density),
        nodes_(density.tree().nodes()),
        shape_(density.leafShape()),
        size_(shape_.size()),
        samples_(static_cast<double>(statistics.sums.samples)),
        statistics_(statistics),
        sums_(bases, density, statistics),
        memory_(statistics.tallies.get_allocator().resource()),
        scratch_(3 * size_, 0.0, memory_),
        pool_(memory_),
        merged_(nodes_.size(), false, memory_),
        tree_(memory_, shape_.dimensions),
        open_(memory_),
        closed_(memory_) {}

  std::optional<TreeState> run(uint64_t nextSamples, LearningReport& report);

 private:
  /// r_j of a node as if it were a leaf, into `out`; its square if the target is RMS.
  void estimate(uint32_t node, double volume, double* out) const;
  /// Coefficients of the halves of a box, appended to the pool.
  std::pair<std::size_t, std::size_t> split(std::size_t coefficients, uint32_t axis);
  void dropNoise(double least);
  /// Whether halving a node has not brought the density closer to what it could be.
  static bool gainedNothing(double whole, double halves) { return halves >= 0.9 * whole; }
  bool isNoise(uint32_t node, const TreeBox& box) const;
  double potential(uint32_t node, double volume) const;
  /// Copies the old tree down to its merged nodes, with shrunk estimates.
  void descend(uint32_t oldNode, const Box& box, const TreeBox& place);
  void close(Box box, uint32_t oldNode, const TreeBox& place);
  /// Refits the boxes that descend() came to, whose coefficients are the prior.
  void refitBoxes(LearningReport& report);
  /// Returns the potential of both halves.
  double halve(const Box& box, uint32_t axis);
  uint32_t bestAxis(const Box& box) const;

  const DensityBases& bases_;
  const LearningSettings& settings_;
  const TreeDensity& old_;
  const std::pmr::vector<TreeNode>& nodes_;
  const Shape shape_;
  const std::size_t size_;
  const double samples_;
  const DensityStatistics& statistics_;
  const TreeSums sums_;
  std::pmr::memory_resource* memory_;
  mutable Coefficients scratch_;       ///< three boxes' worth
  Coefficients pool_;                  ///< coefficients of boxes, size_ each
  std::pmr::vector<bool> merged_;      ///< per old node: becomes a leaf
  Tree tree_;                          ///< the new one
  std::pmr::vector<Box> open_;         ///< its leaves; a heap by potential while halving
  std::pmr::vector<uint32_t> closed_;  ///< the old nodes of the boxes that descend() came to
};

void TreeLearner::estimate(uint32_t node, double volume, double* out) const {
  const BasisLevel* const* levels = old_.levels();
  for (std::size_t j = 0; j < size_; ++j) {
    double divisor = sums_.weights(node)[j];
    if (settings_.estimator == AWD_ESTIMATOR_MIXTURE) {
      divisor = samples_ * volume;
      for (uint32_t a = 0; a < shape_.dimensions; ++a) {
        divisor *= levels[a]->weights[j / shape_.stride(a) % shape_.count[a]];
      }
    }
    // Where no sample fell the box's mean is the best that is known.
    out[j] = divisor > 0.0 ? sums_.values(node)[j] / divisor : sums_.whole(node).mean();
  }
}

std::pair<std::size_t, std::size_t> TreeLearner::split(std::size_t coefficients, uint32_t axis) {
  const std::size_t lower = pool_.size();
  pool_.resize(lower + 2 * size_);
  const uint32_t n = shape_.count[axis];
  const std::size_t stride = shape_.stride(axis);
  shape_.forEachFibre(axis, [&](std::size_t outer, std::size_t inner) {
    const std::size_t fibre = outer * n * stride + inner;
    bases_.axis(axis).filter->split(&pool_[coefficients + fibre], stride, &pool_[lower + fibre],
                                    &pool_[lower + size_ + fibre]);
  });
  return {lower, lower + size_};
}

double TreeLearner::potential(uint32_t node, double volume) const {
  // Samples spread over the box by sqrt(E[f^2]) would have the error volume * rms; what the
  // density's own shape achieves is volume * mean for a constant, more for more coefficients.
  const BoxSums all = sums_.whole(node);
  if (size_ == 1) return volume * all.spread();
  double* c = scratch_.data();
  estimate(node, volume, c);
  const double energy = std::min(boxEnergy(bases_, shape_, c), all.meanSquare());
  return volume * (all.rms() - std::sqrt(energy));
}

bool TreeLearner::isNoise(uint32_t node, const TreeBox& box) const {
  const TreeNode& parent = nodes_[node];
  double* const c[2] = {scratch_.data(), scratch_.data() + size_};
  double noise = 0.0;
  for (uint32_t half = 0; half < 2; ++half) {
    const uint32_t child = parent.child + half;
    const double n = sums_.count(child);
    if (!(n > 1.0)) return true;
    const BoxSums all = sums_.whole(child);
    estimate(child, 0.5 * box.volume(shape_.dimensions), c[half]);
    // The squared error of a half's estimate spreads over its size_ coefficients; half of that of
    // both halves goes into the details.
    const double variance = std::max(all.meanSquare() - all.mean() * all.mean(), 0.0);
    noise += 0.25 * variance * static_cast<double>(size_) / n;
  }
  const WaveletFilter& filter = *bases_.axis(parent.axis).filter;
  const std::size_t stride = shape_.stride(parent.axis);
  double energy = 0.0;
  std::size_t fibres = 0;
  shape_.forEachFibre(parent.axis, [&](std::size_t outer, std::size_t inner) {
    const std::size_t fibre = outer * shape_.count[parent.axis] * stride + inner;
    filter.analyse(c[0] + fibre, c[1] + fibre, stride, c[0] + fibre, c[1] + fibre);
    energy += filter.detailEnergy(c[1] + fibre, stride);
    ++fibres;
  });
  // What rounding alone makes of a constant is noise too.
  const double rounding = 1e-24 * sums_.whole(node).meanSquare();
  return energy <= (noise + rounding) * static_cast<double>(fibres);
}

void TreeLearner::dropNoise(double least) {
  // Bottom up, a node whose halves are leaves becomes one if the details between them are no more
  // than noise, and if either there is next to nothing to gain in it, or halving it gained nothing:
  // then what is left is noise of f itself, which no box explains.
  std::pmr::vector<double> potentials(nodes_.size(), 0.0, memory_);
  std::pmr::vector<TreeBox> boxes(nodes_.size(), memory_);
  old_.tree().walk([&](uint32_t node, const TreeBox& box) {
    potentials[node] = potential(node, box.volume(shape_.dimensions));
    boxes[node] = box;
  });
  const auto leaf = [&](uint32_t node) { return nodes_[node].leaf() || merged_[node]; };
  for (auto node = static_cast<uint32_t>(nodes_.size()); node-- > 0;) {
    if (nodes_[node].leaf()) continue;
    const uint32_t child = nodes_[node].child;
    if (!leaf(child) || !leaf(child + 1)) continue;
    const bool useless = gainedNothing(potentials[node], potentials[child] + potentials[child + 1]);
    if (potentials[node] > least && !useless) continue;
    const uint32_t axis = nodes_[node].axis;
    if (boxes[node].depth[axis] < settings_.minLevel[axis]) continue;
    if (isNoise(node, boxes[node])) merged_[node] = true;
  }
}

void TreeLearner::close(Box box, uint32_t oldNode, const TreeBox& place) {
  const double volume = place.volume(shape_.dimensions);
  box.potential = potential(oldNode, volume);
  if (!shrinks(settings_.estimator)) {
    projectLeaf(bases_, shape_, &pool_[box.coefficients]);
  }
  const BoxSums all = sums_.whole(oldNode);
  for (uint32_t a = 0; a < shape_.dimensions; ++a) {
    box.depth[a] = place.depth[a];
    const BoxSums lower = sums_.lower(oldNode, a);
    const BoxSums upper = {all.weight - lower.weight, std::max(all.value - lower.value, 0.0),
                           std::max(all.square - lower.square, 0.0)};
    const double halves = 0.5 * (lower.rms() + upper.rms());
    box.gain[a] = volume * std::max(all.rms() - halves, 0.0);
    const double rest = lower.spread() + upper.spread();
    box.lowerShare[a] = rest > 0.0 ? lower.spread() / rest : 0.5;
  }
  open_.push_back(box);
  closed_.push_back(oldNode);
}

void TreeLearner::descend(uint32_t oldNode, const Box& box, const TreeBox& place) {
  // (n_j r_j + kappa prior_j) / (n_j + kappa); the prior is in the pool already.
  double* r = scratch_.data();
  estimate(oldNode, place.volume(shape_.dimensions), r);
  for (std::size_t j = 0; j < size_; ++j) {
    if (settings_.target == AWD_TARGET_RMS) r[j] = std::sqrt(r[j]);
    double& c = pool_[box.coefficients + j];
    const double n = sums_.weights(oldNode)[j] > 0.0 ? sums_.counts(oldNode)[j] : 0.0;
    const double kappa = shrinks(settings_.estimator) ? settings_.shrinkage : 0.0;
    c = n + kappa > 0.0 ? (n * r[j] + kappa * c) / (n + kappa) : c;
  }
  if (nodes_[oldNode].leaf() || merged_[oldNode]) {
    close(box, oldNode, place);
    return;
  }
  const uint32_t axis = nodes_[oldNode].axis;
  const auto [lower, upper] = split(box.coefficients, axis);
  tree_.split(box.node, axis);
  const uint32_t child = tree_.nodes()[box.node].child;
  for (uint32_t half = 0; half < 2; ++half) {
    Box next;
    next.node = child + half;
    next.coefficients = half ? upper : lower;
    descend(nodes_[oldNode].child + half, next, place.half(axis, half));
  }
}

void TreeLearner::refitBoxes(LearningReport& report) {
  const std::size_t n = open_.size() * size_;
  const TreeMatrices matrices(bases_, old_, statistics_.normal, sums_.weightExponent());
  NormalEquations equations(memory_);
  Coefficients c(n, 0.0, memory_), weights(n, 1.0, memory_), block(memory_);
  for (std::size_t i = 0; i < open_.size(); ++i) {
    const Box& box = open_[i];
    double volume = 1.0;
    for (uint32_t a = 0; a < shape_.dimensions; ++a) {
      volume = std::ldexp(volume, -static_cast<int>(box.depth[a]));
    }
    matrices.of(closed_[i], block);
    equations.appendBlock(block.data(), size_);
    const double* values = sums_.values(closed_[i]);
    equations.rhs.insert(equations.rhs.end(), values, values + size_);
    for (std::size_t j = 0; j < size_; ++j) {
      double& weight = weights[i * size_ + j];
      weight = volume;
      for (uint32_t a = 0; a < shape_.dimensions; ++a) {
        weight *= old_.levels()[a]->weights[j / shape_.stride(a) % shape_.count[a]];
      }
      c[i * size_ + j] = pool_[box.coefficients + j];
    }
  }
  equations.energy =
      statistics_.normal.energy.plain(2 * sums_.valueExponent() - sums_.weightExponent());
  refitFromCascade(settings_, !bases_.constant(), samples_, equations, weights, c, report.refit);
  for (std::size_t i = 0; i < n; ++i) pool_[open_[i / size_].coefficients + i % size_] = c[i];
}

uint32_t TreeLearner::bestAxis(const Box& box) const {
  // Where no axis promises anything, as between symmetric halves, the longest side.
  uint32_t best = TreeNode::kLeaf;
  const double worthwhile = 1e-2 * box.potential;
  for (uint32_t a = 0; a < shape_.dimensions; ++a) {
    if (box.depth[a] >= settings_.maxLevel[a]) continue;
    if (best == TreeNode::kLeaf) {
      best = a;
      continue;
    }
    const double gain = box.gain[a] > worthwhile ? box.gain[a] : 0.0;
    const double most = box.gain[best] > worthwhile ? box.gain[best] : 0.0;
    if (gain > most || (gain == most && box.depth[a] < box.depth[best])) best = a;
  }
  return best;
}

double TreeLearner::halve(const Box& box, uint32_t axis) {
  double left = 0.0;
  const auto [lower, upper] = split(box.coefficients, axis);
  tree_.split(box.node, axis);
  const uint32_t child = tree_.nodes()[box.node].child;
  for (uint32_t half = 0; half < 2; ++half) {
    // Of a half of a box that was sampled no more is known than its share; of halves of halves
    // nothing but what was known of the whole.
    Box next = box;
    const double share = half ? 1.0 - box.lowerShare[axis] : box.lowerShare[axis];
    next.node = child + half;
    next.coefficients = half ? upper : lower;
    next.potential = share * std::max(box.potential - box.gain[axis], 0.25 * box.potential);
    ++next.depth[axis];
    for (uint32_t a = 0; a < shape_.dimensions; ++a) {
      next.gain[a] *= a == axis ? 0.5 * share : share;
      next.lowerShare[a] = 0.5;
    }
    left += next.potential;
    open_.push_back(next);
    std::push_heap(open_.begin(), open_.end(), LessUrgent{});
  }
  return left;
}

std::optional<TreeState> TreeLearner::run(uint64_t nextSamples, LearningReport& report) {
  const BoxSums all = sums_.whole(0);
  double mean = all.mean();
  if (!(mean > 0.0) || !std::isfinite(mean)) return std::nullopt;
  if (settings_.target == AWD_TARGET_RMS) mean = std::sqrt(mean);
  report.estimator = settings_.estimator;
  report.estimatedLevels = 1;

  const double worthwhile = kGainWorthAnything * all.mean();
  const uint64_t budget = std::max<uint64_t>(
      std::min(nextSamples / kSamplesPerCoefficient, settings_.maxCoefficients) / size_, 1);
  dropNoise(worthwhile / static_cast<double>(old_.tree().leaves()));

  pool_.assign(size_, mean);
  descend(0, Box{}, TreeBox{});
  if (settings_.estimator == AWD_ESTIMATOR_REFIT) refitBoxes(report);
  const std::size_t kept = open_.size();
  report.coarsened = (old_.tree().leaves() - kept) * size_;

  std::make_heap(open_.begin(), open_.end(), LessUrgent{});
  double left = 0.0;
  for (const Box& box : open_) left += box.potential;
  std::pmr::vector<Box> done(memory_);
  while (!open_.empty() && open_.size() + done.size() < budget && left > worthwhile) {
    std::pop_heap(open_.begin(), open_.end(), LessUrgent{});
    const Box box = open_.back();
    open_.pop_back();
    const uint32_t axis = bestAxis(box);
    if (axis == TreeNode::kLeaf || !(box.potential > 0.0)) {
      done.push_back(box);
      left -= box.potential;
      continue;
    }
    left += halve(box, axis) - box.potential;
    ++report.split;
  }
  open_.insert(open_.end(), done.begin(), done.end());

  // Leaves in the order of the tree.
  TreeState state = {std::move(tree_), Coefficients(open_.size() * size_, 0.0, memory_)};
  state.tree.finish();
  double whole = 0.0;
  for (const Box& box : open_) {
    const std::size_t leaf = state.tree.nodes()[box.node].child;
    double* c = &state.coefficients[leaf * size_];
    std::copy_n(&pool_[box.coefficients], size_, c);
  }
  state.tree.walk([&](uint32_t node, const TreeBox& box) {
    const TreeNode& leaf = state.tree.nodes()[node];
    if (!leaf.leaf()) return;
    for (std::size_t j = 0; j < size_; ++j) {
      scratch_[j] = std::max(state.coefficients[leaf.child * size_ + j], 0.0);
    }
    whole += box.volume(shape_.dimensions) * integral(old_.levels(), shape_, scratch_.data());
  });
  if (!(whole > 0.0) || !std::isfinite(whole)) return std::nullopt;
  report.tau = settleTau(settings_.tau, report.estimator, !bases_.constant(),
                         shrinks(report.estimator) && settings_.shrinkage > 0.0, samples_,
                         static_cast<double>(state.coefficients.size()));
  report.negative = clampCoefficients(report.tau, whole, state.coefficients);
  return state;
}

}  // namespace

std::optional<TreeState> learnTree(const DensityBases& bases, const LearningSettings& settings,
                                   const TreeDensity& density, const DensityStatistics& statistics,
                                   uint64_t nextSamples, LearningReport& report) {
  LearningSettings settled = settings;
  if (settled.estimator == AWD_ESTIMATOR_DEFAULT) settled.estimator = AWD_ESTIMATOR_QUASI;
  return TreeLearner(bases, settled, density, statistics).run(nextSamples, report);
}

}  // namespace awd
