// SPDX-License-Identifier: Apache-2.0
// Densities of random coefficients, of every family, as a grid and as a tree: values, masses and
// points belong together.
#include <gtest/gtest.h>

#include <algorithm>

#include "density/densities.h"
#include "density/reference.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

constexpr double kBelowOne = 1.0 - 0x1p-53;
constexpr double kFalseAlarm = 1e-3;

struct Case {
  std::string name;
  AWDDensityStructure structure;
  Axes axes;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (uint32_t d = 1; d <= 3; ++d) {
    for (const char* basis : kFamilies) {
      all.push_back({basis, AWD_STRUCTURE_GRID, Axes(d, fixedAxis(basis, 4 - d))});
    }
    for (const char* basis : kNested) {
      all.push_back({basis, AWD_STRUCTURE_TREE, Axes(d, axisFrom(basis, 0, 3))});
    }
  }
  all.push_back({"mixed",
                 AWD_STRUCTURE_GRID,
                 {fixedAxis("haar", 3), fixedAxis("quadratic-bspline-periodic", 2),
                  fixedAxis("m3", 1), fixedAxis("linear-bspline", 0)}});
  all.push_back({"mixed",
                 AWD_STRUCTURE_TREE,
                 {axisFrom("m2", 0, 2), axisFrom("haar", 0, 3), axisFrom("m3", 0, 1)}});
  all.push_back({"linear-bspline", AWD_STRUCTURE_GRID, Axes(6, fixedAxis("linear-bspline", 1))});
  all.push_back(
      {"quadratic-bspline", AWD_STRUCTURE_GRID, Axes(6, fixedAxis("quadratic-bspline", 0))});
  all.push_back({"m2", AWD_STRUCTURE_TREE, Axes(6, axisFrom("m2", 0, 1))});
  return all;
}

class Sampling : public testing::Test {
 protected:
  /// Of random coefficients; a tree has leaves of several sizes.
  Density make(const Case& c, AWDSampler sampler, bool zeros, uint64_t seed = 1) const {
    AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
    desc.structure = c.structure;
    desc.sampler = sampler;
    Random random(seed);
    Density density = newDensity(device_, c.axes, desc);
    if (c.structure == AWD_STRUCTURE_TREE) {
      const auto d = static_cast<uint32_t>(c.axes.size());
      pass(density, 40, random, [d](const double* x) { return bump(x, d, 0.1); });
      EXPECT_GT(infoOf(density).leaves, 2u);
    }
    setRandomCoefficients(density, random, zeros);
    return density;
  }

  /// Runs the test on every case, as a grid with both samplers.
  template <class Test>
  void forEach(Test&& test) const {
    for (const Case& c : cases()) {
      const bool tree = c.structure == AWD_STRUCTURE_TREE;
      for (const AWDSampler sampler : {AWD_SAMPLER_INVERSE_CDF, AWD_SAMPLER_COMPONENT}) {
        if (tree && sampler == AWD_SAMPLER_COMPONENT) continue;
        SCOPED_TRACE(c.name + (tree ? " tree, " : " grid, ") + std::to_string(c.axes.size()) +
                     " dimensions, sampler " + std::to_string(sampler));
        test(c, sampler);
      }
    }
  }

  Device device_ = newDevice(1u);
};

/// Sum over all functions, of the leaf that holds x.
double bruteForce(AWDDensity density, const Case& c, const std::vector<double>& leaves,
                  const std::vector<double>& coefficients, const double* x) {
  const size_t d = c.axes.size();
  std::vector<std::vector<double>> values(d);
  if (c.structure == AWD_STRUCTURE_GRID) {
    for (uint32_t a = 0; a < d; ++a) {
      values[a] = referenceValues(c.axes[a].basis, axisInfoOf(density, a).level, x[a]);
    }
    return tensorSum(coefficients.data(), values);
  }
  const size_t count = leaves.size() / (2 * d);
  for (size_t leaf = 0; leaf < count; ++leaf) {
    const double* lower = &leaves[2 * d * leaf];
    const double* upper = lower + d;
    bool inside = true;
    for (size_t a = 0; a < d; ++a) {
      inside = inside && lower[a] <= x[a] && (x[a] < upper[a] || (x[a] == 1.0 && upper[a] == 1.0));
    }
    if (!inside) continue;
    for (size_t a = 0; a < d; ++a) {
      const double t = (x[a] - lower[a]) / (upper[a] - lower[a]);
      values[a] = referenceValues(c.axes[a].basis, 0, t);
    }
    return tensorSum(&coefficients[coefficients.size() / count * leaf], values);
  }
  ADD_FAILURE() << "no leaf holds the point";
  return -1.0;
}

