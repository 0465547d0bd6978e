// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "util/random.h"

namespace awd {
namespace {

TEST(Film, WeighsPassesByTheirSamples) {
  Film film(std::pmr::get_default_resource(), 2, 1);
  PassFilm one(std::pmr::get_default_resource(), 2, 1);
  PassFilm three(std::pmr::get_default_resource(), 2, 1);
  one.pixel(0, 0).add({4, 0, 0}, true);
  for (int i = 0; i < 3; ++i) three.pixel(0, 0).add({8, 1, 0}, i == 1);
  film.merge(one, 1, 0.5);
  film.merge(three, 3, 0.5);
  EXPECT_EQ(film.samples(), 4u);
  EXPECT_FLOAT_EQ(film.mean(0).x, 7.0f);
  EXPECT_FLOAT_EQ(film.mean(0).y, 0.75f);
  // Samples 4, 8, 8, 8: variance 4, of the mean of four 1.
  EXPECT_FLOAT_EQ(film.variance(0).x, 1.0f);
  EXPECT_EQ(film.mean(1), Rgb());
}

TEST(Film, HasNoVarianceBelowTwoSamples) {
  Film film(std::pmr::get_default_resource(), 1, 1);
  PassFilm pass(std::pmr::get_default_resource(), 1, 1);
  EXPECT_EQ(film.mean(0), Rgb());
  pass.pixel(0, 0).add({4, 4, 4}, true);
  film.merge(pass, 1, 1.0);
  EXPECT_EQ(film.variance(0), Rgb());
}

/// Radiance is of floats, and its square may not be.
TEST(Film, VarianceStaysFinite) {
  Film film(std::pmr::get_default_resource(), 1, 1);
  PassFilm pass(std::pmr::get_default_resource(), 1, 1);
  pass.pixel(0, 0).add({1e30f, 1e-30f, 3e38f}, true);
  pass.pixel(0, 0).add({3e30f, 3e-30f, 0.0f}, false);
  film.merge(pass, 2, 1.0);
  constexpr float kMost = std::numeric_limits<float>::max();
  EXPECT_EQ(film.variance(0), Rgb({kMost, 0.0f, kMost}));
  EXPECT_FLOAT_EQ(film.mean(0).x, 2e30f);
  EXPECT_FLOAT_EQ(film.mean(0).y, 2e-30f);
}

// Passes of 4 and 8 samples of standard deviations 3 and 1, weighted by inverse variance: the
// mean's variance is 1 / (4/9 + 8). What the film says of it, averaged over 20,000 pixels, is
// within 5 standard errors, about 0.3 % each (false alarms: 6e-7).
TEST(Film, KnowsTheVarianceOfAWeightedMean) {
  constexpr uint32_t kPixels = 20000;
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();
  Film film(memory, kPixels, 1);
  RandomStream random(3, 0, 0, 0);
  const auto pass = [&](uint32_t samples, double deviation) {
    PassFilm result(memory, kPixels, 1);
    for (uint32_t x = 0; x < kPixels; ++x) {
      for (uint32_t s = 0; s < samples; ++s) {
        const double uniform = std::sqrt(12.0) * (random.next() - 0.5);  // of variance 1
        result.pixel(x, 0).add({static_cast<float>(10.0 + deviation * uniform), 0, 0}, s % 2 == 0);
      }
    }
    film.merge(result, samples, 1.0 / (deviation * deviation));
  };
  pass(4, 3.0);
  pass(8, 1.0);
  double said = 0.0, seen = 0.0;
  for (uint32_t x = 0; x < kPixels; ++x) {
    said += static_cast<double>(film.variance(x).x) / kPixels;
    seen += std::pow(static_cast<double>(film.mean(x).x) - 10.0, 2) / kPixels;
  }
  const double exact = 1.0 / (4.0 / 9.0 + 8.0);
  EXPECT_NEAR(seen / exact, 1.0, 0.05);  // standard error sqrt(2 / 20,000)
  EXPECT_NEAR(said / exact, 1.0, 0.02);
  // Its error of the image, one of whose three channels is lit, by the two halves of the samples.
  const FilmError error = film.error();
  const double truth = std::sqrt(seen / 3.0) / (10.0 / 3.0);
  EXPECT_NEAR(error.error / truth, 1.0, 0.05);
  EXPECT_LT(error.lower, truth);
  EXPECT_GT(error.upper, truth);
  EXPECT_LT(error.upper / error.lower, 1.05);
}

// Of an image whose error sits in five of a hundred pixels, as at the edge of a small lamp. Null
// hypothesis: its normal error lies in the interval with probability 0.95, and half of the rest on
// either side. Of 4,000 films 0.935 to 0.965 then have it inside, but for 2e-5, and 0.014 to 0.036
// above, but for 1e-5.
TEST(Film, KnowsAnErrorOfFewPixels) {
  constexpr uint32_t kPixels = 100, kNoisy = 5, kSamples = 24;
  constexpr int kFilms = 4000;
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();
  RandomStream random(5, 0, 0, 0);
  int inside = 0, above = 0;
  for (int f = 0; f < kFilms; ++f) {
    Film film(memory, kPixels, 1);
    PassFilm pass(memory, kPixels, 1);
    for (uint32_t x = 0; x < kPixels; ++x) {
      for (uint32_t s = 0; s < kSamples; ++s) {
        // Twelve uniforms make a normal number, as far as can be told here.
        double value = 10.0 + (x < kNoisy ? -6.0 : 0.0);
        for (int i = 0; i < 12 && x < kNoisy; ++i) value += random.next();
        pass.pixel(x, 0).add({static_cast<float>(value), 0, 0}, s % 2 == 0);
      }
    }
    film.merge(pass, kSamples, 1.0);
    double squared = 0.0;
    for (uint32_t x = 0; x < kNoisy; ++x) {
      squared += std::pow(static_cast<double>(film.mean(x).x) - 10.0, 2);
    }
    const double truth = std::sqrt(squared / (3.0 * kPixels)) / (10.0 / 3.0);
    const FilmError error = film.error();
    inside += error.lower <= truth && truth <= error.upper;
    above += truth > error.upper;
  }
  EXPECT_NEAR(inside, 0.95 * kFilms, 0.015 * kFilms);
  EXPECT_NEAR(above, 0.025 * kFilms, 0.011 * kFilms);
}

// A pixel by itself tells its error, but hardly: the interval is wide, and not without an end.
TEST(Film, KnowsTheErrorOfOnePixelVaguely) {
  Film film(std::pmr::get_default_resource(), 1, 1);
  PassFilm pass(std::pmr::get_default_resource(), 1, 1);
  pass.pixel(0, 0).add({3, 3, 3}, true);
  pass.pixel(0, 0).add({1, 1, 1}, false);
  film.merge(pass, 2, 1.0);
  EXPECT_DOUBLE_EQ(film.error().error, 0.5);
  EXPECT_NEAR(film.error().upper / 0.5, std::sqrt(648.0), 0.5);  // 97.5 % of F of 1 and 1
  EXPECT_NEAR(0.5 / film.error().lower, std::sqrt(648.0), 0.5);
}

}  // namespace
}  // namespace awd
