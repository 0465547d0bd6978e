// SPDX-License-Identifier: Apache-2.0
// How trees grow and shrink.
#include <gtest/gtest.h>

#include <algorithm>

#include "density/learning.h"

namespace {

using namespace awdtest;

using Trees = Learning;

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

TEST_F(Trees, ATreeSplitsAtASpike) {
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
TEST_F(Trees, ATreeSplitsWhereHalvesAreAlike) {
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

TEST_F(Trees, ATreeThatWasRefinedForNothingCoarsens) {
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
TEST_F(Trees, ATreeDoesNotLearnNoise) {
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
TEST_F(Trees, ATreeCoarsensWhereThereIsNothingToSee) {
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
TEST_F(Trees, TreesDoNotGoByUnits) {
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

}  // namespace
