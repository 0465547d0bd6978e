// SPDX-License-Identifier: Apache-2.0
// A tree density: on every leaf of a tree of boxes a combination of the level-0 functions of a
// nested family per axis, scaled to the box. Immutable, and shared by those who draw from it.
#pragma once

#include <memory_resource>
#include <optional>

#include "density/leaf_sampler.h"
#include "density/statistics.h"
#include "density/tensor.h"
#include "density/tree.h"
#include "density/tree_descent.h"
#include "density/tree_index.h"
#include "util/context.h"

namespace awd {

/// What makes a tree density.
struct TreeState {
  Tree tree;
  Coefficients coefficients;
};

class TreeDensity final : public RefCounted {
 public:
  /// Of coefficients, leaf by leaf, that are not negative and have a finite positive integral,
  /// which is 1 already if they are asIs; else they are divided by it. Keeps pointers to the
  /// levels, level 0 of a family for each axis.
  static Ref<TreeDensity> make(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                               Tree tree, Coefficients coefficients, Scale scale);
  TreeDensity(std::pmr::memory_resource* memory, const BasisLevel* const* levels, Tree tree,
              Coefficients coefficients, Scale scale);

  const Tree& tree() const { return tree_; }
  const BasisLevel* const* levels() const { return levels_; }
  /// Of the coefficients of one leaf.
  const Shape& leafShape() const { return shape_; }
  const Coefficients& coefficients() const { return coefficients_; }

  /// As the C functions of these names have it.
  void pdf(std::size_t count, const double* points, double* pdfs) const;
  void sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
              uint32_t* components) const;

  /// Adds samples to the statistics of a pass; pdfs may be null: this density's own.
  void record(std::size_t count, const double* points, const double* pdfs, const double* values,
              AWDTarget target, DensityStatistics& statistics) const;

  /// int of p over a box.
  double mass(const double* lower, const double* upper) const;
  std::size_t bytes() const;

 private:
  void destroy() noexcept override;
  /// sample() of N samples at most.
  template <std::size_t N>
  void sampleBlock(std::size_t count, const double* uniforms, double* points, double* pdfs) const;
  /// Masses of the nodes' lower halves, and the integral of all; `masses` gets one per node.
  void weigh(Coefficients& masses) const;

  const BasisLevel* levels_[kMaxDimensions] = {};
  Shape shape_;
  std::size_t strides_[kMaxDimensions] = {};
  std::size_t leafSize_;  ///< coefficients of a leaf
  Tree tree_;
  TreeIndex index_;
  Coefficients coefficients_;
  uint32_t order_;  ///< commonOrder() of the axes
  LeafSampler leafSampler_;
  Coefficients marginals_;  ///< of the leaves, as the sampler wants them
  std::optional<TreeDescent> descent_;
};

}  // namespace awd
