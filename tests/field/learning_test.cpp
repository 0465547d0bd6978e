// SPDX-License-Identifier: Apache-2.0
// What a field makes of the samples that it is given (Haar, so that a coefficient is the mean
// density of its cell).
#include <algorithm>
#include <cstdio>
#include <thread>

#include "field/learning.h"
#include "support/expect.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

INSTANTIATE_TEST_SUITE_P(Maps, Learning,
                         testing::Values(AWD_MAP_SPHERICAL, AWD_MAP_CONCENTRIC_COSINE));

TEST_P(Learning, TheStartIsConstantOnTheSquare) {
  begin(2, 4, 0.0);
  for (const uint32_t patch : {0u, kPatch, 0x7FFFFFFEu, 0u | AWD_PATCH_BACK}) {
    const Coefficients c = coefficientsOf(field_, patch);
    EXPECT_EQ(c.level, 2u);
    EXPECT_EQ(c.c, std::vector<double>(16, 1.0));
    EXPECT_EQ(c.learned, 0u);
  }
  AWDFieldStatistics figures = AWD_FIELD_STATISTICS_INIT;
  must(awdGetFieldStatistics(field_, &figures));
  EXPECT_EQ(figures.patches, 0u) << "asking makes no patch";
}

/// A function that is constant on every cell is learned from the cells' mean values: exactly but
/// for the rounding of directions to float.
TEST_P(Learning, AStepFunctionIsLearned) {
  begin(2, 2, kNoFloor);
  Random random(1);
  record(20000, random, steps);
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.samples, 20000u);
  EXPECT_EQ(figures.patches, 1u);
  EXPECT_EQ(figures.coefficients, 16u);
  EXPECT_EQ(figures.rejected, 0u);
  EXPECT_EQ(figures.saturated, 0u);
  EXPECT_EQ(figures.kept, 0u);
  const Coefficients found = coefficientsOf(field_, kPatch);
  EXPECT_EQ(found.learned, 20000u);
  for (size_t j = 0; j < 4; ++j) {
    for (size_t k = 0; k < 4; ++k) {
      const double expected = steps((double(j) + 0.5) / 4.0, (double(k) + 0.5) / 4.0);
      EXPECT_NEAR(found.c[4 * j + k], expected, 2e-3 * expected) << j << ' ' << k;
    }
  }
  EXPECT_NEAR(found.integral(), 1.0, 1e-12);
}

/// The same from a density far from constant: what counts is the function, not how it was sampled.
/// Null hypothesis: coefficients are cell averages of f; false-alarm rate 1 % over 64 cells. The
/// scatter comes from 40 independent fields.
TEST_P(Learning, TheSecondPassEstimatesTheSameFunction) {
  const auto slope = [](double u, double v) { return 4.0 * u * v; };
  constexpr size_t kFields = 40;
  std::vector<double> sum(64), squares(64);
  for (size_t run = 0; run < kFields; ++run) {
    begin(3, 3, kNoFloor);
    Random random(100 + run);
    record(4000, random, [&](double u, double v) { return steps(u, v); });
    adapt(field_);
    record(20000, random, slope);
    adapt(field_);
    const Coefficients found = coefficientsOf(field_, kPatch);
    for (size_t i = 0; i < 64; ++i) {
      sum[i] += found.c[i] / kFields;
      squares[i] += found.c[i] * found.c[i] / kFields;
    }
  }
  std::vector<double> scores;
  double worst = 0.0;
  for (size_t i = 0; i < 64; ++i) {
    const double u = (double(i / 8) + 0.5) / 8.0, v = (double(i % 8) + 0.5) / 8.0;
    const double error = std::sqrt((squares[i] - sum[i] * sum[i]) / (kFields - 1.0));
    // Ratios of sums are biased by about the square of their error; 40 times smaller than it.
    scores.push_back((sum[i] - slope(u, v)) / error);
    worst = std::max(worst, error / slope(u, v));
  }
  std::printf("  largest |z| %.2f; worst relative standard error %.2g\n", largest(scores), worst);
  EXPECT_LT(largest(scores), familyThreshold(0.01, 64));
  EXPECT_LT(worst, 0.05);
}

