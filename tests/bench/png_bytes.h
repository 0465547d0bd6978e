// SPDX-License-Identifier: Apache-2.0
// Images as PNG files in memory, for the report.
#pragma once

#include <string>

#include "metrics.h"

namespace bench {

/// The bytes of a file as `awd png` writes it: sRGB, clipped, values multiplied by 2^exposure
/// before.
std::string pngOf(const command::RgbImage& image, float exposure = 0.0f);

/// The exposure that makes the image's mean a middle grey, so that scenes of any brightness can be
/// seen; 0 of a black image. Of a reference, for all images compared with it.
float exposureOf(const command::RgbImage& image);

/// Relative differences in false colours: blue where the image is darker than the reference, red
/// where it is brighter, full at 50 % of it; black where they are equal. What is below a tenth of
/// the reference's mean counts as that bright. Both of one size.
std::string differencePng(const command::RgbImage& image, const command::RgbImage& reference);

}  // namespace bench
