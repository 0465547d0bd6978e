// SPDX-License-Identifier: Apache-2.0
#include "density/tree_density.h"

#include <algorithm>
#include <cmath>

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
      index_(tree_),
      coefficients_(std::move(coefficients)),
      leafSampler_(levels, shape_),
      marginals_(memory),
      halves_(tree_.nodes().size(), Halves{}, memory) {
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
  marginals_.resize(tree_.leaves() * leafSampler_.marginalSize());
  for (std::size_t leaf = 0; leaf < tree_.leaves(); ++leaf) {
    leafSampler_.marginals(&coefficients_[leaf * leafSize_],
                           marginals_.data() + leaf * leafSampler_.marginalSize());
  }
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const TreeNode& node = tree_.nodes()[i];
    if (node.leaf() || !(masses[i] > 0.0)) continue;
    const double left = masses[node.child] / masses[i];
    halves_[i] = {left, left > 0.0 ? 1.0 / left : 0.0, left < 1.0 ? 1.0 / (1.0 - left) : 0.0};
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
  // Pair by pair, which loses no digits.
  for (std::size_t i = masses.size(); i-- > 0;) {
    const TreeNode& node = tree_.nodes()[i];
    if (!node.leaf()) masses[i] = masses[node.child] + masses[node.child + 1];
  }
}

template <uint32_t D>
double TreeDensity::value(const double* c, const double* t, AxisValues* at) const {
  if (leafSize_ == 1) return *c;
  evaluatePoint<D>(levels_, t, at);
  return contract<D>(c, strides_, at);
}

void TreeDensity::pdf(std::size_t count, const double* points, double* pdfs) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    AxisValues at[d];
    double t[d];
    for (std::size_t i = 0; i < count; ++i, points += d) {
      std::copy(points, points + d, t);
      pdfs[i] = value<d>(&coefficients_[index_.descend<d>(tree_, t).child * leafSize_], t, at);
    }
  });
}

void TreeDensity::sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
                         uint32_t* components) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    const double belowOne = std::nextafter(1.0, 0.0);
    AxisValues at[d];
    for (std::size_t i = 0; i < count; ++i, uniforms += d, points += d) {
      double u[d], t[d], lower[d] = {}, size[d];
      std::copy(uniforms, uniforms + d, u);
      std::fill(size, size + d, 1.0);
      const TreeNode* nodes = tree_.nodes().data();
      uint32_t node = 0;
      while (!nodes[node].leaf()) {
        const uint32_t axis = nodes[node].axis;
        const Halves& halves = halves_[node];
        const bool upper = u[axis] >= halves.left;
        size[axis] *= 0.5;
        lower[axis] += upper ? size[axis] : 0.0;
        u[axis] =
            (u[axis] - (upper ? halves.left : 0.0)) * (upper ? halves.overRight : halves.overLeft);
        u[axis] = std::min(u[axis], belowOne);
        node = nodes[node].child + upper;
      }
      const std::size_t leaf = nodes[node].child;
      const double* c = &coefficients_[leaf * leafSize_];
      const double* drawn = u;
      if (leafSize_ > 1) {
        leafSampler_.sample<d>(c, marginals_.data() + leaf * leafSampler_.marginalSize(), u, t);
        drawn = t;
      }
      for (uint32_t a = 0; a < d; ++a) {
        // Rounding must not carry the point into the next box.
        const double place = drawn[a];
        points[a] = lower[a] + place * size[a];
        if (points[a] >= lower[a] + size[a]) points[a] = std::nextafter(lower[a] + size[a], 0.0);
        // As exact as the steps down the tree: the same bits as in pdf(). Nor may rounding carry it
        // into the next cell of the leaf, which may have no mass.
        const BasisLevel& level = *levels_[a];
        t[a] = (points[a] - lower[a]) / size[a];
        while (level.cells > 1 && cellOf(level, t[a]) > cellOf(level, place)) {
          points[a] = std::nextafter(points[a], 0.0);
          t[a] = (points[a] - lower[a]) / size[a];
        }
      }
      if (components) components[i] = AWD_INVALID_ID;
      if (pdfs) pdfs[i] = value<d>(c, t, at);
    }
  });
}

void TreeDensity::record(std::size_t count, const double* points, const double* pdfs,
                         const double* values, AWDTarget target,
                         DensityStatistics& statistics) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    AxisValues at[d];
    double t[d];
    for (std::size_t i = 0; i < count; ++i, points += d) {
      std::copy(points, points + d, t);
      const std::size_t leaf = index_.descend<d>(tree_, t).child;
      evaluatePoint<d>(levels_, t, at);
      const double p = pdfs ? pdfs[i] : contract<d>(&coefficients_[leaf * leafSize_], strides_, at);
      const bool usable = p > 0.0 && std::isfinite(values[i]);
      statistics.sums.rejected += !usable;
      if (!(p > 0.0)) {  // never drawn from this density: f/p has no value
        ++statistics.sums.samples;
        continue;
      }
      const WeighedSample sample(usable ? values[i] : 0.0, p, target);
      statistics.sums.add(sample);
      BoxTally* boxes = &statistics.boxes[leaf * (d + 1)];
      for (uint32_t a = 0; a < d; ++a) {
        if (t[a] < 0.5) boxes[a].add(sample);
      }
      boxes[d].add(sample);
      const Scaled value = {sample.target.value * sample.inverse.value,
                            sample.target.exponent + sample.inverse.exponent};
      forEachAlive<d>(strides_, at, [&](std::size_t j, double n) {
        statistics.tallies[leaf * leafSize_ + j].add(value, sample.inverse, n);
      });
    }
  });
}

double TreeDensity::mass(const double* lower, const double* upper) const {
  std::pmr::memory_resource* memory = coefficients_.get_allocator().resource();
  const uint32_t d = shape_.dimensions;
  long double sum = 0.0L;
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
  return static_cast<double>(sum);
}

std::size_t TreeDensity::bytes() const {
  return sizeof *this + tree_.bytes() + index_.bytes() +
         (coefficients_.capacity() + marginals_.capacity()) * sizeof(double) +
         halves_.capacity() * sizeof(Halves);
}

}  // namespace awd