TEST_F(Sampling, ThePdfIsTheSumOfItsFunctions) {
  forEach([&](const Case& c, AWDSampler sampler) {
    if (sampler != AWD_SAMPLER_INVERSE_CDF) return;
    const Density density = make(c, sampler, true);
    const std::vector<double> leaves = leavesOf(density), coefficients = coefficientsOf(density);
    const size_t d = c.axes.size();
    Random random(2);
    for (int i = 0; i < 100; ++i) {
      std::vector<double> x(d);
      for (double& t : x) {
        const double u = random.uniform();
        // Ends and edges of cells too.
        t = u < 0.1 ? 0.0 : u < 0.2 ? 1.0 : u < 0.4 ? std::floor(u * 80.0) / 16.0 - 1.0 : u;
      }
      const double expected = bruteForce(density, c, leaves, coefficients, x.data());
      ASSERT_NEAR(pdfsAt(density, x)[0], expected, 1e-11 + 1e-12 * expected) << "point " << i;
    }
  });
}

TEST_F(Sampling, ASampleTellsThePdfOfItsPoint) {
  forEach([&](const Case& c, AWDSampler sampler) {
    const Density density = make(c, sampler, true);
    const uint64_t components =
        sampler == AWD_SAMPLER_COMPONENT ? infoOf(density).coefficients : AWD_INVALID_ID;
    Random random(3);
    const Samples samples = draw(density, 2000, random);
    EXPECT_TRUE(sameBits(samples.pdfs, pdfsAt(density, samples.points)));
    for (const double p : samples.pdfs) ASSERT_TRUE(p > 0.0 && std::isfinite(p)) << p;
    for (const double x : samples.points) ASSERT_TRUE(x >= 0.0 && x < 1.0) << x;
    for (const uint32_t j : samples.components) {
      ASSERT_TRUE(sampler == AWD_SAMPLER_COMPONENT ? j < components : j == components) << j;
    }
    // What is not asked for changes nothing, nor does drawing one at a time.
    Random again(3);
    const uint32_t width = infoOf(density).uniforms;
    const std::vector<double> uniforms = randomNumbers(2000 * width, again);
    std::vector<double> points(samples.points.size());
    must(awdSampleDensity(density, 1000, uniforms.data(), points.data(), nullptr, nullptr));
    for (size_t i = 1000; i < 2000; ++i) {
      must(awdSampleDensity(density, 1, &uniforms[i * width], &points[i * c.axes.size()], nullptr,
                            nullptr));
    }
    EXPECT_TRUE(sameBits(points, samples.points));
  });
}

