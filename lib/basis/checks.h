// SPDX-License-Identifier: Apache-2.0
// The single checks of the self-test. Each is called once for every level that is looked at, and
// may throw what basis/cell.h throws.
#pragma once

#include <vector>

#include "basis/cell.h"
#include "basis/check.h"

namespace awd {

/// A level with the cells and functions that are looked at: all of them, or some at both ends and
/// in between.
struct TestedLevel : TableLevel {
  TestedLevel(const AWDBasisFamily& family, uint32_t level);
  bool whole;
  std::vector<uint32_t> someCells;
  std::vector<uint32_t> someFunctions;
};

/// Levels of up to this many cells and functions are tested in full.
constexpr uint32_t kWhole = 4096;

/// At most `limit` of 0 .. size-1: half of them at the ends, the others evenly in between.
std::vector<uint32_t> spread(uint32_t size, uint32_t limit);

/// The support of a function in cells: [first, first + size), modulo the number of cells.
/// Throws unless it is an interval of whole cells in range.
struct CellRange {
  uint32_t first, size;
};
CellRange supportCells(const TableLevel& level, uint32_t j);

// checks_values.cpp
/// Finite, and not negative beyond rounding.
void checkValues(const TestedLevel& level, Check& check);
void checkUnity(const TestedLevel& level, Check& check);
void checkPolynomial(const TestedLevel& level, Check& check);
/// Bernstein coefficients are not negative.
void checkCoefficients(const TestedLevel& level, Check& check);
/// No mass outside, and none of the ends too far out.
void checkSupport(const TestedLevel& level, Check& check);
void checkWeights(const TestedLevel& level, Check& check);

// checks_refine.cpp
void checkTwoScale(const TestedLevel& level, const TableLevel& finer, Check& check);
void checkTwoScaleMass(const TestedLevel& level, const TableLevel& finer, Check& check);

// checks_sampler.cpp
/// Inside the support and the same for the same uniforms.
void checkSamples(const TestedLevel& level, Check& check);
/// Kolmogorov-Smirnov distance from N_j / w_j, over the distance allowed.
void checkDistribution(const TestedLevel& level, Check& check);

// checks_gram.cpp; whole levels only
void checkGram(const TestedLevel& level, Check& check);
void checkOrthogonal(const TestedLevel& level, Check& check);
void checkNested(const TestedLevel& level, Check& check);
void checkPeriodic(const TestedLevel& level, Check& check);

// checks_wavelet.cpp; nested families only, each check relying on those before it
/// Levels are those of 2^level copies of level 0 ..
void checkTreeSizes(const AWDBasisFamily& family, Check& check);
/// .. and so are their functions.
void checkCopies(const TestedLevel& level, Check& check);
/// The integrals of x^i psi_k, over the norm of psi_k.
void checkVanishingMoments(const AWDBasisFamily& family, Check& check);
/// With the projection on level 0 the details determine level 1.
void checkWavelets(const AWDBasisFamily& family, Check& check);

}  // namespace awd
