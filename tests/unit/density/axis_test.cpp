// SPDX-License-Identifier: Apache-2.0
#include "density/axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "basis/bernstein.h"
#include "density/levels.h"

namespace awd {
namespace {

/// All n values at x by the plugin itself, without our tables.
std::vector<double> byPlugin(const AWDBasisFamily& t, uint32_t level, double x) {
  std::vector<double> values(t.count(level), 0.0);
  uint32_t first = 0;
  double alive[AWD_BASIS_MAX_ORDER];
  const uint32_t count = t.eval(level, x, &first, alive);
  for (uint32_t k = 0; k < count; ++k) values[(first + k) % t.count(level)] += alive[k];
  return values;
}

TEST(Axis, TablesSayWhatThePluginSays) {
  Uniforms random(1);
  for (const char* name : kFamilies) {
    const Family compiled = family(name);
    for (uint32_t l = 0; l <= 6; ++l) {
      for (int i = 0; i < 200; ++i) {
        const double x = i == 0 ? 0.0 : i == 1 ? 1.0 : random();
        std::vector<double> ours(compiled.level(l).count, 0.0);
        AxisValues alive;
        evaluateAxis(compiled.level(l), x, alive);
        for (uint32_t a = 0; a < alive.count; ++a) ours[alive.function[a]] += alive.value[a];
        const std::vector<double> theirs = byPlugin(table(name), l, x);
        for (std::size_t j = 0; j < ours.size(); ++j) {
          ASSERT_NEAR(ours[j], theirs[j], 1e-13) << name << " level " << l << " x " << x;
        }
      }
    }
  }
}

TEST(Axis, CdfInversionHitsItsTarget) {
  Uniforms random(2);
  for (uint32_t order = 1; order <= AWD_BASIS_MAX_ORDER; ++order) {
    for (int i = 0; i < 2000; ++i) {
      double b[AWD_BASIS_MAX_ORDER] = {0.0};
      double integral[AWD_BASIS_MAX_ORDER + 1] = {0.0};
      // Flat cells, zero ends and 200 decades between neighbours, each in a quarter of the cases.
      for (uint32_t k = 0; k < order; ++k) {
        b[k] = i % 4 == 0   ? 1.0
               : i % 4 == 1 ? (random() < 0.5 ? 0.0 : 1.0)
               : i % 4 == 2 ? std::pow(10.0, -100.0 * random())
                            : random();
      }
      b[i % order] = std::max(b[i % order], 1e-3);
      for (uint32_t k = 0; k < order; ++k) integral[k + 1] = integral[k] + b[k] / order;
      const double u = i == 5 ? 0.0 : i == 6 ? 1.0 - 0x1p-53 : random();
      const double t = invertPolynomialCdf(b, order, u);
      ASSERT_GE(t, 0.0);
      ASSERT_LE(t, 1.0);
      ASSERT_NEAR(bernsteinValue(integral, order + 1, t), u * integral[order],
                  1e-14 * integral[order])
          << "order " << order << " case " << i;
    }
  }
}

// Null hypothesis: sampleComponent draws from p_j. Kolmogorov-Smirnov against the CDF by
// quadrature of the plugin's own eval. 120 tests at a threshold of 2.2 / sqrt(n): false-alarm rate
// 2 exp(-2 * 2.2^2) = 1.3e-4 each, 1.5 % in all; the seed is fixed.
TEST(Axis, ComponentsAreDrawnFromTheirPdf) {
  constexpr int kSamples = 4000;
  constexpr int kGrid = 2048;
  Uniforms random(3);
  int tests = 0;
  for (const char* name : kFamilies) {
    const AWDBasisFamily& t = table(name);
    const Family compiled = family(name);
    for (const uint32_t l : {0u, 1u, 2u, 3u}) {
      for (uint32_t j = 0; j < t.count(l); ++j, ++tests) {
        std::vector<double> cdf(kGrid + 1, 0.0);
        for (int g = 0; g < kGrid; ++g) {
          cdf[g + 1] = cdf[g] + byPlugin(t, l, (g + 0.5) / kGrid)[j] / kGrid;
        }
        std::vector<double> sorted(kSamples);
        for (double& x : sorted) x = sampleComponent<float>(compiled.level(l), j, random());
        std::sort(sorted.begin(), sorted.end());
        double distance = 0.0;
        for (int i = 0; i < kSamples; ++i) {
          const double at = sorted[i] * kGrid;
          const auto cell = std::min(static_cast<int>(at), kGrid - 1);
          const double value = (cdf[cell] + (at - cell) * (cdf[cell + 1] - cdf[cell])) / cdf[kGrid];
          distance = std::max({distance, std::abs(value - double(i) / kSamples),
                               std::abs(value - double(i + 1) / kSamples)});
        }
        EXPECT_LT(distance * std::sqrt(kSamples), 2.2) << name << " level " << l << " j " << j;
      }
    }
  }
  EXPECT_GT(tests, 60);
}

TEST(Axis, SamplesStayInTheUnitIntervalAtTheEnds) {
  for (const char* name : kFamilies) {
    const Family compiled = family(name);
    for (const uint32_t l : {0u, 3u, 6u}) {
      for (uint32_t j = 0; j < compiled.level(l).count; ++j) {
        for (const double u : {0.0, 0x1p-53, 1.0 - 0x1p-53}) {
          const float x = sampleComponent<float>(compiled.level(l), j, u);
          EXPECT_GE(x, 0.0f);
          EXPECT_LT(x, 1.0f);
        }
      }
    }
  }
}

}  // namespace
}  // namespace awd
