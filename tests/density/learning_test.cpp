// SPDX-License-Identifier: Apache-2.0
// What densities make of samples of known functions: each estimator, the target, the floor.
#include <gtest/gtest.h>

#include <algorithm>

#include "density/learning.h"

namespace {

using namespace awdtest;

/// f = x^2 on the three hats of level 1: r = (1, 7, 17)/24 of integral 1/3; its dual is (-1, 5,
/// 23)/24, which without its negative part has the integral 33/96.
TEST_F(Learning, EveryEstimatorOnAParabola) {
  const std::vector<double> quasi = {1.0 / 8, 7.0 / 8, 17.0 / 8};
  const std::vector<double> dual = {0.0, 20.0 / 33, 92.0 / 33};
  const struct {
    AWDEstimator estimator, used;
    std::vector<double> expected;
    uint64_t negative;
  } cases[] = {{AWD_ESTIMATOR_QUASI, AWD_ESTIMATOR_QUASI, quasi, 0},
               {AWD_ESTIMATOR_RATIO, AWD_ESTIMATOR_RATIO, dual, 1},
               {AWD_ESTIMATOR_MIXTURE, AWD_ESTIMATOR_MIXTURE, dual, 1},
               {AWD_ESTIMATOR_PAPER, AWD_ESTIMATOR_PAPER, dual, 1},
               {AWD_ESTIMATOR_DEFAULT, AWD_ESTIMATOR_RATIO, dual, 1}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.estimator);
    AWDDensityDesc desc = gridDesc();
    desc.estimator = c.estimator;
    desc.tau = kNone;
    desc.shrinkage = kNone;
    const Density density = newDensity(device_, {fixedAxis("linear-bspline", 1)}, desc);
    const AWDDensityReport report = evenPass(density, 65536, square);
    EXPECT_EQ(report.estimator, c.used);
    EXPECT_EQ(report.negative, c.negative);
    EXPECT_EQ(report.tau, 0.0);
    // With components, 256 points of each in 128 equal parts of two hats: 1e-3.
    expectNear(coefficientsOf(density), c.expected,
               c.estimator == AWD_ESTIMATOR_PAPER ? 2e-3 : 1e-6);
  }
}

/// The projection of a function that the basis holds is that function, whatever the estimator, also
/// when it is learned from a density far from constant. 2 dimensions, axes of different families.
TEST_F(Learning, WhatTheBasisHoldsIsLearnedExactly) {
  for (const AWDEstimator estimator : {AWD_ESTIMATOR_RATIO, AWD_ESTIMATOR_MIXTURE}) {
    SCOPED_TRACE(estimator);
    AWDDensityDesc desc = gridDesc();
    desc.estimator = estimator;
    desc.tau = kNone;
    const Axes axes = {fixedAxis("quadratic-bspline", 1), fixedAxis("m2", 1)};
    Random random(11);
    const auto newMild = [&] {
      Density made = newDensity(device_, axes, desc);
      std::vector<double> c(infoOf(made).coefficients);
      for (double& value : c) value = 1.0 + 3.0 * random.uniform();
      setCoefficients(made, c);
      return made;
    };
    const Density density = newMild(), target = newMild();
    const AWDDensityReport report = evenPass(density, 500 * 500, [&](const double* x) {
      double p;
      must(awdGetDensityPdf(target, 1, x, &p));
      return p;
    });
    EXPECT_EQ(report.estimator, estimator);
    expectNear(coefficientsOf(density), coefficientsOf(target), 2e-3);
  }
}

