// SPDX-License-Identifier: Apache-2.0
// What densities make of samples of known functions: each estimator, the floor, the shrinkage over
// levels, and how levels and trees grow and shrink.
#include <gtest/gtest.h>

#include <algorithm>

#include "density/densities.h"
#include "density/reference.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

constexpr double kNone = -1.0;  // no floor, no cascade

class Learning : public testing::Test {
 protected:
  /// One pass over `f` with evenly spaced uniforms (of two numbers: a square of them).
  AWDDensityReport evenPass(AWDDensity density, size_t count, const Function& f) const {
    const uint32_t width = infoOf(density).uniforms;
    const auto side = width == 1 ? count : static_cast<size_t>(std::sqrt(double(count)));
    std::vector<double> uniforms;
    for (size_t i = 0; i < side; ++i) {
      for (size_t k = 0; k < (width == 1 ? 1 : side); ++k) {
        uniforms.push_back((double(i) + 0.5) / double(side));
        if (width > 1) uniforms.push_back((double(k) + 0.5) / double(side));
      }
    }
    Samples samples = drawWith(density, uniforms);
    samples.evaluate(f);
    record(density, samples);
    return adapt(density);
  }

  Device device_ = newDevice(1u);
};

void expectNear(const std::vector<double>& seen, const std::vector<double>& expected,
                double tolerance) {
  ASSERT_EQ(seen.size(), expected.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    EXPECT_NEAR(seen[i], expected[i], tolerance * (1.0 + std::fabs(expected[i]))) << i;
  }
}

double square(const double* x) { return x[0] * x[0]; }

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

/// c_{-1} = S1/S0 of all samples, then c_L = (n_j r_j + kappa P c_{L-1}) / (n_j + kappa) up to the
/// finest level with n <= 2m, and P from there on: by sums over all functions at all samples.
class Cascade {
 public:
  Cascade(const char* basis, uint32_t dimensions, double kappa, const Samples& samples)
      : basis_(basis), d_(dimensions), kappa_(kappa), samples_(samples) {}

  std::vector<double> run(uint32_t levels, uint32_t& estimated) const {
    double value = 0.0, weight = 0.0;
    for (size_t i = 0; i < samples_.size(); ++i) {
      value += std::fabs(samples_.values[i]) / samples_.pdfs[i];
      weight += 1.0 / samples_.pdfs[i];
    }
    std::vector<double> c = {value / weight};
    estimated = 0;
    for (uint32_t level = 0; level <= levels; ++level) {
      c = level == 0 ? std::vector<double>(size(level), c[0]) : refined(c, level - 1);
      if (level > 0 && size(level) > 2 * samples_.size()) continue;
      ++estimated;
      shrink(c, level);
    }
    return c;
  }

 private:
  size_t side(uint32_t level) const { return referenceValues(basis_, level, 0.0).size(); }
  size_t size(uint32_t level) const { return d_ == 1 ? side(level) : side(level) * side(level); }
  void shrink(std::vector<double>& c, uint32_t level) const {
    std::vector<double> s1(c.size()), s0(c.size()), n(c.size());
    for (size_t i = 0; i < samples_.size(); ++i) {
      const std::vector<double> first = referenceValues(basis_, level, samples_.point(i)[0]);
      const std::vector<double> second =
          d_ == 1 ? std::vector<double>{1.0} : referenceValues(basis_, level, samples_.point(i)[1]);
      for (size_t j = 0; j < c.size(); ++j) {
        const double value = first[j / second.size()] * second[j % second.size()];
        s1[j] += std::fabs(samples_.values[i]) * value / samples_.pdfs[i];
        s0[j] += value / samples_.pdfs[i];
        n[j] += value;
      }
    }
    for (size_t j = 0; j < c.size(); ++j) {
      if (s0[j] > 0.0) c[j] = (n[j] * s1[j] / s0[j] + kappa_ * c[j]) / (n[j] + kappa_);
    }
  }
  /// Of Haar a box's value for both halves, of hats the middle of neighbours between them.
  std::vector<double> refined(const std::vector<double>& c, uint32_t level) const {
    const size_t n = side(level), m = side(level + 1);
    const auto source = [&](size_t fine, size_t which) {
      return m == 2 * n ? fine / 2 : (fine + which) / 2;
    };
    std::vector<double> out;
    for (size_t j = 0; j < m; ++j) {
      for (size_t k = 0; k < (d_ == 1 ? 1 : m); ++k) {
        double sum = 0.0;
        for (size_t corner = 0; corner < 4; ++corner) {
          const size_t row = source(j, corner / 2), column = source(k, corner % 2);
          sum += 0.25 * (d_ == 1 ? c[row] : c[row * n + column]);
        }
        out.push_back(sum);
      }
    }
    return out;
  }

