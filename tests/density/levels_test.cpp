// SPDX-License-Identifier: Apache-2.0
// Levels: the shrinkage over them, and how many there are.
#include <gtest/gtest.h>

#include <algorithm>

#include "density/learning.h"
#include "density/reference.h"

namespace {

using namespace awdtest;

using Levels = Learning;

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

TEST_F(Levels, CascadeByBruteForce) {
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

TEST_F(Levels, LevelsGoBySampleCount) {
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

TEST_F(Levels, FixedLevelsStay) {
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

TEST_F(Levels, MaxCoefficientsAreHonoured) {
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

}  // namespace