/// The default takes the dual where the level can't grow and there are 16 samples a coefficient.
TEST_F(Learning, TheDefaultEstimatorGoesBySamplesAndLevel) {
  const auto used = [&](const AWDDensityAxis& axis, size_t samples, AWDDensityDesc desc) {
    const Density density = newDensity(device_, {axis}, desc);
    Random random(12);
    return pass(density, samples, random, square).estimator;
  };
  EXPECT_EQ(used(fixedAxis("linear-bspline", 2), 80, gridDesc()), AWD_ESTIMATOR_RATIO);
  EXPECT_EQ(used(fixedAxis("linear-bspline", 2), 79, gridDesc()), AWD_ESTIMATOR_QUASI);
  EXPECT_EQ(used(axisFrom("linear-bspline", 2, 5), 4000, gridDesc()), AWD_ESTIMATOR_QUASI);
  EXPECT_EQ(used(fixedAxis("m2", 2), 4000, treeDesc()), AWD_ESTIMATOR_QUASI);
  // maxCoefficients caps levels too.
  AWDDensityDesc desc = gridDesc();
  desc.maxCoefficients = 8;
  EXPECT_EQ(used({"linear-bspline", AWD_LEVEL(2), 0}, 80, desc), AWD_ESTIMATOR_RATIO);
}

/// In the lower half f is 0 or 2 by a coin of its own, in the upper half always 1.
TEST_F(Learning, TheTargetIsTheMeanOrTheRms) {
  for (const AWDTarget target : {AWD_TARGET_DEFAULT, AWD_TARGET_MEAN, AWD_TARGET_RMS}) {
    for (const AWDDensityStructure structure : {AWD_STRUCTURE_GRID, AWD_STRUCTURE_TREE}) {
      AWDDensityDesc desc = structure == AWD_STRUCTURE_TREE ? treeDesc() : gridDesc();
      desc.target = target;
      desc.shrinkage = kNone;
      desc.maxCoefficients = 2;
      const Density density = newDensity(device_, {fixedAxis("haar", 1)}, desc);
      int toss = 0;
      evenPass(density, 4096,
               [&](const double* x) { return x[0] >= 0.5 ? 1.0 : 2.0 * (++toss % 2); });
      const double lower = target == AWD_TARGET_RMS ? std::sqrt(2.0) : 1.0;
      expectNear(coefficientsOf(density), {2.0 * lower / (lower + 1.0), 2.0 / (lower + 1.0)},
                 1e-12);
    }
  }
}

/// Only the last of four boxes has any f: the others get tau times the mean before normalising.
TEST_F(Learning, TheFloor) {
  const struct {
    const char* basis;
    double asked, used;
    AWDEstimator estimator;
    size_t samples;
  } cases[] = {
      {"haar", 0.0, 1.0 / 5.0, AWD_ESTIMATOR_QUASI, 16},  // 1 / (1 + m/n)
      {"haar", 0.0, 0.3, AWD_ESTIMATOR_QUASI, 4},         // at most
      {"haar", 0.0, 0.01, AWD_ESTIMATOR_QUASI, 4096},     // at least
      {"haar", 0.05, 0.05, AWD_ESTIMATOR_QUASI, 16},
      {"haar", 1.0, 1.0, AWD_ESTIMATOR_QUASI, 16},
      {"haar", -1.0, 0.0, AWD_ESTIMATOR_QUASI, 16},
      {"haar", 0.0, 0.1, AWD_ESTIMATOR_PAPER, 4096},
      {"linear-bspline-periodic", 0.0, 0.01, AWD_ESTIMATOR_QUASI, 16},
      {"linear-bspline-periodic", 0.2, 0.2, AWD_ESTIMATOR_QUASI, 16},
  };
  for (const auto& c : cases) {
    SCOPED_TRACE(std::string(c.basis) + ", tau " + std::to_string(c.asked));
    AWDDensityDesc desc = gridDesc();
    desc.tau = c.asked;
    desc.shrinkage = kNone;
    desc.estimator = c.estimator;
    const Density density = newDensity(device_, {fixedAxis(c.basis, 2)}, desc);
    const AWDDensityReport report =
        evenPass(density, c.samples, [](const double* x) { return x[0] >= 0.75 ? 1.0 : 0.0; });
    EXPECT_DOUBLE_EQ(report.tau, c.used);
    const std::vector<double> seen = coefficientsOf(density);
    // All weights are 1/4. Of two hats, 0 the one at 0 and 3 the one at 3/4, each sees half of f.
    const bool haar = isPiecewiseConstant(c.basis);
    std::vector<double> expected = {haar ? 0.0 : 0.5, 0.0, 0.0, haar ? 1.0 : 0.5};
    double sum = 0.0;
    for (double& value : expected) sum += value = std::max(value, 0.25 * c.used);
    for (double& value : expected) value *= 4.0 / sum;
    expectNear(seen, expected, haar ? 1e-14 : 0.1);
    EXPECT_NEAR(*std::min_element(seen.begin(), seen.end()) / seen[3],
                0.25 * c.used / (haar ? 1.0 : 0.5), haar ? 1e-14 : 0.02);
  }
}

