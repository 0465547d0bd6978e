// SPDX-License-Identifier: Apache-2.0
// Finer trees of the same density.
#pragma once

#include "density/bases.h"
#include "density/tree_density.h"

namespace awd {

/// The same function with every leaf halved along an axis.
TreeState halveLeaves(const DensityBases& bases, const TreeDensity& density, uint32_t axis);

}  // namespace awd
