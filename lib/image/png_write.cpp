// SPDX-License-Identifier: Apache-2.0
#include "image/png_write.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "image/false_colour.h"
#include "util/atomic_file.h"
#include "util/error.h"

namespace awd {

namespace {

using Bytes = std::pmr::vector<png_byte>;

/// sRGB's transfer function, rounded to 8 bits. NaN is black.
png_byte encode(float linear) {
  if (!(linear > 0)) return 0;
  const float x = std::min(linear, 1.0f);
  const float y = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
  return static_cast<png_byte>(std::lround(255 * y));
}

void encodeColours(const Image::Pixels* const (&channels)[3], float scale, Bytes& bytes) {
  for (std::size_t i = 0; i < channels[0]->size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) bytes[3 * i + c] = encode((*channels[c])[i] * scale);
  }
}

void encodeNumbers(const Image::Pixels& numbers, float scale, Bytes& bytes) {
  float largest = 0;
  for (const float number : numbers) {
    if (std::isfinite(number)) largest = std::max(largest, number);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const float number = numbers[i];
    if (std::isnan(number)) continue;  // black
    // An image without a positive number is dark, whatever it is divided by.
    const auto colour = falseColour(number / (largest > 0 ? largest : 1.0f) * scale);
    std::copy(colour.begin(), colour.end(), bytes.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
}

}  // namespace

void writePng(const Image& image, const char* path, float exposure) {
  if (!std::isfinite(exposure)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "exposure is %g: must be a finite number of stops",
         static_cast<double>(exposure));
  }
  if (image.channels().empty()) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "the image has no channel to write to \"%s\": set one with awdSetImageChannel", path);
  }
  // libpng counts the bytes of an uncompressed image with 32 bits.
  const std::size_t size = 3 * image.pixelCount();
  if (size + image.height() > std::numeric_limits<png_uint_32>::max()) {
    fail(AWD_ERROR_UNSUPPORTED,
         "can't write \"%s\": %u x %u pixels are too many for a PNG; write OpenEXR", path,
         image.width(), image.height());
  }
  const float scale = std::exp2(exposure);
  std::pmr::memory_resource* const memory = image.context().memory();
  Bytes pixels(size, 0, memory);
  const Image::Pixels* const colours[3] = {image.channel("R"), image.channel("G"),
                                           image.channel("B")};
  if (colours[0] && colours[1] && colours[2]) {
    encodeColours(colours, scale, pixels);
  } else {
    encodeNumbers(image.channels().begin()->second, scale, pixels);
  }

  // The simplified interface keeps libpng's setjmp to itself.
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = image.width();
  png.height = image.height();
  png.format = PNG_FORMAT_RGB;
  Bytes packed(PNG_IMAGE_PNG_SIZE_MAX(png), 0, memory);
  png_alloc_size_t packedSize = packed.size();
  if (!png_image_write_to_memory(&png, packed.data(), &packedSize, 0, pixels.data(), 0, nullptr)) {
    fail(AWD_ERROR_IO, "can't write \"%s\": libpng: %s", path, png.message);
  }
  AtomicFile file(path);
  file.write(packed.data(), packedSize);
  file.commit();
}

}  // namespace awd
