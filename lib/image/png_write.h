// SPDX-License-Identifier: Apache-2.0
// PNG out, to look at.
#pragma once

#include "image/image.h"

namespace awd {

/// Writes 8 bits: R G B in sRGB, clipped, NaN black; without these the first channel in false
/// colours from 0 to its largest finite value. Values are multiplied by 2^exposure; false colours
/// after they were divided by their maximum. AWD_ERROR_IO with path and reason if that fails; an
/// older file of the name is then untouched.
void writePng(const Image& image, const char* path, float exposure);

}  // namespace awd
