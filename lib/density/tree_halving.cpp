// SPDX-License-Identifier: Apache-2.0
#include "density/tree_halving.h"

namespace awd {

TreeState halveLeaves(const DensityBases& bases, const TreeDensity& density, uint32_t axis) {
  const Tree& old = density.tree();
  const std::size_t size = density.leafShape().size();
  const Coefficients& from = density.coefficients();
  TreeState state = {old, Coefficients(2 * from.size(), 0.0, from.get_allocator())};
  const auto before = static_cast<uint32_t>(old.nodes().size());
  for (uint32_t node = 0; node < before; ++node) {
    if (old.nodes()[node].leaf()) state.tree.split(node, axis);
  }
  state.tree.finish();
  const uint32_t n = density.leafShape().count[axis];
  const std::size_t stride = density.leafShape().stride(axis);
  for (uint32_t node = 0; node < before; ++node) {
    if (!old.nodes()[node].leaf()) continue;
    const double* c = &from[old.nodes()[node].child * size];
    const TreeNode& parent = state.tree.nodes()[node];
    double* lower = &state.coefficients[state.tree.nodes()[parent.child].child * size];
    double* upper = &state.coefficients[state.tree.nodes()[parent.child + 1].child * size];
    density.leafShape().forEachFibre(axis, [&](std::size_t outer, std::size_t inner) {
      const std::size_t fibre = outer * n * stride + inner;
      bases.axis(axis).filter->split(c + fibre, stride, lower + fibre, upper + fibre);
    });
  }
  return state;
}

}  // namespace awd