  const char* basis_;
  uint32_t d_;
  double kappa_;
  const Samples& samples_;
};

TEST_F(Learning, CascadeByBruteForce) {
  for (const char* basis : {"haar", "linear-bspline"}) {
    for (const uint32_t d : {1u, 2u}) {
      for (const size_t count : {1u, 2u, 4u, 12u, 60u}) {
        for (const double kappa : {0.0, 0.2, 5.0}) {
          SCOPED_TRACE(std::string(basis) + ", " + std::to_string(d) + " dimensions, " +
                       std::to_string(count) + " samples, kappa " + std::to_string(kappa));
          AWDDensityDesc desc = gridDesc();
          desc.estimator = AWD_ESTIMATOR_QUASI;
          desc.shrinkage = kappa;
          desc.tau = 0.05;
          const Density density = newDensity(device_, Axes(d, fixedAxis(basis, 3)), desc);
          Random random(13 + count);
          setRandomCoefficients(density, random);
          const Samples samples = draw(density, count, random, [d](const double* x) {
            return 0.1 - std::exp(-3.0 * x[0] - (d > 1 ? x[1] : 0.0));
          });
          record(density, samples);
          const AWDDensityReport report = adapt(density);

          const double used = kappa > 0.0 ? kappa : isPiecewiseConstant(basis) ? 2.0 : 0.5;
          uint32_t estimated;
          std::vector<double> expected = Cascade(basis, d, used, samples).run(3, estimated);
          EXPECT_EQ(report.estimatedLevels, estimated);
          // All above the floor; to a density by the weights, 1/cells but half of it at the ends.
          const Density normalised = newDensity(device_, Axes(d, fixedAxis(basis, 3)));
          setCoefficients(normalised, expected);
          expectNear(coefficientsOf(density), coefficientsOf(normalised), 1e-7);
        }
      }
    }
  }
}

TEST_F(Learning, LevelsGoBySampleCount) {
  // The finest level l with 2^l + 1 <= 2 samples.
  const auto level = [&](uint64_t samples) {
    uint32_t l = 0;
    while ((uint64_t{2} << l) + 1 <= 2 * samples) ++l;
    return l;
  };
  AWDDensityDesc desc = gridDesc();
  desc.passSamples = 20;
  const AWDDensityAxis axis = {"linear-bspline", 0, 0};
  const Density density = newDensity(device_, {axis}, desc);
  EXPECT_EQ(axisInfoOf(density, 0).level, level(20));
  Random random(14);
  for (const size_t samples : {10u, 50u, 300u, 4u, 1000u}) {
    pass(density, samples, random, square);
    // For a pass twice as long as the last, or as long as was said.
    EXPECT_EQ(axisInfoOf(density, 0).level, level(std::max<uint64_t>(2 * samples, 20)));
  }
  EXPECT_EQ(axisInfoOf(newDensity(device_, {axis}), 0).level, level(1024)) << "by default";
}

TEST_F(Learning, FixedLevelsStay) {
  AWDDensityDesc desc = gridDesc();
  Random random(15);
  for (const char* basis : kFamilies) {
    const Density density = newDensity(
        device_, {fixedAxis(basis, 5), fixedAxis(basis, 2), {basis, 0, AWD_LEVEL(3)}}, desc);
    for (const size_t samples : {0u, 1u, 50u, 5000u}) {
      pass(density, samples, random, square);
      EXPECT_EQ(axisInfoOf(density, 0).level, 5u) << basis << ' ' << samples;
      EXPECT_EQ(axisInfoOf(density, 1).level, 2u) << basis << ' ' << samples;
      EXPECT_LE(axisInfoOf(density, 2).level, 3u) << basis << ' ' << samples;
    }
    EXPECT_GE(axisInfoOf(density, 2).level, 2u) << basis;
  }
  // A tree whose halvings are fixed neither splits nor coarsens.
  for (const char* basis : kNested) {
    const Density density =
        newDensity(device_, {fixedAxis(basis, 2), fixedAxis(basis, 1)}, treeDesc());
    const std::vector<double> before = leavesOf(density);
    for (const size_t samples : {1u, 50u, 5000u}) {
      pass(density, samples, random, [](const double* x) { return bump(x, 2, 0.05); });
      EXPECT_EQ(leavesOf(density), before) << basis;
    }
  }
}

