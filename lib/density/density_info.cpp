// SPDX-License-Identifier: Apache-2.0
// What a density tells about itself.
#include <algorithm>
#include <cmath>

#include "density/density.h"
#include "density/energy.h"
#include "util/error.h"

namespace awd {

AWDDensityInfo Density::info() const {
  AWDDensityInfo info = AWD_DENSITY_INFO_INIT;
  info.dimensions = dimensions();
  info.structure = settings_.structure;
  info.estimator = settings_.learning.estimator;
  info.target = settings_.learning.target;
  info.sampler = settings_.sampler;
  info.combination = settings_.combination;
  info.uniforms = uniforms();
  info.coefficients = model_.coefficients().size();
  info.leaves = model_.leaves();
  info.bytes = sizeof *this + model_.bytes() + statistics_->bytes() + passes_.bytes();
  info.samples = statistics_->sums.samples;
  info.rejected = statistics_->sums.rejected;
  info.learned = learned_;
  info.passes = adapts_;
  return info;
}

AWDDensityAxisInfo Density::axisInfo(uint32_t axis) const {
  if (axis >= dimensions()) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "axis is %u: the density has %u", axis, dimensions());
  }
  const CompiledFamily& compiled = bases_->axis(axis);
  const BasisLevel& level = compiled.family.level(model_.grid ? levels_[axis] : 0);
  AWDDensityAxisInfo info = AWD_DENSITY_AXIS_INFO_INIT;
  info.basis = compiled.family.name().c_str();
  info.level = levels_[axis];
  info.maxLevel = settings_.learning.maxLevel[axis];
  info.count = level.count;
  info.cells = level.cells;
  info.order = level.order;
  info.flags = compiled.flags;
  if (model_.tree) {
    info.level = 0;
    model_.tree->tree().walk(
        [&](uint32_t, const TreeBox& box) { info.level = std::max(info.level, box.depth[axis]); });
  }
  return info;
}

Coefficients Density::coefficients(AWDCoefficientForm form) const {
  Coefficients out(model_.coefficients(), memory());
  if (form == AWD_COEFFICIENTS_SCALING) return out;
  if (form != AWD_COEFFICIENTS_ORTHONORMAL) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "form is %d: 0 (scaling) or 1 (orthonormal) is allowed", form);
  }
  if (!bases_->nested()) {
    fail(AWD_ERROR_UNSUPPORTED, "orthonormal coefficients want a nested family on every axis");
  }
  // A cell's function of norm 1 is that of the unit cube over the root of the cell's volume.
  if (model_.grid) {
    toOrthonormal(*bases_, model_.grid->shape(), out.data());
    double volume = 1.0;
    for (uint32_t a = 0; a < dimensions(); ++a) {
      volume = std::ldexp(volume, -static_cast<int>(levels_[a]));
    }
    for (double& c : out) c *= std::sqrt(volume);
    return out;
  }
  const std::size_t size = model_.tree->leafShape().size();
  model_.tree->tree().walk([&](uint32_t node, const TreeBox& box) {
    const TreeNode& leaf = model_.tree->tree().nodes()[node];
    if (!leaf.leaf()) return;
    double* c = &out[leaf.child * size];
    toOrthonormal(*bases_, model_.tree->leafShape(), c);
    for (std::size_t j = 0; j < size; ++j) c[j] *= std::sqrt(box.volume(dimensions()));
  });
  return out;
}

Coefficients Density::detailEnergy() const {
  if (!bases_->nested()) {
    fail(AWD_ERROR_UNSUPPORTED, "details want a nested family on every axis");
  }
  return model_.grid ? gridDetailEnergy(*bases_, levels_, model_.coefficients())
                     : treeDetailEnergy(*bases_, *model_.tree);
}

}  // namespace awd
