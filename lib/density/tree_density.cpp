// SPDX-License-Identifier: Apache-2.0
#include "density/tree_density.h"

#include <algorithm>
#include <cmath>

#include "density/leaf_sampler.h"
#include "density/point.h"

namespace awd {

Ref<TreeDensity> TreeDensity::make(std::pmr::memory_resource* memory,
                                   const BasisLevel* const* levels, Tree tree,
                                   Coefficients coefficients, Scale scale) {
  return Ref<TreeDensity>::adopt(awd::make<TreeDensity>(memory, memory, levels, std::move(tree),
                                                        std::move(coefficients), scale));
}

TreeDensity::TreeDensity(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                         Tree tree, Coefficients coefficients, Scale scale)
    : shape_(shapeOf(levels, tree.dimensions())),
      leafSize_(shape_.size()),
      tree_(std::move(tree)),
      coefficients_(std::move(coefficients)),
      left_(tree_.nodes().size(), 0.0, memory) {
  std::copy(levels, levels + shape_.dimensions, levels_);
  for (uint32_t a = 0; a < shape_.dimensions; ++a) strides_[a] = shape_.stride(a);
  if (scale == Scale::toIntegral) {
    // By the largest first, so that neither sum nor quotient leaves the range of a double.
    const double largest = *std::max_element(coefficients_.begin(), coefficients_.end());
    for (double& c : coefficients_) c /= largest;
  }
  Coefficients masses(tree_.nodes().size(), 0.0, memory);
  weigh(masses);
  if (scale == Scale::toIntegral) {
    for (double& c : coefficients_) c /= masses[0];
    weigh(masses);
  }
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const TreeNode& node = tree_.nodes()[i];
    if (!node.leaf() && masses[i] > 0.0) left_[i] = masses[node.child] / masses[i];
  }
}

void TreeDensity::destroy() noexcept {
  std::pmr::memory_resource* memory = coefficients_.get_allocator().resource();
  unmake(memory, this);
}

void TreeDensity::weigh(Coefficients& masses) const {
  tree_.walk([&](uint32_t i, const TreeBox& box) {
    const TreeNode& node = tree_.nodes()[i];
    if (!node.leaf()) return;
    masses[i] = box.volume(shape_.dimensions) *
                integral(levels_, shape_, &coefficients_[node.child * leafSize_]);
  });
  for (std::size_t i = masses.size(); i-- > 0;) {
    const TreeNode& node = tree_.nodes()[i];
    if (!node.leaf()) masses[i] = masses[node.child] + masses[node.child + 1];
  }
}

void TreeDensity::pdf(std::size_t count, const double* points, double* pdfs) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    AxisValues at[d];
    double t[d];
    for (std::size_t i = 0; i < count; ++i, points += d) {
      std::copy(points, points + d, t);
      const double* c = &coefficients_[tree_.descend(t).child * leafSize_];
      if (leafSize_ == 1) {
        pdfs[i] = *c;
      } else {
        evaluatePoint<d>(levels_, t, at);
        pdfs[i] = contract<d>(c, strides_, at);
      }
    }
  });
}

void TreeDensity::sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
                         uint32_t* components) const {
  const uint32_t d = shape_.dimensions;
  const double kBelowOne = std::nextafter(1.0, 0.0);
  const LeafSampler leafSampler(levels_, shape_);
  for (std::size_t i = 0; i < count; ++i, uniforms += d, points += d) {
    double u[kMaxDimensions];
    std::copy(uniforms, uniforms + d, u);
    TreeBox box;
    uint32_t at = 0;
    while (!tree_.nodes()[at].leaf()) {
      const TreeNode& node = tree_.nodes()[at];
      double& along = u[node.axis];
      const double left = left_[at];
      const uint32_t upper = along < left ? 0 : 1;
      along = upper ? (along - left) / (1.0 - left) : along / left;
      along = std::min(along, kBelowOne);
      at = node.child + upper;
      box = box.half(node.axis, upper);
    }
    const double* c = &coefficients_[tree_.nodes()[at].child * leafSize_];
    double t[kMaxDimensions];
    leafSampler.sample(c, u, t);
    for (uint32_t a = 0; a < d; ++a) {
      const double size = box.size(a);
      // Rounding must not carry the point into the next box.
      points[a] = std::min(box.lower[a] + t[a] * size, std::nextafter(box.lower[a] + size, 0.0));
    }
    if (components) components[i] = AWD_INVALID_ID;
  }
  if (pdfs) pdf(count, points - count * d, pdfs);
}

void TreeDensity::record(std::size_t count, const double* points, const double* pdfs,
                         const double* values, AWDTarget target,
                         DensityStatistics& statistics) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    AxisValues at[d];
    double t[d];
    for (std::size_t i = 0; i < count; ++i, points += d) {
      const bool usable = std::isfinite(values[i]);
      statistics.sums.rejected += !usable;
      std::copy(points, points + d, t);
      const std::size_t leaf = tree_.descend(t).child;
      evaluatePoint<d>(levels_, t, at);
      const double p = pdfs ? pdfs[i] : contract<d>(&coefficients_[leaf * leafSize_], strides_, at);
      const WeighedSample sample(usable ? values[i] : 0.0, p, target);
      statistics.sums.add(sample);
      BoxTally* boxes = &statistics.boxes[leaf * (d + 1)];
      for (uint32_t a = 0; a < d; ++a) {
        if (t[a] < 0.5) boxes[a].add(sample);
      }
      boxes[d].add(sample);
      const double value = sample.target.value * sample.inverse.value;
      const int valueExponent = sample.target.exponent + sample.inverse.exponent;
      forEachAlive<d>(strides_, at, [&](std::size_t j, double n) {
        Tally& tally = statistics.tallies[leaf * leafSize_ + j];
        tally.value.add(value * n, valueExponent);
        tally.weight.add(sample.inverse.value * n, sample.inverse.exponent);
        tally.alive += static_cast<int64_t>(n * (1.0 / Tally::kAliveUnit) + 0.5);
      });
    }
  });
}

double TreeDensity::mass(const double* lower, const double* upper) const {
  std::pmr::memory_resource* memory = coefficients_.get_allocator().resource();
  const uint32_t d = shape_.dimensions;
  double sum = 0.0;
  tree_.walk([&](uint32_t i, const TreeBox& box) {
    const TreeNode& node = tree_.nodes()[i];
    if (!node.leaf()) return;
    double from[kMaxDimensions], to[kMaxDimensions];
    for (uint32_t a = 0; a < d; ++a) {
      from[a] = std::clamp((lower[a] - box.lower[a]) / box.size(a), 0.0, 1.0);
      to[a] = std::clamp((upper[a] - box.lower[a]) / box.size(a), 0.0, 1.0);
      if (!(from[a] < to[a])) return;
    }
    sum += box.volume(d) *
           boxIntegral(memory, levels_, shape_, &coefficients_[node.child * leafSize_], from, to);
  });
  return sum;
}

std::size_t TreeDensity::bytes() const {
  return sizeof *this + tree_.bytes() +
         (coefficients_.capacity() + left_.capacity()) * sizeof(double);
}

}  // namespace awd
