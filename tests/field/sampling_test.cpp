// SPDX-License-Identifier: Apache-2.0
// Directions drawn from a trained field are distributed as its pdf says.
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "field/trained.h"
#include "support/expect.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

constexpr uint32_t kFront = 12, kBack = 12 | AWD_PATCH_BACK;

class Sampling : public testing::TestWithParam<AWDHemisphereMap> {
 protected:
  void SetUp() override {
    device_ = newDevice(1u);
    const AWDFieldDesc desc = fieldDesc(GetParam(), 2, 4);
    field_ = newField(device_, &desc);
    train(field_, kFront);
  }
  Device device_;
  Field field_;
};
INSTANTIATE_TEST_SUITE_P(Maps, Sampling,
                         testing::Values(AWD_MAP_SPHERICAL, AWD_MAP_CONCENTRIC_COSINE));

constexpr size_t kThetas = 8, kPhis = 16;

/// Integrals of the pdf over bins of theta and phi about the normal, by stratified points.
std::vector<double> binIntegrals(AWDField field, uint32_t patch, const Normal& normal, int strata) {
  const Frame frame(normal.exact());
  const double dTheta = 0.5 * kPi / kThetas, dPhi = 2.0 * kPi / kPhis;
  Random random(31);
  std::vector<double> result(kThetas * kPhis);
  for (size_t bin = 0; bin < result.size(); ++bin) {
    double sum = 0.0;
    for (int i = 0; i < strata * strata; ++i) {
      const double s = (i / strata + random.uniform()) / strata,
                   t = (i % strata + random.uniform()) / strata;
      const double theta = dTheta * (static_cast<double>(bin / kPhis) + s),
                   phi = dPhi * (static_cast<double>(bin % kPhis) + t);
      sum += std::sin(theta) * pdf(field, patch, normal.values, frame.direction(theta, phi));
    }
    result[bin] = sum / (strata * strata) * dTheta * dPhi;
  }
  return result;
}

/// Null hypothesis: the counts in 128 bins are those of the pdf; false-alarm rate 1 % shared by
/// all normals and sides of a map (Bonferroni).
TEST_P(Sampling, ChiSquareAgainstThePdf) {
  constexpr int kSamples = 100000;
  const std::vector<Normal> normals = someNormals();
  size_t number = 0;
  for (const uint32_t patch : {kFront, kBack, 99u}) {  // trained; two that never saw a sample
    for (const Normal& normal : normals) {
      if (patch != kFront && number++ % 4 != 0) continue;
      const std::vector<double> expected = binIntegrals(field_, patch, normal, 32);
      const Frame frame(normal.exact());
      std::vector<double> counts(expected.size());
      Random random(1000 + number + patch % 100);
      for (int i = 0; i < kSamples; ++i) {
        const AWDDirectionSample s = draw(field_, patch, normal.values, random);
        const Vec3 d = {s.direction[0], s.direction[1], s.direction[2]};
        const double theta = std::acos(std::min(1.0, dot(d, frame.n)));
        double phi = std::atan2(dot(d, frame.t), dot(d, frame.s));
        if (phi < 0.0) phi += 2.0 * kPi;
        const size_t i0 = std::min(kThetas - 1, static_cast<size_t>(theta / (0.5 * kPi) * kThetas));
        const size_t i1 = std::min(kPhis - 1, static_cast<size_t>(phi / (2.0 * kPi) * kPhis));
        counts[i0 * kPhis + i1] += 1.0;
      }
      double chiSquare = 0.0, degrees = -1.0, restCount = 0.0, restExpected = 0.0;
      for (size_t bin = 0; bin < counts.size(); ++bin) {
        const double e = expected[bin] * kSamples;
        if (e < 20.0) {  // too rare for the approximation: all of these are one bin
          restCount += counts[bin];
          restExpected += e;
          continue;
        }
        chiSquare += (counts[bin] - e) * (counts[bin] - e) / e;
        degrees += 1.0;
      }
      if (restExpected > 5.0) {
        chiSquare += (restCount - restExpected) * (restCount - restExpected) / restExpected;
        degrees += 1.0;
      }
      EXPECT_GT(degrees, 50.0);
      EXPECT_GT(chiSquareTail(chiSquare, degrees),
                0.01 / (3.0 * static_cast<double>(normals.size())))
          << "patch " << patch << ", normal " << normal.values[0] << ' ' << normal.values[1] << ' '
          << normal.values[2] << ": chi-square " << chiSquare << " of " << degrees;
    }
  }
}