TEST_F(Learning, TheVarianceOfABumpFalls) {
  for (const uint32_t d : {1u, 2u, 4u}) {
    const double width = d == 4 ? 0.2 : 0.1;
    const Function f = [d, width](const double* x) { return bump(x, d, width); };
    for (const AWDDensityStructure structure : {AWD_STRUCTURE_GRID, AWD_STRUCTURE_TREE}) {
      for (const char* basis : kFamilies) {
        const bool tree = structure == AWD_STRUCTURE_TREE;
        if (tree && std::find(std::begin(kNested), std::end(kNested), std::string(basis)) ==
                        std::end(kNested)) {
          continue;
        }
        SCOPED_TRACE(std::string(basis) + (tree ? " tree, " : " grid, ") + std::to_string(d) +
                     " dimensions");
        AWDDensityDesc desc = tree ? treeDesc() : gridDesc();
        desc.maxCoefficients = 4096;
        const Density density = newDensity(device_, Axes(d, AWDDensityAxis{basis, 0, 0}), desc);
        Random random(21);
        const double before = relativeVariance(density, random, f);
        for (int k = 0; k < 4; ++k) pass(density, 2000, random, f);
        const double after = relativeVariance(density, random, f);
        EXPECT_LT(after, before / (d == 1 ? 10.0 : d == 2 ? 6.0 : 3.0)) << before;
      }
    }
  }
}

/// Levels go where they are needed: along the axis that f depends on, and that may go.
TEST_F(Learning, AxesOfTheirOwn) {
  AWDDensityDesc desc = gridDesc();
  desc.passSamples = 500;
  const Density density = newDensity(
      device_, {fixedAxis("haar", 0), {"quadratic-bspline-periodic", 0, 0}, axisFrom("m3", 1, 2)},
      desc);
  Random random(22);
  const Function f = [](const double* x) {
    const double t = (x[1] - 0.02) - std::round(x[1] - 0.02);  // a bump across the seam
    return std::exp(-0.5 * t * t / 0.0025) * (1.0 + x[2]);
  };
  const double before = relativeVariance(density, random, f);
  for (int k = 0; k < 4; ++k) pass(density, 2000, random, f);
  EXPECT_EQ(axisInfoOf(density, 0).level, 0u);
  EXPECT_GE(axisInfoOf(density, 1).level, 4u);
  EXPECT_EQ(axisInfoOf(density, 2).level, 2u);
  EXPECT_EQ(infoOf(density).coefficients, (uint64_t{12} << axisInfoOf(density, 1).level));
  EXPECT_LT(relativeVariance(density, random, f), 0.02 * before);

  const Density tree =
      newDensity(device_, {axisFrom("haar", 0, 0), axisFrom("m2", 0, 9)}, treeDesc());
  for (int k = 0; k < 4; ++k) {
    pass(tree, 2000, random, [](const double* x) { return bump(x + 1, 1, 0.05); });
  }
  EXPECT_EQ(axisInfoOf(tree, 0).level, 0u);
  EXPECT_GE(axisInfoOf(tree, 1).level, 3u);
}

