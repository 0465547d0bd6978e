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
      order_(commonOrder(levels, shape_.dimensions)),
      leafSampler_(levels, shape_),
      marginals_(memory) {
  std::copy(levels, levels + shape_.dimensions, levels_);
  for (uint32_t a = 0; a < shape_.dimensions; ++a) strides_[a] = shape_.stride(a);
  Coefficients masses(tree_.nodes().size(), 0.0, memory);
  if (scale == Scale::toIntegral) {
    // By the largest first, so that neither sum nor quotient leaves the range of a double.
    const double largest = *std::max_element(coefficients_.begin(), coefficients_.end());
    for (double& c : coefficients_) c /= largest;
    weigh(masses);
    for (double& c : coefficients_) c /= masses[0];
  }
  dropNegligible(coefficients_);
  weigh(masses);
  marginals_.resize(tree_.leaves() * leafSampler_.marginalSize());
  for (std::size_t leaf = 0; leaf < tree_.leaves(); ++leaf) {
    leafSampler_.marginals(&coefficients_[leaf * leafSize_],
                           marginals_.data() + leaf * leafSampler_.marginalSize());
  }
  descent_.emplace(tree_, masses);
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

void TreeDensity::pdf(std::size_t count, const double* points, double* pdfs) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    withOrder(order_, [&](auto order) {
      constexpr uint32_t d = dimensions;
      AxisValues at[d];
      double t[d];
      for (std::size_t i = 0; i < count; ++i, points += d) {
        std::copy(points, points + d, t);
        const double* c = &coefficients_[index_.descend<d>(tree_, t).child * leafSize_];
        if (leafSize_ == 1) {
          pdfs[i] = *c;
          continue;
        }
        evaluatePoint<d, order>(levels_, t, at);
        pdfs[i] = contract<d, order>(c, strides_, at);
      }
    });
  });
}

void TreeDensity::sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
                         uint32_t* components) const {
  if (count == 1) {
    sampleBlock<1>(1, uniforms, points, pdfs);
  } else {
    const uint32_t d = shape_.dimensions;
    for (std::size_t done = 0; done < count; done += kBlock) {
      sampleBlock<kBlock>(std::min(count - done, kBlock), uniforms + done * d, points + done * d,
                          pdfs ? pdfs + done : nullptr);
    }
  }
  if (components) std::fill(components, components + count, AWD_INVALID_ID);
}

template <std::size_t N>
void TreeDensity::sampleBlock(std::size_t count, const double* uniforms, double* points,
                              double* pdfs) const {
  const uint32_t d = shape_.dimensions;
  BlockDescent<N> block;
  for (uint32_t a = 0; a < d; ++a) {
    forEachSample<N>(count, [&](std::size_t i) { block.u[a][i] = uniforms[i * d + a]; });
  }
  descent_->descend(count, block);
  double* told = leafSampler_.tellsPdfs() ? pdfs : nullptr;
  leafSampler_.sample({*descent_, coefficients_.data(), marginals_.data()}, count, block, points,
                      told);
  if (pdfs && !told) pdf(count, points, pdfs);
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
      if (statistics.normal.pattern) statistics.normal.add<d>(leaf, t, at, sample);
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
         (coefficients_.capacity() + marginals_.capacity()) * sizeof(double) + descent_->bytes();
}

}  // namespace awd