/// Null hypothesis: points fall into boxes in proportion to their masses. About 60 tests of 16 to
/// 64 boxes each; false alarm in any of them: kFalseAlarm.
TEST_F(Sampling, PointsFallByMass) {
  constexpr size_t kSamples = 10000;
  size_t tests = 0;
  double least = 1.0;
  forEach([&](const Case& c, AWDSampler sampler) {
    const Density density = make(c, sampler, true);
    const size_t d = c.axes.size();
    const size_t side = d == 1 ? 32 : d == 2 ? 8 : d == 3 ? 4 : 2;
    size_t boxes = 1;
    for (size_t a = 0; a < d; ++a) boxes *= side;
    std::vector<double> expected(boxes), seen(boxes);
    for (size_t box = 0; box < boxes; ++box) {
      std::vector<double> lower(d), upper(d);
      size_t rest = box;
      for (size_t a = d; a-- > 0; rest /= side) {
        lower[a] = double(rest % side) / double(side);
        upper[a] = double(rest % side + 1) / double(side);
      }
      expected[box] = kSamples * integralOver(density, lower, upper);
    }
    Random random(4);
    const Samples samples = draw(density, kSamples, random);
    for (size_t i = 0; i < kSamples; ++i) {
      size_t box = 0;
      for (size_t a = 0; a < d; ++a) {
        box = box * side + static_cast<size_t>(samples.point(i)[a] * double(side));
      }
      seen[box] += 1.0;
    }
    // Boxes of too little mass count as one.
    double chiSquare = 0.0, fewExpected = 0.0, fewSeen = 0.0;
    int degrees = -1;
    for (size_t box = 0; box < boxes; ++box) {
      if (expected[box] < 5.0) {
        fewExpected += expected[box];
        fewSeen += seen[box];
        continue;
      }
      chiSquare += std::pow(seen[box] - expected[box], 2) / expected[box];
      ++degrees;
    }
    if (fewExpected >= 5.0) {
      chiSquare += std::pow(fewSeen - fewExpected, 2) / fewExpected;
      ++degrees;
    } else {
      EXPECT_LE(fewSeen, 25.0);  // of 5 expected at most: 1e-10
    }
    ASSERT_GE(degrees, 3);
    const double tail = chiSquareTail(chiSquare, degrees);
    EXPECT_GT(tail, kFalseAlarm / 100.0) << "chi-square " << chiSquare << " of " << degrees;
    least = std::min(least, tail);
    ++tests;
  });
  EXPECT_TRUE(tests > 50 && tests <= 100) << tests;
  RecordProperty("least", std::to_string(least));
}

/// Null hypothesis: the first coordinate follows its marginal. Kolmogorov-Smirnov's distance,
/// looked at on 1/128ths, beyond t / sqrt(n) has a probability of 2 exp(-2 t^2) at most.
TEST_F(Sampling, TheFirstCoordinateFollowsItsMarginal) {
  constexpr size_t kSamples = 10000;
  const double threshold = std::sqrt(std::log(2.0 * 100.0 / kFalseAlarm) / 2.0 / kSamples);
  forEach([&](const Case& c, AWDSampler sampler) {
    const Density density = make(c, sampler, true);
    const size_t d = c.axes.size();
    Random random(5);
    const Samples samples = draw(density, kSamples, random);
    std::vector<double> counts(128);
    for (size_t i = 0; i < kSamples; ++i) {
      counts[static_cast<size_t>(samples.point(i)[0] * 128.0)] += 1.0 / kSamples;
    }
    double below = 0.0;
    std::vector<double> upper(d, 1.0);
    for (size_t i = 0; i < counts.size(); ++i) {
      below += counts[i];
      upper[0] = double(i + 1) / 128.0;
      ASSERT_NEAR(below, integralOver(density, std::vector<double>(d), upper), threshold) << i;
    }
  });
}

TEST_F(Sampling, UniformsAtTheirEnds) {
  forEach([&](const Case& c, AWDSampler sampler) {
    for (const bool zeros : {false, true}) {
      const Density density = make(c, sampler, zeros);
      const uint32_t width = infoOf(density).uniforms;
      const std::vector<double> values =
          width > 4 ? std::vector<double>{0.0, kBelowOne}
                    : std::vector<double>{0.0, 0x1p-1074, 0x1p-53, 0.5, kBelowOne};
      size_t count = 1;
      for (uint32_t k = 0; k < width; ++k) count *= values.size();
      std::vector<double> uniforms;
      for (size_t i = 0; i < count; ++i) {
        size_t rest = i;
        for (uint32_t k = 0; k < width; ++k, rest /= values.size()) {
          uniforms.push_back(values[rest % values.size()]);
        }
      }
      const Samples samples = drawWith(density, uniforms);
      for (const double x : samples.points) ASSERT_TRUE(x >= 0.0 && x < 1.0) << x;
      for (size_t i = 0; i < count; ++i) {
        ASSERT_TRUE(samples.pdfs[i] > 0.0 && std::isfinite(samples.pdfs[i]))
            << samples.pdfs[i] << " for combination " << i << (zeros ? ", zeros" : "");
      }
      EXPECT_TRUE(sameBits(samples.pdfs, pdfsAt(density, samples.points)));
    }
  });
}