/// Volume of the leaf that holds (0.3, 0.7).
double volumeAtTheSpike(AWDDensity density) {
  const std::vector<double> boxes = leavesOf(density);
  for (size_t i = 0; i < boxes.size(); i += 4) {
    const double* b = &boxes[i];
    if (b[0] <= 0.3 && 0.3 < b[2] && b[1] <= 0.7 && 0.7 < b[3]) {
      return (b[2] - b[0]) * (b[3] - b[1]);
    }
  }
  return 0.0;
}

TEST_F(Learning, ATreeSplitsAtASpike) {
  for (const char* basis : kNested) {
    SCOPED_TRACE(basis);
    const Density density =
        newDensity(device_, {axisFrom(basis, 0, 20), axisFrom(basis, 0, 20)}, treeDesc());
    Random random(16);
    uint64_t split = 0;
    for (int k = 0; k < 6; ++k) {
      split += pass(density, 2000, random, [](const double* x) {
                 const double u = (x[0] - 0.3) / 0.01, v = (x[1] - 0.7) / 0.01;
                 return 1e-3 + std::exp(-0.5 * (u * u + v * v));
               }).split;
    }
    EXPECT_GT(split, 20u);
    EXPECT_LT(volumeAtTheSpike(density), 1e-4);
    double largest = 0.0;
    const std::vector<double> boxes = leavesOf(density);
    for (size_t i = 0; i < boxes.size(); i += 4) {
      largest = std::max(largest, (boxes[i + 2] - boxes[i]) * (boxes[i + 3] - boxes[i + 1]));
    }
    EXPECT_GT(largest, 1e-2) << "and stays coarse elsewhere";
    EXPECT_GT(integralOver(density, {0.27, 0.67}, {0.33, 0.73}), 0.3);
  }
}

/// Halving the square along either axis leaves halves of equal means: only the potential tells.
TEST_F(Learning, ATreeSplitsWhereHalvesAreAlike) {
  for (const char* basis : kNested) {
    SCOPED_TRACE(basis);
    const Density density =
        newDensity(device_, {axisFrom(basis, 0, 12), axisFrom(basis, 0, 12)}, treeDesc());
    EXPECT_EQ(infoOf(density).leaves, 1u);
    Random random(17);
    const auto ridge = [](const double* x) {
      return std::fabs(x[0] - x[1]) < 0.02 || std::fabs(x[0] + x[1] - 1.0) < 0.02 ? 1.0 : 0.0;
    };
    for (int k = 0; k < 6; ++k) pass(density, 4000, random, ridge);
    EXPECT_GT(infoOf(density).leaves, 100u);
    const Samples samples = draw(density, 4000, random, ridge);
    double hits = 0.0;
    for (const double f : samples.values) hits += f / 4000.0;
    EXPECT_GT(hits, 0.4) << "of 0.08 from equal shares";
  }
}

TEST_F(Learning, ATreeThatWasRefinedForNothingCoarsens) {
  const Function functions[] = {[](const double*) { return 1.0; },
                                [](const double*) { return 0.3; }};
  for (const char* basis : kNested) {
    for (const Function& f : functions) {
      SCOPED_TRACE(basis);
      const Density density =
          newDensity(device_, {axisFrom(basis, 0, 8), axisFrom(basis, 0, 8)}, treeDesc());
      for (int k = 0; k < 3; ++k) must(awdRefineDensity(density, AWD_ALL_AXES));
      const AWDDensityInfo before = infoOf(density);
      EXPECT_EQ(before.leaves, 64u);
      Random random(18);
      const AWDDensityReport report = pass(density, 20000, random, f);
      EXPECT_EQ(report.coarsened, before.coefficients / 64 * 63);
      EXPECT_EQ(report.split, 0u);
      EXPECT_EQ(infoOf(density).leaves, 1u);
      expectNear(coefficientsOf(density), std::vector<double>(before.coefficients / 64, 1.0), 1e-9);
    }
  }
}

