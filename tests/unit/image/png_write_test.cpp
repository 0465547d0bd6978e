// SPDX-License-Identifier: Apache-2.0
#include "image/png_write.h"

#include <gtest/gtest.h>
#include <png.h>

#include <array>
#include <cmath>

#include "support.h"

namespace awd {
namespace {

using test::errorOf;

using Pixel = std::array<int, 3>;

class PngWrite : public test::ImageTest {
 protected:
  std::string file() const { return path("image.png"); }

  /// Writes and has libpng read it again: the colours of all pixels.
  std::vector<Pixel> shown(const Image& image, float exposure = 0) {
    writePng(image, file().c_str(), exposure);
    png_image png = {};
    png.version = PNG_IMAGE_VERSION;
    EXPECT_TRUE(png_image_begin_read_from_file(&png, file().c_str())) << png.message;
    EXPECT_EQ(png.format, static_cast<png_uint_32>(PNG_FORMAT_RGB));
    EXPECT_EQ(png.width, image.width());
    EXPECT_EQ(png.height, image.height());
    std::vector<png_byte> bytes(PNG_IMAGE_SIZE(png));
    EXPECT_TRUE(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr)) << png.message;
    std::vector<Pixel> colours;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      colours.push_back({bytes[i], bytes[i + 1], bytes[i + 2]});
    }
    return colours;
  }

  Ref<Image> row(const char* name, const std::vector<float>& pixels) {
    Ref<Image> image = Image::make(context(), static_cast<uint32_t>(pixels.size()), 1);
    image->setChannel(name, pixels.data());
    return image;
  }
};

constexpr float kInfinity = std::numeric_limits<float>::infinity();

TEST_F(PngWrite, EncodesColoursInSrgb) {
  const std::vector<float> red = {0, 1, 0.5f, 0.18f, 0.002f, -1, 2, NAN, kInfinity, -kInfinity};
  const std::vector<int> expected = {0, 255, 188, 118, 7, 0, 255, 0, 255, 0};
  const Ref<Image> image = row("R", red);
  image->setChannel("G", std::vector<float>(red.size(), 0.0f).data());
  image->setChannel("B", std::vector<float>(red.size(), 0.25f).data());
  image->setChannel("A", red.data());  // of no interest
  const auto colours = shown(*image);
  ASSERT_EQ(colours.size(), red.size());
  for (std::size_t i = 0; i < red.size(); ++i) {
    EXPECT_EQ(colours[i], (Pixel{expected[i], 0, 137})) << red[i];
  }
  EXPECT_EQ(shown(*image, -1)[1], (Pixel{188, 0, 99}));
  EXPECT_EQ(shown(*image, 2)[3], (Pixel{221, 0, 255}));
}

TEST_F(PngWrite, KeepsRowsInOrder) {
  const Ref<Image> image = Image::make(context(), 3, 5);
  std::vector<float> pixels(15, 0.0f);
  pixels[3 * 4 + 1] = 1;
  for (const char* name : {"R", "G", "B"}) image->setChannel(name, pixels.data());
  const auto colours = shown(*image);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(colours[i][0], i == 13 ? 255 : 0) << i;
}

TEST_F(PngWrite, ShowsOneChannelInFalseColours) {
  const Pixel dark = {1, 6, 45}, middle = {198, 76, 117}, bright = {251, 247, 224};
  const Pixel black = {0, 0, 0};
  const Ref<Image> image = row("Y", {0, 3e-20f, 6e-20f, -1, NAN, kInfinity});
  image->setChannel("Z", std::vector<float>(6, 1.0f).data());  // not the first
  EXPECT_EQ(shown(*image), (std::vector<Pixel>{dark, middle, bright, dark, black, bright}));
  EXPECT_EQ(shown(*image, 1)[1], bright);
  EXPECT_EQ(shown(*image, -1)[2], middle);
  EXPECT_EQ(shown(*row("Y", {0, 0})), (std::vector<Pixel>{dark, dark}));
  EXPECT_EQ(shown(*row("Y", {-3, -1})), (std::vector<Pixel>{dark, dark}));
  EXPECT_EQ(shown(*row("R", {1, 0})), (std::vector<Pixel>{bright, dark}));
  EXPECT_EQ(shown(*row("Y", {1e-44f, 3e38f})), (std::vector<Pixel>{dark, bright}));
}

TEST_F(PngWrite, RefusesWhatItCantWrite) {
  const Ref<Image> image = Image::make(context(), 65536, 65536);
  const auto write = [&] { writePng(*image, file().c_str(), 0); };
  EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_OPERATION, write), "no channel");
  for (const float exposure : {NAN, kInfinity, -kInfinity}) {
    EXPECT_CONTAINS(
        errorOf(AWD_ERROR_INVALID_ARGUMENT, [&] { writePng(*image, file().c_str(), exposure); }),
        "exposure");
  }
  EXPECT_EQ(fileCount(), 0u);
}

TEST_F(PngWrite, LeavesTheOldFileWhenItFails) {
  const Ref<Image> image = row("Y", test::awkward(1000));
  test::writeBytes(file(), "old");
  EXPECT_CONTAINS(errorOf(AWD_ERROR_IO, [&] { writePng(*image, path("no/image.png").c_str(), 0); }),
                  "No such file");
  for (const rlim_t room : {0, 1, 100}) {
    const test::FullDisk disk(room);
    const auto text = errorOf(AWD_ERROR_IO, [&] { writePng(*image, file().c_str(), 0); });
    EXPECT_CONTAINS(text, file());
    EXPECT_CONTAINS(text, "File too large");
  }
  EXPECT_EQ(test::readBytes(file()), "old");
  EXPECT_EQ(fileCount(), 1u);
}

}  // namespace
}  // namespace awd
