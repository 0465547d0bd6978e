// SPDX-License-Identifier: Apache-2.0
// The one-dimensional operators of the method, applied along the axes of a tensor product.
#pragma once

#include <memory_resource>
#include <vector>

#include "basis/family.h"
#include "density/gram.h"
#include "density/shape.h"

namespace awd {

using Coefficients = std::pmr::vector<double>;

/// Whether coefficients are to be divided by their integral or are a density's already, whose bits
/// must not change.
enum class Scale { toIntegral, asIs };

/// Of a density whose integral is 1, counts coefficients below 1e-100 as 0: products with the
/// values of six axes' functions, and quotients of masses, would leave the range of a double.
void dropNegligible(Coefficients& coefficients);

/// c' = P c along one axis: coefficients of the same function a level finer. `shape` is that of
/// `coefficients` and becomes that of the result.
Coefficients refineAlong(const BasisLevel& coarse, const BasisLevel& fine, uint32_t axis,
                         Shape& shape, const Coefficients& coefficients);

/// P^T along one axis: sums over the functions of a finer level become those over the coarser.
Coefficients restrictAlong(const BasisLevel& coarse, uint32_t axis, Shape& shape,
                           const Coefficients& sums);

/// G c = b along one axis, in place.
void solveAlong(const GramSolver& gram, uint32_t axis, const Shape& shape, Coefficients& b);

/// Multiplies (or divides) every element by the weights w_j of its functions on all axes.
void timesWeights(const BasisLevel* const* levels, const Shape& shape, Coefficients& values);
void overWeights(const BasisLevel* const* levels, const Shape& shape, Coefficients& values);

/// int of the function with these coefficients: sum_j c_j w_j.
double integral(const BasisLevel* const* levels, const Shape& shape, const double* coefficients);

/// int of that function over the box from lower to upper.
double boxIntegral(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                   const Shape& shape, const double* coefficients, const double* lower,
                   const double* upper);

/// The shape of the coefficients on these levels.
Shape shapeOf(const BasisLevel* const* levels, uint32_t dimensions);

}  // namespace awd
