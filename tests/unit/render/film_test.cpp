// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <gtest/gtest.h>

namespace awd {
namespace {

TEST(Film, WeighsPassesByTheirSamples) {
  Film film(std::pmr::get_default_resource(), 2, 1);
  Film one(std::pmr::get_default_resource(), 2, 1), three(std::pmr::get_default_resource(), 2, 1);
  one.pixel(0, 0).add({4, 0, 0});
  for (int i = 0; i < 3; ++i) three.pixel(0, 0).add({8, 1, 0});
  film.merge(one, 1);
  film.merge(three, 3);
  EXPECT_EQ(film.samples(), 4u);
  EXPECT_FLOAT_EQ(film.mean(0).x, 7.0f);
  EXPECT_FLOAT_EQ(film.mean(0).y, 0.75f);
  // Samples 4, 8, 8, 8: variance 4, of the mean of four 1.
  EXPECT_FLOAT_EQ(film.variance(0).x, 1.0f);
  EXPECT_EQ(film.mean(1), Rgb());
}

TEST(Film, HasNoVarianceBelowTwoSamples) {
  Film film(std::pmr::get_default_resource(), 1, 1), pass(std::pmr::get_default_resource(), 1, 1);
  EXPECT_EQ(film.mean(0), Rgb());
  pass.pixel(0, 0).add({4, 4, 4});
  film.merge(pass, 1);
  EXPECT_EQ(film.variance(0), Rgb());
}

}  // namespace
}  // namespace awd
