// SPDX-License-Identifier: Apache-2.0
#include "png_bytes.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "failure.h"

namespace bench {
namespace {

constexpr double kMiddleGrey = 0.18;
constexpr double kFullDifference = 0.5;  // of the reference
constexpr double kLeastShare = 0.1;      // of the reference's mean: what is darker counts as this

using Bytes = std::vector<png_byte>;

/// sRGB's transfer function, rounded to 8 bits. NaN is black.
png_byte encode(double linear) {
  if (!(linear > 0.0)) return 0;
  const double x = std::min(linear, 1.0);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<png_byte>(std::lround(255.0 * y));
}

std::string pack(uint32_t width, uint32_t height, const Bytes& pixels) {
  // The simplified interface keeps libpng's setjmp to itself.
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = width;
  png.height = height;
  png.format = PNG_FORMAT_RGB;
  std::string packed(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = packed.size();
  if (!png_image_write_to_memory(&png, packed.data(), &size, 0, pixels.data(), 0, nullptr)) {
    throw command::Failure(std::string("can't make a PNG: libpng: ") + png.message);
  }
  packed.resize(size);
  return packed;
}

double meanOf(const command::RgbImage& image) {
  double sum = 0.0;
  for (const float value : image.values) sum += static_cast<double>(value);
  return sum / static_cast<double>(std::max<std::size_t>(1, image.values.size()));
}

/// Of -1 to 1; others are clipped.
std::array<double, 3> colourOf(double difference) {
  const double t = std::clamp(difference, -1.0, 1.0);
  if (t < 0.0) return {0.1 * -t, 0.45 * -t, -t};
  return {t, 0.25 * t, 0.05 * t};
}

}  // namespace

std::string pngOf(const command::RgbImage& image, float exposure) {
  const double scale = std::exp2(static_cast<double>(exposure));
  Bytes pixels(image.values.size());
  std::transform(image.values.begin(), image.values.end(), pixels.begin(),
                 [&](float value) { return encode(static_cast<double>(value) * scale); });
  return pack(image.width, image.height, pixels);
}

float exposureOf(const command::RgbImage& image) {
  const double mean = meanOf(image);
  return mean > 0.0 ? static_cast<float>(std::log2(kMiddleGrey / mean)) : 0.0f;
}

std::string differencePng(const command::RgbImage& image, const command::RgbImage& reference) {
  if (image.values.size() != reference.values.size() || image.width != reference.width) {
    throw std::runtime_error("an image and its reference differ in size");
  }
  const double least = kLeastShare * meanOf(reference);
  Bytes pixels(image.values.size());
  for (std::size_t i = 0; i + 2 < pixels.size(); i += 3) {
    double value = 0.0, known = 0.0;
    for (std::size_t c = 0; c < 3; ++c) {
      value += static_cast<double>(image.values[i + c]) / 3.0;
      known += static_cast<double>(reference.values[i + c]) / 3.0;
    }
    const double floor = std::max(known, least);
    const auto colour = colourOf(floor > 0.0 ? (value - known) / (kFullDifference * floor) : 0.0);
    for (std::size_t c = 0; c < 3; ++c) pixels[i + c] = encode(colour[c]);
  }
  return pack(image.width, image.height, pixels);
}

}  // namespace bench
