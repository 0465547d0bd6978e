// SPDX-License-Identifier: Apache-2.0
// The memory that the sums of the estimator `refit` take, which grows with the overlap of functions
// on every axis.
#pragma once

#include "density/bases.h"
#include "density/settings.h"

namespace awd {

/// Bytes of the sums of a grid on these levels, or of one leaf of a tree with levels 0.
double refitBytes(const DensityBases& bases, const Levels& levels);

/// Keeps them within settings.learning.refitBytes, unless the estimator is another: lowers the
/// levels, or the number of coefficients, that the density may come to. AWD_ERROR_INVALID_ARGUMENT
/// if what the host asks for at the start takes more.
void fitRefitBytes(const DensityBases& bases, DensitySettings& settings);

}  // namespace awd
