// SPDX-License-Identifier: Apache-2.0
#include "render/pass_weight.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <cmath>

#include "util/random.h"

namespace awd {
namespace {

constexpr uint32_t kSize = 64;

/// Samples of a smooth image, of a relative standard deviation.
PassFilm noisy(uint32_t samples, double deviation, double scale = 1.0) {
  PassFilm pass(std::pmr::get_default_resource(), kSize, kSize);
  RandomStream random(4, samples, 0, 0);
  for (uint32_t y = 0; y < kSize; ++y) {
    for (uint32_t x = 0; x < kSize; ++x) {
      const double mean = scale * (2.0 + std::sin(0.05 * (x + y)));
      for (uint32_t s = 0; s < samples; ++s) {
        const auto value =
            static_cast<float>(mean * (1.0 + deviation * std::sqrt(12.0) * (random.next() - 0.5)));
        pass.pixel(x, y).add({value, value, value});
      }
    }
  }
  return pass;
}

double weight(const PassFilm& pass, uint32_t samples) {
  return passWeight(std::pmr::get_default_resource(), pass, samples);
}

// 4,096 pixels: the variance of a sample is known to some 3 %; 15 % allow for the pixels trimmed
// and the floor of the denominator.
TEST(PassWeight, IsTheInverseVarianceOfASample) {
  for (const uint32_t samples : {1u, 2u, 8u, 64u}) {
    for (const double deviation : {0.1, 0.4}) {
      EXPECT_NEAR(weight(noisy(samples, deviation), samples) * deviation * deviation, 1.0, 0.15)
          << samples << " samples";
    }
  }
}

TEST(PassWeight, KnowsNoUnit) {
  EXPECT_DOUBLE_EQ(weight(noisy(4, 0.2, 1.0), 4), weight(noisy(4, 0.2, 0x1p-20), 4));
}

TEST(PassWeight, OfABlackPassIsThatOfLightTooRareToBeSeen) {
  const PassFilm black(std::pmr::get_default_resource(), 8, 8);
  EXPECT_EQ(weight(black, 4), 1.0 / 256);
  const PassFilm pixel(std::pmr::get_default_resource(), 1, 1);
  EXPECT_EQ(weight(pixel, 1), 1.0);
}

TEST(PassWeight, ALoneFireflyWeighsNothing) {
  PassFilm pass = noisy(4, 0.2);
  const double before = weight(pass, 4);
  pass.pixel(20, 20).add({1e6f, 1e6f, 1e6f});
  EXPECT_NEAR(weight(pass, 4) / before, 1.0, 0.05);
}

TEST(ExpectedLuminance, IsTheMeanOfTheNeighbourhoodOrAFifthOfTheImages) {
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();
  constexpr int kWidth = 7, kHeight = 6;
  Film film(memory, kWidth, kHeight);
  EXPECT_TRUE(expectedLuminance(memory, film).empty());
  PassFilm pass(memory, kWidth, kHeight);
  pass.pixel(3, 3).add({25, 25, 25});
  pass.pixel(0, 0).add({9, 9, 9});
  film.merge(pass, 1, 2.0);

  double blurred[kWidth * kHeight] = {};
  double mean = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      double sum = 0.0;
      int pixels = 0;
      for (int v = std::max(0, y - 2); v <= std::min(kHeight - 1, y + 2); ++v) {
        for (int u = std::max(0, x - 2); u <= std::min(kWidth - 1, x + 2); ++u, ++pixels) {
          sum += u == 3 && v == 3 ? 25.0 : u == 0 && v == 0 ? 9.0 : 0.0;
        }
      }
      blurred[y * kWidth + x] = sum / pixels;
      mean += blurred[y * kWidth + x] / (kWidth * kHeight);
    }
  }
  const auto expected = expectedLuminance(memory, film);
  for (int i = 0; i < kWidth * kHeight; ++i) {
    EXPECT_NEAR(static_cast<double>(expected[i]), std::max(blurred[i], 0.2 * mean), 1e-6) << i;
  }
  EXPECT_EQ(blurred[5 * kWidth + 6], 0.0) << "the floor is seen somewhere";
}

}  // namespace
}  // namespace awd
