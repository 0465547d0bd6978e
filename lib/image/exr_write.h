// SPDX-License-Identifier: Apache-2.0
// OpenEXR out.
#pragma once

#include "image/image.h"

namespace awd {

/// Writes one part of scanlines, top row first, float32, ZIP; metadata as string attributes.
/// AWD_ERROR_IO with path and reason if that fails; an older file of the name is then untouched.
void writeExr(const Image& image, const char* path);

}  // namespace awd