/// f is 1 with noise of its own at every point, of variance 1/12. How far p is from constant adds
/// int p^2 - 1 to a relative variance: what is learned from noise stays below it.
TEST_F(Learning, ATreeDoesNotLearnNoise) {
  for (const char* basis : kNested) {
    SCOPED_TRACE(basis);
    const Density density =
        newDensity(device_, {axisFrom(basis, 0, 8), axisFrom(basis, 0, 8)}, treeDesc());
    for (int k = 0; k < 3; ++k) must(awdRefineDensity(density, AWD_ALL_AXES));
    Random random(27), noise(28);
    for (int k = 0; k < 4; ++k) {
      const AWDDensityReport report =
          pass(density, 4000, random, [&](const double*) { return 0.5 + noise.uniform(); });
      EXPECT_GT(report.coarsened, 0u);
      double squares = 0.0;
      for (const double c : coefficientsOf(density, AWD_COEFFICIENTS_ORTHONORMAL)) squares += c * c;
      EXPECT_LT(squares - 1.0, 0.5 / 12.0);
    }
  }
}

/// The corner of a tree that sees all of f keeps its leaves, the other, refined for nothing, none.
TEST_F(Learning, ATreeCoarsensWhereThereIsNothingToSee) {
  const Density density = newDensity(device_, {axisFrom("haar", 0, 10)}, treeDesc());
  for (int k = 0; k < 6; ++k) must(awdRefineDensity(density, 0));
  Random random(19);
  const AWDDensityReport report =
      pass(density, 20000, random, [](const double* x) { return x[0] < 0.5 ? 1.0 : x[0] * 9; });
  EXPECT_GE(report.coarsened, 30u);
  const std::vector<double> boxes = leavesOf(density);
  EXPECT_EQ(boxes[0], 0.0);
  EXPECT_EQ(boxes[1], 0.5) << "the first leaf is the lower half";
  EXPECT_GT(boxes.size() / 2, 8u);
}

/// In which units f is told is no reason to halve a box, but for one on the brink of rounding.
TEST_F(Learning, TreesDoNotGoByUnits) {
  for (const char* basis : kNested) {
    for (const AWDTarget target : {AWD_TARGET_MEAN, AWD_TARGET_RMS}) {
      SCOPED_TRACE(std::string(basis) + ", target " + std::to_string(target));
      AWDDensityReport usual = AWD_DENSITY_REPORT_INIT;
      for (const double unit : {1.0, 3.0, 1e-4, 1e7}) {
        AWDDensityDesc desc = treeDesc();
        desc.target = target;
        const Density density = newDensity(device_, {{basis, 0, 0}, {basis, 0, 0}}, desc);
        Random random(25);
        const AWDDensityReport report =
            pass(density, 2000, random, [unit](const double* x) { return unit * bump(x, 2, 0.1); });
        if (unit == 1.0) usual = report;
        EXPECT_NEAR(double(report.split), double(usual.split), 3.0) << unit;
        EXPECT_NEAR(double(report.coarsened), double(usual.coarsened), 30.0) << unit;
      }
      EXPECT_GT(usual.split, 50u);
    }
  }
}

TEST_F(Learning, MaxCoefficientsAreHonoured) {
  Random random(20);
  for (const uint64_t most : {9u, 64u, 300u}) {
    for (const char* basis : kFamilies) {
      for (const AWDDensityStructure structure : {AWD_STRUCTURE_GRID, AWD_STRUCTURE_TREE}) {
        AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
        desc.structure = structure;
        desc.maxCoefficients = most;
        const AWDDensityAxis axis = {basis, 0, 0};
        Density density;
        if (structure == AWD_STRUCTURE_TREE && std::find(std::begin(kNested), std::end(kNested),
                                                         std::string(basis)) == std::end(kNested)) {
          continue;
        }
        density = newDensity(device_, {axis, axis}, desc);
        for (int k = 0; k < 3; ++k) {
          const AWDDensityReport report =
              pass(density, 1000, random, [](const double* x) { return bump(x, 2, 0.02); });
          EXPECT_LE(report.coefficients, most) << basis;
          EXPECT_EQ(report.coefficients, infoOf(density).coefficients);
        }
        EXPECT_GE(4 * infoOf(density).coefficients, most) << basis << ": and used";
      }
    }
  }
}

/// Mean of (f/p)^2 over mean^2, less 1: the variance of one sample in units of the squared
/// integral.
double relativeVariance(AWDDensity density, Random& random, const Function& f) {
  const Samples samples = draw(density, 3000, random, f);
  double mean = 0.0, squares = 0.0;
  for (size_t i = 0; i < samples.size(); ++i) {
    const double ratio = samples.values[i] / samples.pdfs[i];
    mean += ratio;
    squares += ratio * ratio;
  }
  return squares * double(samples.size()) / (mean * mean) - 1.0;
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