TEST_P(Learning, LevelsGrowFromTheFirstToTheLast) {
  begin(1, 3, 0.0);
  Random random(3);
  EXPECT_EQ(coefficientsOf(field_, kPatch).level, 1u);
  for (int pass = 0; pass < 8; ++pass) {
    record(20000, random, steps);
    adapt(field_);
    const Coefficients found = coefficientsOf(field_, kPatch);
    EXPECT_LE(found.level, 3u);
    EXPECT_NEAR(found.integral(), 1.0, 1e-12);
  }
  EXPECT_EQ(coefficientsOf(field_, kPatch).level, 3u);
  EXPECT_EQ(coefficientsOf(field_, kPatch + 1).level, 1u) << "others have learned nothing";
}

/// Where f is 0 the density is tau times the mean before the last normalisation, which divides by
/// 1 to 1 + tau.
TEST_P(Learning, TheFloorHolds) {
  for (const double tau : {0.01, 0.1, 0.5}) {
    begin(3, 3, tau);
    Random random(4);
    for (int pass = 0; pass < 3; ++pass) {
      record(20000, random, [](double u, double) { return u < 0.5 ? 1.0 : 0.0; });
      adapt(field_);
      const Coefficients found = coefficientsOf(field_, kPatch);
      const double least = *std::min_element(found.c.begin(), found.c.end());
      EXPECT_GE(least, tau / (1.0 + tau) * (1.0 - 1e-9));
      EXPECT_LE(least, tau);
      EXPECT_NEAR(found.integral(), 1.0, 1e-12);
    }
  }
}

TEST_P(Learning, WithoutAFloorDarkCellsMayVanishButSamplingStaysFinite) {
  begin(2, 2, kNoFloor);
  Random random(5);
  record(20000, random, [](double u, double) { return u < 0.5 ? 1.0 : 0.0; });
  adapt(field_);
  for (const double c : coefficientsOf(field_, kPatch).c) EXPECT_GE(c, 0.0);
  const float up[3] = {0, 0, 1};
  for (int i = 0; i < 1000; ++i) {
    const AWDDirectionSample s = draw(field_, kPatch, up, random);
    EXPECT_GT(s.pdf, 0.0f);
    EXPECT_LE(s.square[0], 0.5f);
  }
}

/// Sums are integers: order, interleaving with other patches, and threads don't matter.
TEST_P(Learning, OrderDoesNotMatter) {
  struct Entry {
    uint32_t patch;
    AWDDirectionSample sample;
    double value;
  };
  begin(2, 4, 0.0);
  const float up[3] = {0, 0, 1};
  Random random(6);
  std::vector<Entry> entries;
  for (int i = 0; i < 6000; ++i) {
    const uint32_t patch = static_cast<uint32_t>(random.bits() % 3);
    const AWDDirectionSample s = draw(field_, patch, up, random);
    const double value = steps(s.square[0], s.square[1]) * std::exp(20.0 * random.uniform() - 18.0);
    entries.push_back({patch, s, value});
  }
  const auto learn = [&](size_t threads) {
    begin(2, 4, 0.0);
    std::vector<std::thread> helpers;
    for (size_t t = 0; t < threads; ++t) {
      helpers.emplace_back([&, t] {
        for (size_t i = t; i < entries.size(); i += threads) {
          must(awdRecordField(field_, entries[i].patch, &entries[i].sample, entries[i].value));
        }
      });
    }
    for (std::thread& helper : helpers) helper.join();
    adapt(field_);
    std::vector<std::vector<double>> result;
    for (uint32_t patch = 0; patch < 3; ++patch) {
      result.push_back(coefficientsOf(field_, patch).c);
    }
    return result;
  };
  const auto once = learn(1);
  EXPECT_NE(once[0], once[1]);
  std::reverse(entries.begin(), entries.end());
  EXPECT_EQ(learn(1), once);
  for (size_t i = entries.size() - 1; i > 0; --i) {
    std::swap(entries[i], entries[random.bits() % (i + 1)]);
  }
  EXPECT_EQ(learn(1), once);
  EXPECT_EQ(learn(4), once);
}