/// One uniform in each n-th part of [0,1): one point in each n-th part of the mass.
TEST_F(Sampling, StrataAreKept) {
  constexpr size_t kStrata = 1000;
  forEach([&](const Case& c, AWDSampler sampler) {
    // A tree of several dimensions halves boxes along any axis first: no marginal has strata.
    const size_t d = c.axes.size();
    if (sampler != AWD_SAMPLER_INVERSE_CDF) return;
    if (d > 2 || (c.structure == AWD_STRUCTURE_TREE && d > 1)) return;
    const Density density = make(c, sampler, true);
    Random random(6);
    std::vector<double> uniforms = randomNumbers(kStrata * d, random);
    for (size_t i = 0; i < kStrata; ++i) {
      uniforms[i * d] = std::min((double(i) + uniforms[i * d]) / double(kStrata), kBelowOne);
    }
    const Samples samples = drawWith(density, uniforms);
    for (size_t i = 0; i < kStrata; ++i) {
      std::vector<double> upper(d, 1.0);
      upper[0] = samples.point(i)[0];
      const double mass = integralOver(density, std::vector<double>(d), upper);
      ASSERT_NEAR(mass, uniforms[i * d], 1e-12) << i;
    }
  });
}

/// Two points of Gauss a cell: exact for polynomials up to degree 3 between all the edges.
TEST_F(Sampling, MassesAreIntegralsOfThePdf) {
  constexpr double kGauss[] = {0.21132486540518711775, 0.78867513459481288225};
  forEach([&](const Case& c, AWDSampler sampler) {
    if (sampler != AWD_SAMPLER_INVERSE_CDF) return;
    const Density density = make(c, sampler, true);
    const size_t d = c.axes.size();
    EXPECT_NEAR(integralOf(density), 1.0, 1e-14);
    Random random(7);
    for (int round = 0; round < 3; ++round) {
      // Per axis the edges of all cells between the ends of the box.
      const double finest = d <= 3 ? 16.0 : d == 4 ? 8.0 : 2.0;
      std::vector<double> lower(d), upper(d);
      std::vector<std::vector<double>> at(d), weight(d);
      for (size_t a = 0; a < d; ++a) {
        double ends[] = {random.uniform(), random.uniform()};
        if (round == 0 || ends[0] == ends[1]) ends[0] = 0.0, ends[1] = 1.0;
        lower[a] = std::min(ends[0], ends[1]);
        upper[a] = std::max(ends[0], ends[1]);
        std::vector<double> edges = {lower[a]};
        for (int k = 1; k < finest; ++k) {
          if (k / finest > lower[a] && k / finest < upper[a]) edges.push_back(k / finest);
        }
        edges.push_back(upper[a]);
        for (size_t k = 0; k + 1 < edges.size(); ++k) {
          for (const double t : kGauss) {
            at[a].push_back(edges[k] + t * (edges[k + 1] - edges[k]));
            weight[a].push_back(0.5 * (edges[k + 1] - edges[k]));
          }
        }
      }
      std::vector<double> points, weights;
      std::vector<size_t> index(d, 0);
      for (;;) {
        double w = 1.0;
        for (size_t a = 0; a < d; ++a) {
          points.push_back(at[a][index[a]]);
          w *= weight[a][index[a]];
        }
        weights.push_back(w);
        size_t a = 0;
        while (a < d && ++index[a] == at[a].size()) index[a++] = 0;
        if (a == d) break;
      }
      const std::vector<double> pdfs = pdfsAt(density, points);
      double sum = 0.0;
      for (size_t i = 0; i < pdfs.size(); ++i) sum += weights[i] * pdfs[i];
      EXPECT_NEAR(integralOver(density, lower, upper), sum, 1e-12);
    }
    EXPECT_EQ(integralOver(density, std::vector<double>(d, 0.3), std::vector<double>(d, 0.3)), 0.0);
  });
}

}  // namespace
