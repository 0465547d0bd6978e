// SPDX-License-Identifier: Apache-2.0
#include "image/false_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace awd {
namespace {

using Colour = std::array<uint8_t, 3>;

double lightness(const Colour& colour) {
  double linear[3];
  for (int c = 0; c < 3; ++c) {
    const double v = colour[c] / 255.0;
    linear[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  const double y = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

TEST(FalseColour, LightnessGrowsInEqualSteps) {
  for (int i = 0; i <= 256; ++i) {
    const double number = i / 256.0;
    // The colours between the fixed ones are mixed in sRGB, which is not quite even.
    EXPECT_NEAR(lightness(falseColour(static_cast<float>(number))), 3 + 94 * number, 1.5) << i;
  }
}

TEST(FalseColour, ClipsWhatIsNotBetween0And1) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const Colour dark = {1, 6, 45}, bright = {251, 247, 224};
  EXPECT_EQ(falseColour(0), dark);
  EXPECT_EQ(falseColour(-infinity), dark);
  EXPECT_EQ(falseColour(std::nanf("")), dark);
  EXPECT_EQ(falseColour(1), bright);
  EXPECT_EQ(falseColour(1.01f), bright);
  EXPECT_EQ(falseColour(infinity), bright);
}

}  // namespace
}  // namespace awd
