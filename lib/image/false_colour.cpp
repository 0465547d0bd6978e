// SPDX-License-Identifier: Apache-2.0
#include "image/false_colour.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace awd {

std::array<uint8_t, 3> falseColour(float number) {
  // CIE L* from 3 to 97 in equal steps while the hue turns from blue to yellow.
  static constexpr uint8_t kColours[][3] = {{1, 6, 45},      {42, 22, 93},    {94, 34, 120},
                                            {149, 51, 126},  {198, 76, 117},  {231, 114, 104},
                                            {246, 160, 108}, {247, 207, 149}, {251, 247, 224}};
  constexpr int kSteps = static_cast<int>(sizeof kColours / sizeof kColours[0]) - 1;
  const float clipped = number > 0 ? std::fmin(number, 1.0f) : 0.0f;
  const float place = clipped * kSteps;
  const int step = std::min(static_cast<int>(place), kSteps - 1);
  const float t = place - static_cast<float>(step);
  std::array<uint8_t, 3> colour;
  for (std::size_t c = 0; c < 3; ++c) {
    const float low = kColours[step][c], high = kColours[step + 1][c];
    colour[c] = static_cast<uint8_t>(std::lround(low + t * (high - low)));
  }
  return colour;
}

}  // namespace awd
