// SPDX-License-Identifier: Apache-2.0
#include "density/square_density.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "density/levels.h"

namespace awd {
namespace {

std::pmr::vector<double> randomCoefficients(const BasisLevel& level, uint64_t seed,
                                            double decades) {
  Uniforms random(seed);
  std::pmr::vector<double> c(std::size_t{level.count} * level.count);
  for (double& value : c) value = std::pow(10.0, -decades * random());
  return c;
}

/// Every family with each way of drawing.
std::vector<std::pair<const char*, AWDSampler>> bothSamplers() {
  std::vector<std::pair<const char*, AWDSampler>> all;
  for (const char* name : kFamilies) {
    for (const AWDSampler sampler : {AWD_SAMPLER_COMPONENT, AWD_SAMPLER_INVERSE_CDF}) {
      all.emplace_back(name, sampler);
    }
  }
  return all;
}

TEST(SquareDensity, StartsConstant) {
  for (const auto& [name, sampler] : bothSamplers()) {
    const Family compiled = family(name);
    const SquareDensity density(std::pmr::get_default_resource(), compiled.level(3), sampler);
    Uniforms random(5);
    for (int i = 0; i < 100; ++i) {
      EXPECT_NEAR(density.pdf(float(random()), float(random())), 1.0,
                  sampler == AWD_SAMPLER_COMPONENT ? 1e-14 : 1e-6)  // floats
          << name;
    }
  }
}

TEST(SquareDensity, IntegratesToOne) {
  constexpr int kGrid = 512;  // midpoints: exact for pieces up to linear, 1e-6 for quadratic ones
  for (const auto& [name, sampler] : bothSamplers()) {
    const Family compiled = family(name);
    const SquareDensity density(compiled.level(3), sampler,
                                randomCoefficients(compiled.level(3), 6, 3.0));
    double sum = 0.0;
    for (int i = 0; i < kGrid; ++i) {
      for (int k = 0; k < kGrid; ++k) {
        sum += density.pdf((float(i) + 0.5f) / kGrid, (float(k) + 0.5f) / kGrid);
      }
    }
    EXPECT_NEAR(sum / (kGrid * kGrid), 1.0, 1e-5) << name;
  }
}

TEST(SquareDensity, SampleKnowsItsPdfToTheBit) {
  for (const auto& [name, sampler] : bothSamplers()) {
    const Family compiled = family(name);
    for (uint32_t l = 0; l <= 6; ++l) {
      const SquareDensity density(compiled.level(l), sampler,
                                  randomCoefficients(compiled.level(l), 7, 30.0));
      Uniforms random(8);
      for (int i = 0; i < 2000; ++i) {
        const double u[3] = {random(), i == 0 ? 0.0 : random(), i == 1 ? 1.0 - 0x1p-53 : random()};
        const SquareSample sample = density.sample(u);
        const double pdf = density.pdf(sample.u, sample.v);
        ASSERT_EQ(std::memcmp(&sample.pdf, &pdf, sizeof pdf), 0) << name << " level " << l;
        ASSERT_LT(sample.u, 1.0f);
        ASSERT_LT(sample.v, 1.0f);
      }
    }
  }
}

// Null hypothesis: samples follow the pdf. Pearson's chi-square on 16 x 16 equal bins whose masses
// come from 8 x 8 midpoints each; 255 degrees of freedom; the threshold 360 is exceeded with
// probability 1.5e-5 in each of 8 tests. Fixed seed.
TEST(SquareDensity, SamplesFollowThePdf) {
  constexpr int kBins = 16;
  constexpr int kInner = 8;
  constexpr int kSamples = 200000;
  for (const auto& [name, sampler] : bothSamplers()) {
    const Family compiled = family(name);
    const SquareDensity density(compiled.level(2), sampler,
                                randomCoefficients(compiled.level(2), 9, 1.0));
    std::vector<int> counts(kBins * kBins, 0);
    Uniforms random(10);
    for (int i = 0; i < kSamples; ++i) {
      const double u[3] = {random(), random(), random()};
      const SquareSample s = density.sample(u);
      ++counts[int(s.u * kBins) * kBins + int(s.v * kBins)];
    }
    double chi2 = 0.0;
    for (int b = 0; b < kBins * kBins; ++b) {
      double mass = 0.0;
      for (int i = 0; i < kInner * kInner; ++i) {
        const int fine = kBins * kInner;
        mass += density.pdf((float(b / kBins * kInner + i / kInner) + 0.5f) / float(fine),
                            (float(b % kBins * kInner + i % kInner) + 0.5f) / float(fine)) /
                (double(fine) * fine);
      }
      const double expected = mass * kSamples;
      chi2 += (counts[b] - expected) * (counts[b] - expected) / expected;
    }
    EXPECT_LT(chi2, 360.0) << name;
    EXPECT_GT(chi2, 165.0) << name << ": too good to be random";
  }
}

TEST(SquareDensity, BearsSixtyDecades) {
  for (const auto& [name, sampler] : bothSamplers()) {
    const Family compiled = family(name);
    for (const double scale : {1.0, 1e-300, 1e300}) {
      auto c = randomCoefficients(compiled.level(4), 11, 60.0);
      for (double& value : c) value *= scale * 1e-5;
      const SquareDensity density(compiled.level(4), sampler, std::move(c));
      double mass = 0.0;
      const uint32_t n = compiled.level(4).count;
      for (std::size_t i = 0; i < density.coefficients().size(); ++i) {
        mass += density.coefficients()[i] * compiled.level(4).weights[i / n] *
                compiled.level(4).weights[i % n];
      }
      EXPECT_NEAR(mass, 1.0, 1e-12) << name << " scale " << scale;
      Uniforms random(12);
      for (int i = 0; i < 1000; ++i) {
        const double u[3] = {random(), random(), random()};
        const double pdf = density.sample(u).pdf;
        ASSERT_TRUE(pdf > 0.0 && std::isfinite(pdf)) << name << " scale " << scale;
      }
    }
  }
}

TEST(SquareDensity, NeverDrawsAComponentOfNoMass) {
  const Family compiled = family("haar");
  std::pmr::vector<double> c(16, 0.0);
  c[5] = 1.0;
  const SquareDensity density(compiled.level(2), AWD_SAMPLER_COMPONENT, std::move(c));
  for (const double first : {0.0, 0.5, 1.0 - 0x1p-53}) {
    const double u[3] = {first, 0.25, 0.75};
    EXPECT_EQ(density.sample(u).component, 5u);
    EXPECT_EQ(density.sample(u).pdf, 16.0);
  }
}

// The inverse CDF is monotone: u in the first uniform, v in the second where u is held.
TEST(SquareDensity, InverseCdfIsMonotone) {
  for (const char* name : kFamilies) {
    const Family compiled = family(name);
    for (const uint32_t level : {3u, 6u}) {
      const SquareDensity density(compiled.level(level), AWD_SAMPLER_INVERSE_CDF,
                                  randomCoefficients(compiled.level(level), 13, 3.0));
      float lastU = 0.0f, lastV = 0.0f;
      for (int i = 0; i < 4096; ++i) {
        const double uniform = i / 4096.0;
        const double along[2][3] = {{uniform, 0.5, 0.0}, {0.3, uniform, 0.0}};
        const float u = density.sample(along[0]).u;
        const float v = density.sample(along[1]).v;
        // Two floats apart at most: the inversion rounds.
        ASSERT_GE(u, lastU - 1.2e-7f) << name;
        ASSERT_GE(v, lastV - 1.2e-7f) << name;
        lastU = u;
        lastV = v;
      }
      EXPECT_GT(lastU, 0.99f);
      EXPECT_GT(lastV, 0.99f);
    }
  }
}

}  // namespace
}  // namespace awd
