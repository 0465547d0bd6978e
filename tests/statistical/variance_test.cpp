// SPDX-License-Identifier: Apache-2.0
// The film's variance is honest: over independent seeds the pixel means scatter as it says, where
// samples are independent, and no more than it says with Sobol's points.
#include <gtest/gtest.h>

#include <cstdio>

#include "support/films.h"
#include "support/scenes.h"

namespace {

using namespace awdtest;

constexpr uint32_t kSize = 8;

struct Seeds {
  size_t runs = 0, values = 0;
  std::vector<std::vector<double>> means, variances;  // [run][pixel], green
};

Seeds renderSeeds(AWDGuide guide, AWDPoints points, const std::vector<uint32_t>& passes,
                  size_t runs) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  Seeds seeds;
  seeds.runs = runs;
  seeds.values = size_t{kSize} * kSize;
  for (size_t run = 0; run < runs; ++run) {
    AWDRenderDesc desc = renderDesc(view, guide, 500 + run);
    desc.points = points;
    const Film film = renderFilm(scene, desc, passes);
    std::vector<double> mean, variance;
    for (size_t i = 0; i < seeds.values; ++i) {
      mean.push_back(film.radiance[3 * i + 1]);
      variance.push_back(film.variance[3 * i + 1]);
    }
    seeds.means.push_back(mean);
    seeds.variances.push_back(variance);
  }
  return seeds;
}

/// Per pixel the mean over runs.
std::vector<double> averages(const std::vector<std::vector<double>>& runs) {
  std::vector<double> result(runs[0].size());
  for (const std::vector<double>& run : runs) {
    for (size_t i = 0; i < run.size(); ++i) result[i] += run[i] / static_cast<double>(runs.size());
  }
  return result;
}

/// d_r = sum over pixels of (x_r - mean)^2 R/(R-1) / v - v_r / v has mean 0 if reported and
/// empirical variance agree, whatever the distribution of x; its z over the runs is tested at a
/// false-alarm rate of 0.1 % (two-sided). It sees a misreport of about 3 standard errors, which the
/// test prints. The score is below 0 where pixels scatter less than is reported.
double scatterScore(const Seeds& seeds) {
  const std::vector<double> mean = averages(seeds.means), reported = averages(seeds.variances);
  const double runs = static_cast<double>(seeds.runs);
  std::vector<double> d(seeds.runs);
  double ratio = 0.0;
  size_t used = 0;
  for (size_t i = 0; i < seeds.values; ++i) {
    if (reported[i] == 0.0) continue;
    ++used;
    for (size_t r = 0; r < seeds.runs; ++r) {
      const double off = seeds.means[r][i] - mean[i];
      const double scatter = off * off * runs / (runs - 1.0) / reported[i];
      d[r] += scatter - seeds.variances[r][i] / reported[i];
      ratio += scatter / runs;
    }
  }
  EXPECT_GT(used, seeds.values / 2);
  double sum = 0.0, squares = 0.0;
  for (const double x : d) {
    sum += x / runs;
    squares += x * x / runs;
  }
  const double error = std::sqrt((squares - sum * sum) / (runs - 1.0));
  std::printf("  empirical / reported variance %.4f, standard error %.4f, z %.2f\n",
              ratio / static_cast<double>(used), error / static_cast<double>(used), sum / error);
  EXPECT_LT(error / static_cast<double>(used), 0.05) << "too few runs to tell";
  return sum / error;
}

TEST(Variance, OnePassOfCosineSlow) {
  const Seeds seeds = renderSeeds(AWD_GUIDE_COSINE, AWD_POINTS_RANDOM, {24}, 400);
  EXPECT_LT(std::fabs(scatterScore(seeds)), familyThreshold(0.001, 1));
}

TEST(Variance, ManyPassesWithAdaptingSlow) {
  const Seeds seeds = renderSeeds(AWD_GUIDE_ADAPTIVE, AWD_POINTS_RANDOM, {8, 8, 16}, 300);
  EXPECT_LT(std::fabs(scatterScore(seeds)), familyThreshold(0.001, 1));
}

/// Null hypothesis: Sobol's points scatter as independent ones would. It must be rejected, on the
/// side of less: strata that bring nothing would be an error in them.
TEST(Variance, SobolPointsScatterLessSlow) {
  const double limit = familyThreshold(0.001, 1);
  EXPECT_LT(scatterScore(renderSeeds(AWD_GUIDE_COSINE, AWD_POINTS_SOBOL, {24}, 400)), -limit);
  EXPECT_LT(scatterScore(renderSeeds(AWD_GUIDE_ADAPTIVE, AWD_POINTS_SOBOL, {8, 8, 16}, 300)),
            -limit);
}

/// Chi-square proper: the sum over R runs and P pixels of squared deviations over the variance has
/// P (R - 1) degrees of freedom where pixel means are normal, as they nearly are after 512 samples
/// of a smoothly lit wall. False-alarm rate 0.1 %.
TEST(Variance, NormalPixelsAreChiSquareSlow) {
  SceneBuilder builder;
  const uint32_t wall = builder.material(grey(0.5)), lamp = builder.material(grey(0.0), grey(4.0));
  builder.quad({-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}, wall);
  builder.quad({-1, -1, 2}, {-1, 1, 2}, {1, 1, 2}, {1, -1, 2}, lamp);
  const Device device = newDevice();
  const Scene scene = builder.commit(device);
  const AWDCamera view = camera({-2, 0, 1}, {0, 0, 0}, {0, 0, 1}, 0.25, kSize, kSize);
  constexpr size_t kRuns = 64, kPixels = kSize * kSize;
  std::vector<std::vector<double>> means, variances;
  for (size_t run = 0; run < kRuns; ++run) {
    AWDRenderDesc desc = renderDesc(view, AWD_GUIDE_COSINE, 900 + run);
    desc.direct = AWD_DIRECT_AREA;
    desc.shadowRays = 1;
    desc.points = AWD_POINTS_RANDOM;
    const Film film = renderFilm(scene, desc, {512});
    means.emplace_back(), variances.emplace_back();
    for (size_t i = 0; i < kPixels; ++i) {
      means.back().push_back(film.radiance[3 * i]);
      variances.back().push_back(film.variance[3 * i]);
    }
  }
  const std::vector<double> mean = averages(means), variance = averages(variances);
  double chiSquare = 0.0;
  for (size_t i = 0; i < kPixels; ++i) {
    ASSERT_GT(variance[i], 0.0);
    for (size_t r = 0; r < kRuns; ++r) {
      chiSquare += (means[r][i] - mean[i]) * (means[r][i] - mean[i]) / variance[i];
    }
  }
  const double degrees = kPixels * (kRuns - 1.0), tail = chiSquareTail(chiSquare, degrees);
  std::printf("  chi-square %.1f of %.0f degrees, P = %.4f\n", chiSquare, degrees, tail);
  EXPECT_GT(tail, 0.0005);
  EXPECT_LT(tail, 0.9995);
}

/// One sample has no variance to report.
TEST(Variance, IsZeroBelowTwoSamples) {
  const Device device = newDevice();
  const Scene scene = lampRoom().commit(device);
  const AWDCamera view = lampRoomCamera(kSize);
  const Film film = renderFilm(scene, renderDesc(view, AWD_GUIDE_COSINE, 1), {1});
  EXPECT_EQ(film.variance, std::vector<float>(film.variance.size(), 0.0f));
}

}  // namespace
