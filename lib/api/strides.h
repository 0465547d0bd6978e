// SPDX-License-Identifier: Apache-2.0
// Where the pixels of a host's image lie.
#pragma once

#include <cstddef>
#include <limits>

#include "util/error.h"

namespace awd {

/// Distances in bytes, 0 in arguments meaning packed. Pixels don't overlap, and all of them lie
/// within what memory can have at most.
struct Strides {
  std::size_t pixel, row;

  Strides(std::size_t pixelStride, std::size_t rowStride, std::size_t pixelSize, std::size_t width,
          std::size_t height)
      : pixel(pixelStride ? pixelStride : pixelSize), row(rowStride) {
    constexpr auto kMost = static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max());
    if (pixel < pixelSize) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "pixelStride is %zu: a pixel has %zu bytes", pixelStride,
           pixelSize);
    }
    if (pixel > kMost / width) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "pixelStride is %zu: no memory has %zu such pixels",
           pixelStride, width);
    }
    if (row == 0) row = pixel * width;
    const std::size_t least = (width - 1) * pixel + pixelSize;
    if (row < least) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "rowStride is %zu: a row of %zu pixels has %zu bytes",
           rowStride, width, least);
    }
    if (row > kMost / height) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "rowStride is %zu: no memory has %zu such rows", rowStride,
           height);
    }
  }
};

}  // namespace awd
