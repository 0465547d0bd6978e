// SPDX-License-Identifier: Apache-2.0
// A thousand million samples through one density: they stay where its pdf says, the sums of what is
// recorded stay exact, and no memory is taken.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "support/counting_allocator.h"
#include "support/handles.h"
#include "support/process.h"
#include "support/random.h"
#include "support/soak.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

using Density = Handle<AWDDensity, awdReleaseDensity>;

constexpr size_t kStreams = 4, kBatch = 4096, kBins = 16;
constexpr double kPi = 3.14159265358979323846;

/// 1 + sin x sin y, and a narrow tower; its integral over the unit square.
double f(const double* x) {
  const bool tower = x[0] > 0.75 && x[0] < 0.8125 && x[1] > 0.25 && x[1] < 0.3125;
  return 1.0 + std::sin(kPi * x[0]) * std::sin(kPi * x[1]) + (tower ? 64.0 : 0.0);
}
constexpr double kIntegral = 1.0 + 4.0 / (kPi * kPi) + 64.0 / 256.0;

/// What one stream saw, by halves.
struct Seen {
  std::vector<uint64_t> bins[2] = {std::vector<uint64_t>(kBins * kBins),
                                   std::vector<uint64_t>(kBins* kBins)};
  uint64_t wrong = 0;  // points out of the square, pdfs not positive or other than asked for again
};

/// Draws from `density` and records in `fork`, which is of the same p.
void draw(AWDDensity density, AWDDensity fork, uint64_t stream, size_t batches, Seen& seen) {
  Random random(0x5eed + stream);
  std::vector<double> uniforms(2 * kBatch), points(2 * kBatch), pdfs(kBatch), again(kBatch),
      values(kBatch);
  for (size_t batch = 0; batch < batches; ++batch) {
    for (double& u : uniforms) u = random.uniform();
    must(awdSampleDensity(density, kBatch, uniforms.data(), points.data(), pdfs.data(), nullptr));
    // Once in a while: it costs as much as the drawing.
    const bool asks = batch % 64 == 0;
    if (asks) must(awdGetDensityPdf(density, kBatch, points.data(), again.data()));
    auto& bins = seen.bins[2 * batch >= batches];
    for (size_t i = 0; i < kBatch; ++i) {
      const double* x = &points[2 * i];
      const bool inside = x[0] >= 0.0 && x[0] < 1.0 && x[1] >= 0.0 && x[1] < 1.0;
      seen.wrong +=
          !inside || !(pdfs[i] > 0.0 && pdfs[i] < HUGE_VAL) || (asks && again[i] != pdfs[i]);
      if (!inside) continue;
      ++bins[static_cast<size_t>(kBins * x[1]) * kBins + static_cast<size_t>(kBins * x[0])];
      values[i] = f(x);
    }
    must(awdRecordDensity(fork, kBatch, points.data(), pdfs.data(), nullptr, values.data()));
  }
}

std::vector<char> statisticsOf(AWDDensity density) {
  size_t size = 0;
  must(awdExportDensityStatistics(density, nullptr, 0, &size));
  std::vector<char> bytes(size);
  must(awdExportDensityStatistics(density, bytes.data(), size, &size));
  return bytes;
}

/// P of a chi-square as large under the hypothesis that the points have the pdf of the density.
double chanceOf(AWDDensity density, const std::vector<uint64_t>& bins) {
  double all = 0.0, sum = 0.0;
  for (const uint64_t n : bins) all += static_cast<double>(n);
  for (size_t i = 0; i < bins.size(); ++i) {
    const double x = static_cast<double>(i % kBins), y = static_cast<double>(i / kBins);
    const double lower[] = {x / kBins, y / kBins}, upper[] = {(x + 1) / kBins, (y + 1) / kBins};
    double mass = 0.0;
    must(awdGetDensityIntegral(density, lower, upper, &mass));
    const double d = static_cast<double>(bins[i]) - all * mass;
    sum += d * d / (all * mass);
  }
  return chiSquareTail(sum, static_cast<double>(bins.size() - 1));
}