TEST_P(Learning, PatchesAreListedInOrder) {
  begin(1, 1, 0.0);
  const float up[3] = {0, 0, 1};
  Random random(14);
  const std::vector<uint32_t> patches = {7, 0x7FFFFFFEu, 0, 7u | AWD_PATCH_BACK, 3};
  for (const uint32_t patch : patches) {
    const AWDDirectionSample s = draw(field_, patch, up, random);
    must(awdRecordField(field_, patch, &s, 1.0));
  }
  std::vector<uint32_t> sorted = patches;
  std::sort(sorted.begin(), sorted.end());
  size_t count = 0;
  must(awdGetFieldPatches(field_, nullptr, 0, &count));
  ASSERT_EQ(count, sorted.size());
  std::vector<uint32_t> found(count);
  must(awdGetFieldPatches(field_, found.data(), count, &count));
  EXPECT_EQ(found, sorted);
  found.assign(count, 999);
  must(awdGetFieldPatches(field_, found.data(), 2, &count));
  EXPECT_EQ(count, sorted.size());
  EXPECT_EQ(found, (std::vector<uint32_t>{sorted[0], sorted[1], 999, 999, 999}));
}

TEST_P(Learning, TheImageOfAPatchShowsItsDensity) {
  begin(2, 2, 0.0);
  Random random(15);
  record(5000, random, steps);
  adapt(field_);
  const Coefficients density = coefficientsOf(field_, kPatch);
  constexpr uint32_t kN = 12;
  std::vector<float> pixels(kN * (kN + 3), -1.0f);
  must(awdGetPatchPdf(field_, kPatch, kN, pixels.data(), (kN + 3) * sizeof(float)));
  for (size_t row = 0; row < kN; ++row) {
    for (size_t column = 0; column < kN; ++column) {
      const double c = density.c[4 * (column / 3) + row / 3];  // u to the right, v downwards
      EXPECT_FLOAT_EQ(pixels[row * (kN + 3) + column], static_cast<float>(c));
    }
    EXPECT_EQ(pixels[row * (kN + 3) + kN], -1.0f) << "written past the row";
  }
}

/// A record must be of a sample that was drawn.
TEST_P(Learning, RecordsThatNobodyDrew) {
  begin(2, 2, 0.0);
  const float up[3] = {0, 0, 1};
  Random random(16);
  const AWDDirectionSample good = draw(field_, kPatch, up, random);
  for (const float bad : {0.0f, -0.1f, HUGE_VALF, std::nanf("")}) {
    AWDDirectionSample s = good;
    s.solidAngle = bad;
    expectFailure(awdRecordField(field_, kPatch, &s, 1.0), AWD_ERROR_INVALID_ARGUMENT,
                  {"solidAngle"});
  }
  for (const uint32_t bad : {16u, 1000000u, AWD_INVALID_ID}) {
    AWDDirectionSample s = good;
    s.component = bad;
    expectFailure(awdRecordField(field_, kPatch, &s, 1.0), AWD_ERROR_INVALID_ARGUMENT,
                  {"component", std::to_string(bad)});
  }
  EXPECT_EQ(adapt(field_).samples, 0u);
  size_t count = 77;
  must(awdGetFieldPatches(field_, nullptr, 0, &count));
  EXPECT_EQ(count, 0u);
}

/// Of a pass that is given up nothing stays; what was there at the mark does.
TEST_P(Learning, RevertForgetsWhatCameAfterTheMark) {
  std::vector<double> outcome[2];
  for (const bool disturbed : {false, true}) {
    begin(2, 3, 0.0);
    Random random(17), other(18);
    for (int pass = 0; pass < 2; ++pass) {
      record(3000, random, steps);
      if (disturbed) {
        must(awdMarkField(field_));
        record(2000, other, [](double u, double v) { return 100.0 * u * v; });
        const float up[3] = {0, 0, 1};
        const AWDDirectionSample s = draw(field_, kPatch + 1, up, other);
        must(awdRecordField(field_, kPatch + 1, &s, std::nan("")));
        must(awdRevertField(field_));
        must(awdRevertField(field_));
        EXPECT_EQ(coefficientsOf(field_, kPatch).samples, 3000u);
      }
      record(2000, random, steps);
      if (disturbed) must(awdMarkField(field_));  // takes in what is new
      const AWDFieldStatistics figures = adapt(field_);
      EXPECT_EQ(figures.samples, 5000u);
      EXPECT_EQ(figures.rejected, 0u);
      EXPECT_EQ(figures.patches, 1u);
    }
    outcome[disturbed] = coefficientsOf(field_, kPatch).c;
  }
  EXPECT_EQ(outcome[0], outcome[1]);
}

}  // namespace
