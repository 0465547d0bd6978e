// SPDX-License-Identifier: Apache-2.0
// int p^2 of densities of nested families, and how much of it each level of wavelets carries.
#pragma once

#include "density/bases.h"
#include "density/tensor.h"
#include "density/tree_density.h"

namespace awd {

/// Coefficients of cell-wise bases in the orthonormal basis of the cells, each as if it were the
/// unit cube: along every axis the first n0 elements belong to the first cell, and so on.
void toOrthonormal(const DensityBases& bases, const Shape& shape, double* coefficients);

/// int over the unit box of the square of a leaf's function.
double boxEnergy(const DensityBases& bases, const Shape& shape, const double* coefficients);

/// Energy of the coarsest level, then of the details up to each finer one. A rung of a grid is a
/// level of all axes that have one, a rung of a tree a halving.
Coefficients gridDetailEnergy(const DensityBases& bases, const Levels& levels,
                              const Coefficients& coefficients);
Coefficients treeDetailEnergy(const DensityBases& bases, const TreeDensity& density);

}  // namespace awd