TEST_F(Learning, TheReport) {
  for (const AWDDensityDesc& desc : {gridDesc(), treeDesc()}) {
    const Density density = newDensity(device_, {axisFrom("m2", 1, 6), fixedAxis("haar", 2)}, desc);
    Random random(23);
    Samples samples = draw(density, 1000, random, [](const double* x) { return bump(x, 2, 0.1); });
    for (size_t i = 0; i < 10; ++i) samples.values[100 * i] = i % 2 ? HUGE_VAL : std::nan("");
    record(density, samples);
    EXPECT_EQ(infoOf(density).samples, 1000u);
    EXPECT_EQ(infoOf(density).rejected, 10u);
    EXPECT_EQ(infoOf(density).passes, 0u);
    const AWDDensityReport report = adapt(density);
    const AWDDensityInfo info = infoOf(density);
    EXPECT_EQ(report.samples, 1000u);
    EXPECT_EQ(report.rejected, 10u);
    EXPECT_EQ(report.coefficients, info.coefficients);
    EXPECT_EQ(report.negative, 0u);
    EXPECT_EQ(report.kept, 0);
    EXPECT_EQ(report.estimator, AWD_ESTIMATOR_QUASI);
    EXPECT_GT(report.tau, 0.0);
    EXPECT_EQ(info.samples, 0u);
    EXPECT_EQ(info.rejected, 0u);
    EXPECT_EQ(info.learned, 1000u);
    EXPECT_EQ(info.passes, 1u);
    if (desc.structure == AWD_STRUCTURE_TREE) {
      EXPECT_GT(report.split, 0u);
      EXPECT_EQ(info.coefficients, 2 * info.leaves);
    } else {
      EXPECT_EQ(report.split, 0u);
      EXPECT_EQ(report.coarsened, 0u);
      EXPECT_EQ(info.leaves, 1u);
      EXPECT_EQ(report.estimatedLevels, 3u) << "levels 1 2, 0 1 and 0 0";
    }
    setCoefficients(density, std::vector<double>(info.coefficients, 2.0));
    EXPECT_EQ(infoOf(density).learned, 0u) << "set by the host";
    // An output that is not wanted.
    record(density, samples);
    must(awdAdaptDensity(density, nullptr));
    EXPECT_EQ(infoOf(density).passes, 2u);
  }
}

/// Refining changes coefficients, not the density.
TEST_F(Learning, RefiningKeepsTheDensity) {
  Random random(24);
  const std::vector<double> points = randomNumbers(2 * 200, random);
  for (const char* basis : kFamilies) {
    for (const AWDDensityStructure structure : {AWD_STRUCTURE_GRID, AWD_STRUCTURE_TREE}) {
      AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
      desc.structure = structure;
      if (structure == AWD_STRUCTURE_TREE && std::find(std::begin(kNested), std::end(kNested),
                                                       std::string(basis)) == std::end(kNested)) {
        continue;
      }
      const Density density =
          newDensity(device_, {axisFrom(basis, 1, 4), axisFrom(basis, 1, 4)}, desc);
      setRandomCoefficients(density, random);
      const std::vector<double> before = pdfsAt(density, points);
      const uint64_t coefficients = infoOf(density).coefficients;
      for (const uint32_t axis : {0u, 1u, AWD_ALL_AXES}) {
        must(awdRefineDensity(density, axis));
        expectNear(pdfsAt(density, points), before, 1e-13);
      }
      EXPECT_EQ(axisInfoOf(density, 0).level, 3u);
      EXPECT_EQ(axisInfoOf(density, 1).level, 3u);
      EXPECT_GE(infoOf(density).coefficients, 6 * coefficients) << basis;
      // Squares of orthonormal coefficients, and energies of the levels, are int p^2.
      if (std::find(std::begin(kNested), std::end(kNested), std::string(basis)) ==
          std::end(kNested)) {
        continue;
      }
      double squares = 0.0, energy = 0.0;
      for (const double c : coefficientsOf(density, AWD_COEFFICIENTS_ORTHONORMAL)) squares += c * c;
      size_t rungs;
      must(awdGetDensityDetailEnergy(density, nullptr, 0, &rungs));
      std::vector<double> energies(rungs);
      must(awdGetDensityDetailEnergy(density, energies.data(), rungs, &rungs));
      for (const double e : energies) energy += e;
      EXPECT_NEAR(energy, squares, 1e-12 * squares) << basis;
      EXPECT_LT(energies.back(), 1e-14 * squares) << basis << ": the last level adds nothing";
      EXPECT_GT(energies[0], 1.0 - 1e-12) << basis << ": 1 at least is in the constant";
    }
  }
}

}  // namespace