void soak(AWDDensityStructure structure, const char* basis) {
  CountingAllocator allocator;
  const AWDDeviceDesc deviceDesc = allocator.desc(1);
  const Device device = newDevice(&deviceDesc);
  const AWDDensityAxis axes[] = {{basis, AWD_LEVEL(3), AWD_LEVEL(5)},
                                 {basis, AWD_LEVEL(3), AWD_LEVEL(5)}};
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  desc.dimensions = 2;
  desc.structure = structure;
  desc.axes = axes;
  Density density;
  must(awdNewDensity(device, &desc, density.out()));
  Seen young;
  draw(density, density, 99, 16, young);
  must(awdAdaptDensity(density, nullptr));

  Density forks[kStreams];
  for (Density& fork : forks) must(awdForkDensity(density, fork.out()));
  const size_t bytes = allocator.held();
  // Sanitizers make each take ten times as long.
  const size_t atLeast = soakSize(400'000, memoryIsWatched() ? 100'000'000 : 1'000'000'000);
  const size_t batches = (atLeast + kStreams * kBatch - 1) / (kStreams * kBatch);
  const uint64_t samples = uint64_t{kStreams} * batches * kBatch;
  Seen seen[kStreams];
  std::vector<std::thread> threads;
  for (size_t s = 0; s < kStreams; ++s) {
    threads.emplace_back([&, s] { draw(density, forks[s], s, batches, seen[s]); });
  }
  for (std::thread& thread : threads) thread.join();
  // A tree makes boxes for what is recorded as the first samples come.
  if (structure == AWD_STRUCTURE_TREE) {
    EXPECT_LE(allocator.held(), 2 * bytes);
  } else {
    EXPECT_EQ(allocator.held(), bytes);
  }

  // Null hypothesis: in either half the points are drawn from p. False alarms: 2 in 10^5 tests.
  std::vector<uint64_t> bins[2] = {std::vector<uint64_t>(kBins * kBins),
                                   std::vector<uint64_t>(kBins * kBins)};
  for (const Seen& s : seen) {
    EXPECT_EQ(s.wrong, 0u);
    for (size_t half = 0; half < 2; ++half) {
      for (size_t i = 0; i < bins[half].size(); ++i) bins[half][i] += s.bins[half][i];
    }
  }
  for (const auto& half : bins) EXPECT_GT(chanceOf(density, half), 1e-5);

  // In another order, by way of bytes: the same sums to the bit.
  Density sums;
  must(awdForkDensity(density, sums.out()));
  for (size_t s = kStreams; s-- > 0;) {
    const std::vector<char> part = statisticsOf(forks[s]);
    must(awdAddDensityStatistics(sums, part.data(), part.size()));
  }
  for (Density& fork : forks) must(awdJoinDensity(density, fork));
  EXPECT_TRUE(statisticsOf(sums) == statisticsOf(density));

  AWDDensityEstimate estimate = AWD_DENSITY_ESTIMATE_INIT;
  must(awdGetDensityEstimate(density, &estimate));
  EXPECT_EQ(estimate.samples, samples + 16 * kBatch);
  // Null hypothesis: the mean of f/p is the integral of f. False alarms: 6 in 10^7 tests.
  EXPECT_LT(std::fabs(estimate.integral - kIntegral), 5.0 * estimate.standardError);
  EXPECT_GT(estimate.standardError, 0.0);
  AWDDensityReport report = AWD_DENSITY_REPORT_INIT;
  must(awdAdaptDensity(density, &report));
  EXPECT_EQ(report.samples, samples);
  EXPECT_EQ(report.rejected, 0u);
  double mass = 0.0;
  must(awdGetDensityIntegral(density, nullptr, nullptr, &mass));
  EXPECT_NEAR(mass, 1.0, 1e-12);
  testing::Test::RecordProperty("samples", std::to_string(samples));
  testing::Test::RecordProperty("relative_error",
                                std::to_string(estimate.integral / kIntegral - 1.0));
}

TEST(Density, OfHatFunctions) { soak(AWD_STRUCTURE_GRID, "linear-bspline"); }
TEST(Density, OfBoxes) { soak(AWD_STRUCTURE_GRID, "haar"); }
TEST(Density, OfTrees) { soak(AWD_STRUCTURE_TREE, "m2"); }

}  // namespace
