// SPDX-License-Identifier: Apache-2.0
#include "render/expected_luminance.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace awd {
namespace {

TEST(ExpectedLuminance, IsTheMeanOfTheNeighbourhoodOrAFifthOfTheImages) {
  std::pmr::memory_resource* memory = std::pmr::get_default_resource();
  constexpr int kWidth = 7, kHeight = 6;
  Film film(memory, kWidth, kHeight);
  EXPECT_TRUE(expectedLuminance(memory, film).empty());
  PassFilm pass(memory, kWidth, kHeight);
  pass.pixel(3, 3).add({25, 25, 25}, true);
  pass.pixel(0, 0).add({9, 9, 9}, true);
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