/// A sample's pdf is that of awdGetFieldPdf at its direction, to 1e-4, but where the rounding of
/// the direction to float carries it over the edge of a cell: with cells of 1/16 and an error of
/// about 2e-7, some 1e-5 of all; 1e-3 are allowed. Near the horizon and the pole, where the
/// Jacobian is not smooth, nothing is asked.
TEST_P(Sampling, PdfOfASampleIsThatOfItsDirection) {
  size_t misses = 0, samples = 0;
  for (const Normal& normal : someNormals()) {
    Random random(5);
    for (int i = 0; i < 20000; ++i) {
      const AWDDirectionSample s = draw(field_, kFront, normal.values, random);
      const Vec3 d = {s.direction[0], s.direction[1], s.direction[2]};
      const double c = dot(d, normal.exact());
      ASSERT_NEAR(length(d), 1.0, 1e-5);
      ASSERT_GE(c, 0.0);
      ASSERT_GT(s.pdf, 0.0f);
      ASSERT_TRUE(s.square[0] >= 0.0f && s.square[0] <= 1.0f);
      ASSERT_TRUE(s.square[1] >= 0.0f && s.square[1] <= 1.0f);
      if (c < 5e-3 || c > 1.0 - 5e-5) continue;
      ++samples;
      float found = 0.0f;
      must(awdGetFieldPdf(field_, kFront, normal.values, s.direction, &found));
      if (!(std::fabs(found / s.pdf - 1.0f) < 1e-4f)) ++misses;
    }
  }
  std::printf("  %zu of %zu pdfs differ\n", misses, samples);
  EXPECT_GT(samples, 100000u);
  EXPECT_LE(misses, samples / 1000);
}

/// What is taken for a unit vector is used as one, whatever little it lacks.
TEST_P(Sampling, NormalsNeedNotBeUnitToTheLastDigit) {
  Random random(77);
  size_t misses = 0;
  for (const Normal& normal : someNormals()) {
    for (const float size : {0.9991f, 1.0009f}) {
      const float n[3] = {normal.values[0] * size, normal.values[1] * size,
                          normal.values[2] * size};
      for (int i = 0; i < 20; ++i) {
        const AWDDirectionSample s = draw(field_, kFront, n, random);
        const Vec3 d = {s.direction[0], s.direction[1], s.direction[2]};
        EXPECT_NEAR(length(d), 1.0, 1e-5);
        const double c = dot(d, normal.exact());
        if (c < 5e-3 || c > 1.0 - 5e-5) continue;
        float found = 0.0f;
        must(awdGetFieldPdf(field_, kFront, n, s.direction, &found));
        misses += !(std::fabs(found / s.pdf - 1.0f) < 1e-4f);
      }
    }
  }
  EXPECT_LE(misses, 2u);
}

/// The sample's point on the square is where the coefficients say its density is, and the solid
/// angle is that of the map (awd/field.h has the formulas).
TEST_P(Sampling, SquareAndPdfBelongTogether) {
  const Coefficients density = coefficientsOf(field_, kFront);
  const float up[3] = {0, 0, 1};
  Random random(8);
  size_t misses = 0;
  for (int i = 0; i < 10000; ++i) {
    const AWDDirectionSample s = draw(field_, kFront, up, random);
    const double n = density.axisCount, c = cosine(s, up);
    if (c < 5e-3 || c > 1.0 - 5e-5) continue;
    const size_t j = std::min<size_t>(density.axisCount - 1, size_t(s.square[0] * n)),
                 k = std::min<size_t>(density.axisCount - 1, size_t(s.square[1] * n));
    const double p = density.c[j * density.axisCount + k];
    if (!(std::fabs(p / solidAngle(GetParam(), c) / s.pdf - 1.0) < 1e-4)) ++misses;
    if (!(std::fabs(s.solidAngle / solidAngle(GetParam(), c) - 1.0) < 1e-4)) ++misses;
    if (s.component != j * density.axisCount + k) ++misses;
  }
  EXPECT_LE(misses, 10u);
}

