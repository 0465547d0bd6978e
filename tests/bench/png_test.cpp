// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <png.h>

#include <vector>

#include "png_bytes.h"

namespace bench {
namespace {

using Pixel = std::vector<int>;

/// The pixels of a file, each of three values.
std::vector<Pixel> pixelsOf(const std::string& bytes) {
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) << png.message;
  png.format = PNG_FORMAT_RGB;
  std::vector<png_byte> values(PNG_IMAGE_SIZE(png));
  EXPECT_TRUE(png_image_finish_read(&png, nullptr, values.data(), 0, nullptr)) << png.message;
  std::vector<Pixel> pixels;
  for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
    pixels.push_back({values[i], values[i + 1], values[i + 2]});
  }
  return pixels;
}

command::RgbImage greys(const std::vector<float>& values) {
  command::RgbImage image = {static_cast<uint32_t>(values.size()), 1, {}};
  for (const float value : values) image.values.insert(image.values.end(), 3, value);
  return image;
}

TEST(ReportPng, IsSrgbClippedAndExposed) {
  const command::RgbImage image = greys({0.0f, 0.25f, 1.0f, 5.0f, -1.0f});
  const std::vector<Pixel> plain = pixelsOf(pngOf(image));
  // 188 is sRGB's 0.5, and 137 its 0.25.
  EXPECT_EQ(plain, (std::vector<Pixel>{
                       {0, 0, 0}, {137, 137, 137}, {255, 255, 255}, {255, 255, 255}, {0, 0, 0}}));
  EXPECT_EQ(pixelsOf(pngOf(image, 1.0f))[1], (Pixel{188, 188, 188}));
}

TEST(ReportPng, ExposureMakesTheMeanAMiddleGrey) {
  EXPECT_FLOAT_EQ(exposureOf(greys({0.09f, 0.09f})), 1.0f);
  EXPECT_EQ(exposureOf(greys({0.0f})), 0.0f);
}

TEST(ReportPng, DifferenceIsBlackWhereEqualBlueWhereDarkerRedWhereBrighter) {
  const std::vector<Pixel> pixels =
      pixelsOf(differencePng(greys({1.0f, 0.4f, 1.6f}), greys({1.0f, 1.0f, 1.0f})));
  EXPECT_EQ(pixels[0], (Pixel{0, 0, 0}));
  EXPECT_EQ(pixels[1][2], 255);
  EXPECT_LT(pixels[1][0], pixels[1][2]);
  EXPECT_EQ(pixels[2][0], 255);
  EXPECT_LT(pixels[2][2], pixels[2][0]);
  EXPECT_ANY_THROW(differencePng(greys({1.0f}), greys({1.0f, 1.0f})));
}

}  // namespace
}  // namespace bench
