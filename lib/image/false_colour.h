// SPDX-License-Identifier: Apache-2.0
// Numbers made visible: a range of colours from dark blue over red to a bright cream, in which
// equal steps of the number are equal steps of lightness.
#pragma once

#include <array>
#include <cstdint>

namespace awd {

/// The colour in sRGB of a number from 0 to 1; others are clipped.
std::array<uint8_t, 3> falseColour(float number);

}  // namespace awd
