// SPDX-License-Identifier: Apache-2.0
// A field takes every basis that we ship by its name: it samples, records, adapts and refines.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "field/trained.h"

namespace {

using namespace awdtest;

constexpr uint32_t kPatch = 4;

class Bases : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Shipped, Bases,
                         testing::Values("haar", "f2", "m2", "m3", "linear-bspline",
                                         "linear-bspline-periodic", "quadratic-bspline",
                                         "quadratic-bspline-periodic"),
                         [](const auto& name) {
                           std::string text = name.param;
                           std::replace(text.begin(), text.end(), '-', '_');
                           return text;
                         });

/// A bright spot of mean about 1.
double spot(double u, double v) {
  const double du = u - 0.7, dv = v - 0.3;
  return 0.1 + 23.0 * std::exp(-80.0 * (du * du + dv * dv));
}

TEST_P(Bases, LearnsABrightSpot) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = fieldDesc(AWD_MAP_CONCENTRIC_COSINE, 1, 3);
  desc.basis = GetParam();
  const Field field = newField(device, &desc);
  const float up[3] = {0, 0, 1};
  Random random(21);
  std::vector<uint32_t> axisCounts;
  for (uint32_t pass = 0; pass < 4; ++pass) {
    const Coefficients before = coefficientsOf(field, kPatch);
    EXPECT_EQ(before.level, std::min(pass + 1, 3u)) << "a level a pass";
    axisCounts.push_back(before.axisCount);
    recordPass(field, kPatch, 40000, random, spot);
    EXPECT_EQ(coefficientsOf(field, kPatch).samples, 40000u);
    const AWDFieldStatistics figures = adapt(field);
    EXPECT_EQ(figures.samples, 40000u);
    EXPECT_EQ(figures.rejected, 0u);
  }
  EXPECT_LT(axisCounts[0], axisCounts[1]);
  EXPECT_LT(axisCounts[1], axisCounts[2]);
  EXPECT_EQ(axisCounts[2], axisCounts[3]);
  EXPECT_EQ(coefficientsOf(field, kPatch).learned, 40000u);

  // It looks at the spot, and a sample's pdf is the field's.
  constexpr int kSamples = 20000;
  int near = 0;
  double mean = 0.0, squares = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const AWDDirectionSample sample = draw(field, kPatch, up, random);
    ASSERT_GT(sample.pdf, 0.0f);
    const double du = sample.square[0] - 0.7, dv = sample.square[1] - 0.3;
    if (du * du + dv * dv < 0.2 * 0.2) ++near;
    const double x = spot(sample.square[0], sample.square[1]) / sample.solidAngle / sample.pdf;
    mean += x / kSamples;
    squares += x * x / kSamples;
    if (i % 100 != 0 || cosine(sample, up) < 5e-3 || cosine(sample, up) > 1.0 - 5e-5) continue;
    const Vec3 d = {sample.direction[0], sample.direction[1], sample.direction[2]};
    EXPECT_NEAR(pdf(field, kPatch, up, d) / sample.pdf, 1.0, 0.02);
  }
  const double share = near / double{kSamples};
  EXPECT_GT(share, 4.0 * kPi * 0.2 * 0.2) << "four times what equal shares would give";
  // Null hypothesis: the mean is int spot = 0.1 + 23 pi / 80, of which the square cuts off less
  // than 0.001. False alarm beyond 5 standard errors: 6e-7.
  const double variance = squares - mean * mean;
  EXPECT_LT(variance, 1.0) << "of 9.6 for equal shares";
  EXPECT_NEAR(mean, 0.1 + 23.0 * kPi / 80.0, 5.0 * std::sqrt(variance / kSamples) + 1e-3);
}

}  // namespace