/// Quadrature over the hemisphere, with about half a million points.
TEST_P(Sampling, ThePdfIntegratesToOne) {
  for (const uint32_t patch : {kFront, kBack}) {
    for (const Normal& normal : someNormals()) {
      double sum = 0.0;
      for (const double x : binIntegrals(field_, patch, normal, 64)) sum += x;
      EXPECT_NEAR(sum, 1.0, 1e-3);
    }
  }
}

TEST_P(Sampling, NothingBelowTheHorizon) {
  Random random(6);
  for (const Normal& normal : someNormals()) {
    const Frame frame(normal.exact());
    for (int i = 0; i < 1000; ++i) {
      const double theta = 0.5 * kPi + 1e-6 + (0.5 * kPi - 1e-6) * random.uniform();
      const Vec3 d = frame.direction(theta, 2.0 * kPi * random.uniform());
      EXPECT_EQ(pdf(field_, kFront, normal.values, d), 0.0);
    }
    EXPECT_GT(pdf(field_, kFront, normal.values, frame.direction(0.5, 1.0)), 0.0);
  }
}

TEST_P(Sampling, UniformsAtTheirEnds) {
  const double values[] = {0.0, 0x1p-1074, 0x1p-53, 0.25, 0.5, 0.999999, 1.0 - 0x1p-53};
  for (const uint32_t patch : {kFront, kBack}) {
    for (const Normal& normal : someNormals()) {
      for (const double a : values) {
        for (const double b : values) {
          for (const double c : values) {
            const double uniforms[3] = {a, b, c};
            AWDDirectionSample s;
            must(awdSampleField(field_, patch, normal.values, uniforms, &s));
            ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf > 0.0f) << a << ' ' << b << ' ' << c;
            const Vec3 d = {s.direction[0], s.direction[1], s.direction[2]};
            ASSERT_NEAR(length(d), 1.0, 1e-5);
            ASSERT_GE(dot(d, normal.exact()), -1e-7);
            ASSERT_TRUE(s.square[0] >= 0.0f && s.square[0] < 1.0f);
            ASSERT_TRUE(s.square[1] >= 0.0f && s.square[1] < 1.0f);
            must(awdRecordField(field_, patch, &s, 1.0));
          }
        }
      }
    }
  }
}

TEST_P(Sampling, BadUniformsNormalsAndDirections) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const float up[3] = {0, 0, 1};
  AWDDirectionSample s;
  for (size_t i = 0; i < 3; ++i) {
    for (const double bad : {1.0, -1e-300, 1.5, kNaN, HUGE_VAL, -HUGE_VAL}) {
      double uniforms[3] = {0.5, 0.5, 0.5};
      uniforms[i] = bad;
      expectFailure(awdSampleField(field_, kFront, up, uniforms, &s), AWD_ERROR_INVALID_ARGUMENT,
                    {"uniforms[" + std::to_string(i) + "]"});
    }
  }
  const double uniforms[3] = {0.5, 0.5, 0.5};
  constexpr float kBad = std::numeric_limits<float>::quiet_NaN(), kInfinite = HUGE_VALF;
  const float normals[][3] = {{0, 0, 0}, {kBad, 0, 1}, {0, kInfinite, 0}, {0, 0, 2}, {0, 0, 0.5f}};
  float p;
  for (const auto& bad : normals) {
    expectFailure(awdSampleField(field_, kFront, bad, uniforms, &s), AWD_ERROR_INVALID_ARGUMENT,
                  {"normal"});
    expectFailure(awdGetFieldPdf(field_, kFront, bad, up, &p), AWD_ERROR_INVALID_ARGUMENT,
                  {"normal"});
    expectFailure(awdGetFieldPdf(field_, kFront, up, bad, &p), AWD_ERROR_INVALID_ARGUMENT,
                  {"direction"});
  }
}

TEST(Map, IsNamedInAPatchsImage) {
  const Device device = newDevice(1u);
  const char* const names[] = {"concentric-cosine", "spherical", "concentric-cosine", "cylindrical",
                               "cosine"};
  for (AWDHemisphereMap map = AWD_MAP_DEFAULT; map <= AWD_MAP_COSINE; ++map) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.map = map;
    const Field field = newField(device, &desc);
    Image image;
    must(awdNewPatchImage(field, 3, 4, image.out()));
    const char* name = nullptr;
    must(awdGetImageMetadata(image, "awd.map", &name));
    EXPECT_STREQ(name, names[map]);
  }
}

}  // namespace
