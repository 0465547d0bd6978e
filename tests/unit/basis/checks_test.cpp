// SPDX-License-Identifier: Apache-2.0
// The single checks against families with one fault each. What a whole module with a fault meets
// is in tests/plugins.
#include "basis/checks.h"

#include <gtest/gtest.h>

#include <cmath>

#include "basis/self_test.h"
#include "tables.h"

namespace {

using namespace awd;

/// The first complaint of the self-test about a family.
std::string complaint(const AWDBasisFamily& family) {
  const std::vector<Check> checks = selfTest(family);
  const Check* failure = firstFailure(checks);
  return failure ? std::string(failure->name()) + ": " + failure->sentence() : "";
}

TEST(Spread, TakesBothEndsAndSomeBetween) {
  EXPECT_EQ(spread(3, 8), (std::vector<uint32_t>{0, 1, 2}));
  EXPECT_EQ(spread(8, 8).size(), 8u);
  EXPECT_EQ(spread(1000, 8), (std::vector<uint32_t>{0, 1, 2, 251, 500, 749, 998, 999}));
  EXPECT_TRUE(spread(0, 4).empty());
}

TEST(Checks, SupportInCells) {
  const CellRange range = supportCells(TableLevel(test::quadratic(), 3), 4);
  EXPECT_EQ(range.first, 2u);
  EXPECT_EQ(range.size, 3u);
  const CellRange wrapped = supportCells(TableLevel(test::linearPeriodic(), 2), 0);
  EXPECT_EQ(wrapped.first, 3u);
  EXPECT_EQ(wrapped.size, 2u);
}

TEST(Checks, ASupportMustBeAnInterval) {
  AWDBasisFamily family = test::linear();
  family.support = [](uint32_t, uint32_t, double ab[2]) { ab[0] = NAN; };
  EXPECT_EQ(complaint(family).substr(0, 71),
            "support: support is no interval: level 0, function 0: got nan to nan");
  family.support = [](uint32_t, uint32_t, double ab[2]) { ab[0] = ab[1] = 0.5; };
  EXPECT_EQ(complaint(family),
            "support: support is no interval: level 0, function 0: got 0.5 to 0.5");
  family.support = [](uint32_t, uint32_t, double ab[2]) {
    ab[0] = 0.0;
    ab[1] = 1.25;
  };
  EXPECT_EQ(complaint(family),
            "support: support is no interval: level 0, function 0: got 0 to 1.25");
  family.support = [](uint32_t, uint32_t, double ab[2]) {
    ab[0] = 0.0;
    ab[1] = 0.75;
  };
  EXPECT_EQ(complaint(family),
            "support: support does not end where cells do: level 0, function 0: got 0 to 0.75");
}

TEST(Checks, MassOutsideTheSupport) {
  AWDBasisFamily family = test::linear();
  family.support = [](uint32_t level, uint32_t j, double ab[2]) {
    test::linear().support(level, j, ab);
    if (level == 2 && j == 2) ab[1] = 0.5;
  };
  EXPECT_EQ(complaint(family),
            "support: function is not 0 outside its support: level 2, function 2, cell 2: got 1");
}

TEST(Checks, WrongWeightsOfEveryKind) {
  AWDBasisFamily family = test::quadratic();
  family.weight = [](uint32_t, uint32_t) -> double { return NAN; };
  EXPECT_EQ(complaint(family).substr(0, 58),
            "weight: weight is not the integral: level 0, function 0: g");
  family.weight = [](uint32_t level, uint32_t j) {
    return test::quadratic().weight(level, j) + (level == 12 && j == 4097 ? 1e-9 : 0.0);
  };
  EXPECT_EQ(complaint(family).substr(0, 62),
            "weight: weight is not the integral: level 12, function 4097: g");
}

TEST(Checks, TwoScaleRelationMustHoldEverywhere) {
  AWDBasisFamily family = test::linear();
  family.twoScale = [](uint32_t level, uint32_t j, uint32_t* first, double* h) {
    const uint32_t size = test::linear().twoScale(level, j, first, h);
    if (level == 3 && j == 4) h[1] += 1e-9;
    return size;
  };
  EXPECT_EQ(complaint(family).substr(0, 65),
            "two-scale: two-scale relation does not hold: level 3, function 4,");
  family.twoScale = [](uint32_t level, uint32_t j, uint32_t* first, double* h) {
    const uint32_t size = test::linear().twoScale(level, j, first, h);
    h[0] = NAN;
    return size;
  };
  EXPECT_EQ(complaint(family).substr(0, 60),
            "two-scale: two-scale coefficient is negative or not finite: ");
  // Too far up to be tested in full: the step to the highest level.
  family.twoScale = [](uint32_t level, uint32_t j, uint32_t* first, double* h) {
    const uint32_t size = test::linear().twoScale(level, j, first, h);
    if (level == AWD_BASIS_MAX_LEVEL - 1) *first += 1;
    return size;
  };
  EXPECT_NE(complaint(family).find("level 19"), std::string::npos) << complaint(family);
}

TEST(Checks, TwoScaleRelationKeepsTheMass) {
  AWDBasisFamily family = test::linear();
  family.weight = [](uint32_t level, uint32_t j) {
    return test::linear().weight(level, j) + (level == 3 && j == 4 ? 1e-9 : 0.0);
  };
  for (const uint32_t l : {1u, 2u, 3u, 4u}) {
    Check check("two-scale mass", 1e-11);
    checkTwoScaleMass(TestedLevel(family, l), TableLevel(family, l + 1), check);
    EXPECT_EQ(check.ok(), l == 1 || l == 4) << "level 3 on either side: " << check.sentence();
  }
}

TEST(Checks, SamplersThatAreNearlyRight) {
  AWDBasisFamily family = test::linear();
  // A box instead of a hat, with the right support and mean.
  family.sample = [](uint32_t level, uint32_t j, const double* u) {
    double ab[2];
    test::linear().support(level, j, ab);
    return ab[0] + u[0] * (ab[1] - ab[0]);
  };
  EXPECT_EQ(complaint(family).substr(0, 80),
            "distribution: sampler does not follow the function: level 0, function 0: a share");
  family.sample = [](uint32_t level, uint32_t j, const double* u) {
    const double x = test::linear().sample(level, j, u);
    return level == AWD_BASIS_MAX_LEVEL && j > 0 ? x - 0x1p-20 : x;
  };
  EXPECT_EQ(complaint(family).substr(0, 61),
            "samples: sample lies outside the support: level 20, function ");
}

TEST(Checks, DependentFunctionsMakeTheGramMatrixSingular) {
  // Two functions on one cell, both 1/2.
  AWDBasisFamily family = test::linear();
  family.maxLevel = 0;
  family.sampleDims = 1;
  family.eval = [](uint32_t, double, uint32_t* first, double* values) {
    *first = 0;
    values[0] = values[1] = 0.5;
    return 2u;
  };
  family.weight = [](uint32_t, uint32_t) { return 0.5; };
  family.sample = [](uint32_t, uint32_t, const double* u) { return u[0]; };
  EXPECT_EQ(complaint(family).substr(0, 79),
            "gram: Gram matrix can't be solved: level 0: function 1 is a combination of othe");
}

TEST(Checks, APolynomialWithANegativeCoefficientIsRefused) {
  // (1-2t)^2 and 4t(1-t): non-negative, sum to 1, and yet not from [0, inf) in Bernstein form.
  AWDBasisFamily family = test::quadratic();
  family.maxLevel = 0;
  family.count = [](uint32_t) { return 2u; };
  family.eval = [](uint32_t, double x, uint32_t* first, double* values) {
    *first = 0;
    values[0] = (1 - 2 * x) * (1 - 2 * x);
    values[1] = 1 - values[0];
    return 2u;
  };
  EXPECT_EQ(complaint(family).substr(0, 98),
            "coefficients: a Bernstein coefficient is negative: level 0, cell 0, function 0, "
            "coefficient 1: got");
}

TEST(Checks, FlagsMustBeTrue) {
  AWDBasisFamily family = test::linear();
  family.flags = AWD_BASIS_ORTHOGONAL;
  EXPECT_EQ(complaint(family).substr(0, 60),
            "orthogonal: flag ORTHOGONAL is not true: level 0: functions ");
  family.flags = AWD_BASIS_NESTED;
  EXPECT_EQ(complaint(family),
            "nested: flag NESTED is not true: level 1: the support of function 1, 0 to 1, is in no "
            "cell of size 1/2");
  family.flags = AWD_BASIS_PERIODIC;
  EXPECT_EQ(complaint(family).substr(0, 37), "periodic: flag PERIODIC is not true: ");
  family = test::linearPeriodic();
  family.flags = 0;
  EXPECT_EQ(complaint(family), "values: eval: functions 0 to 1, but level 0 has 1");
}

TEST(Checks, NestedFamiliesAreCopiesOfLevelZero) {
  AWDBasisFamily family = test::haar();
  family.minLevel = 1;
  EXPECT_EQ(complaint(family),
            "tree sizes: flag NESTED: levels 1 to 20: they must be 0 to at least 1");
  family.minLevel = family.maxLevel = 0;
  EXPECT_EQ(complaint(family),
            "tree sizes: flag NESTED: levels 0 to 0: they must be 0 to at least 1");
  // From level 1 on, a level too far.
  family = test::haar();
  family.maxLevel = 6;
  family.count = family.cells = [](uint32_t level) { return level > 0 ? 2u << level : 1u; };
  family.support = [](uint32_t level, uint32_t j, double ab[2]) {
    test::haar().support(level > 0 ? level + 1 : 0, j, ab);
  };
  family.weight = [](uint32_t level, uint32_t) { return 1.0 / (level > 0 ? 2u << level : 1u); };
  family.eval = [](uint32_t level, double x, uint32_t* first, double* values) {
    return test::haar().eval(level > 0 ? level + 1 : 0, x, first, values);
  };
  family.sample = [](uint32_t level, uint32_t j, const double* u) {
    return test::haar().sample(level > 0 ? level + 1 : 0, j, u);
  };
  family.twoScale = [](uint32_t level, uint32_t j, uint32_t* first, double* h) {
    *first = 2 * j;
    h[0] = h[1] = h[2] = h[3] = 1.0;
    return level > 0 ? 2u : 4u;
  };
  EXPECT_EQ(complaint(family),
            "tree sizes: flag NESTED is not true: level 1 has 4 functions, want those of 2 copies "
            "of level 0, 2");
  // The two functions of level 1 in the wrong order.
  family = test::haar();
  family.eval = [](uint32_t level, double x, uint32_t* first, double* values) {
    const uint32_t size = test::haar().eval(level, x, first, values);
    if (level == 1) *first = 1 - *first;
    return size;
  };
  for (const uint32_t l : {0u, 1u, 2u}) {
    Check check("copies", 1e-11);
    checkCopies(TestedLevel(family, l), check);
    EXPECT_EQ(check.ok(), l != 1);
    const char* const sentence =
        "flag NESTED is not true: level 1, function 0, x = 0.068333333333333329: got 0, but "
        "function 0 of level 0 is 1 there";
    EXPECT_EQ(check.sentence(), l == 1 ? sentence : "");
  }
}

TEST(Checks, WaveletsMustBeWhatTheyClaim) {
  AWDBasisFamily family = test::haar();
  family.vanishingMoments = 2;
  EXPECT_EQ(complaint(family),
            "vanishing moments: wavelet 0 has not the 2 vanishing moments claimed: int x^1 psi is "
            "-0.25 of its norm, want 0");
  family.wavelet = [](uint32_t, double* g) { g[0] = g[1] = 0.5; };
  EXPECT_EQ(complaint(family),
            "vanishing moments: wavelet 0 carries mass: its integral is 1 of its norm, want 0");
  family.vanishingMoments = 1;
  family.wavelet = [](uint32_t, double* g) { g[0] = g[1] = 0.0; };
  EXPECT_EQ(complaint(family),
            "wavelets: wavelets do not determine level 1: wavelet 0 is a combination of level 0 "
            "and the wavelets before it (squared distance 0 of 1)");
  family.wavelet = nullptr;
  EXPECT_EQ(complaint(family), "table: vanishingMoments is 1: it must be 0 without wavelets");
  family.vanishingMoments = 0;
  EXPECT_EQ(complaint(family), "") << "the library finds wavelets";
  family = test::haar();
  family.vanishingMoments = 0;
  EXPECT_EQ(complaint(family), "table: vanishingMoments is 0: it must be 1 to 8 with wavelets");
  family.flags = AWD_BASIS_ORTHOGONAL;
  family.vanishingMoments = 1;
  EXPECT_EQ(complaint(family), "table: wavelets are given without the flag NESTED");
}

}  // namespace
