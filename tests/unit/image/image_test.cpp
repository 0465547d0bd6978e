// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include <gtest/gtest.h>

#include <limits>

#include "support.h"

namespace awd {
namespace {

using test::awkward;
using test::errorOf;
using test::sameBits;

using ImageClass = test::ImageTest;

TEST_F(ImageClass, RefusesSizesOutOfRange) {
  for (const auto& [width, height] :
       {std::pair{0u, 1u}, {1u, 0u}, {65537u, 1u}, {1u, 65537u}, {~0u, ~0u}}) {
    EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_ARGUMENT,
                            [&, w = width, h = height] { Image::make(context(), w, h); }),
                    "65536");
  }
  EXPECT_EQ(Image::make(context(), 65536, 65536)->pixelCount(), std::size_t{1} << 32);
}

TEST_F(ImageClass, KeepsChannelsSortedAndReplacesThem) {
  const Ref<Image> image = Image::make(context(), 3, 2);
  for (const char* name : {"variance.R", "R", "Y", "B", "samples.Y"}) {
    image->setChannel(name, awkward(6, 1).data());
  }
  const auto second = awkward(6, 2);
  image->setChannel("R", second.data());
  std::string names;
  for (const auto& entry : image->channels()) names.append(entry.first).append(" ");
  EXPECT_EQ(names, "B R Y samples.Y variance.R ");
  EXPECT_TRUE(sameBits(image->channel("R"), second));
  EXPECT_TRUE(sameBits(image->channel("variance.R"), awkward(6, 1)));
  EXPECT_EQ(image->channel("G"), nullptr);
}

TEST_F(ImageClass, HonoursStrides) {
  const Ref<Image> image = Image::make(context(), 3, 2);
  // Three interleaved floats, rows 44 bytes apart, at an odd address.
  std::vector<char> bytes(1 + 2 * 44, 'x');
  const auto put = [&](std::size_t at, float value) { std::memcpy(&bytes[at], &value, 4); };
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 3; ++i) put(1 + j * 44 + i * 12, static_cast<float>(10 * j + i));
  }
  image->setChannel("Y", reinterpret_cast<const float*>(&bytes[1]), 12, 44);
  EXPECT_TRUE(sameBits(image->channel("Y"), {0, 1, 2, 10, 11, 12}));

  // Rows of such pixels, packed.
  put(1 + 36, 10);
  put(1 + 48, 11);
  put(1 + 60, 12);
  image->setChannel("P", reinterpret_cast<const float*>(&bytes[1]), 12, 0);
  EXPECT_TRUE(sameBits(image->channel("P"), {0, 1, 2, 10, 11, 12}));

  // Out, column by column; what lies between stays.
  std::vector<float> columns(12, -7.0f);
  image->getChannel("Y", columns.data(), 16, 8);
  EXPECT_EQ(columns, (std::vector<float>{0, -7, 10, -7, 1, -7, 11, -7, 2, -7, 12, -7}));
  std::vector<float> packed(6);
  image->getChannel("Y", packed.data());
  EXPECT_EQ(packed, (std::vector<float>{0, 1, 2, 10, 11, 12}));
}

TEST_F(ImageClass, RefusesStridesThatOverlapOrOverflow) {
  const Ref<Image> image = Image::make(context(), 3, 2);
  float pixels[6] = {};
  constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();
  for (const auto& [pixelStride, rowStride] : {std::pair<std::size_t, std::size_t>{3, 0},
                                               {0, 3},
                                               {huge, 0},
                                               {huge / 8, 0},
                                               {0, huge},
                                               {huge / 2, 12}}) {
    const std::string text =
        errorOf(AWD_ERROR_INVALID_ARGUMENT,
                [&, p = pixelStride, r = rowStride] { image->setChannel("Y", pixels, p, r); });
    EXPECT_CONTAINS(text, "Stride");
  }
  EXPECT_TRUE(image->channels().empty());
}

TEST_F(ImageClass, ChecksNames) {
  const Ref<Image> image = Image::make(context(), 1, 1);
  const float pixel = 1;
  for (const std::string& name :
       {std::string(), std::string(64, 'n'), std::string("a\nb"), std::string("\xC3\xA4")}) {
    EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_ARGUMENT, [&] { image->setChannel(name, &pixel); }),
                    "name has");
    EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_ARGUMENT, [&] { image->setMetadata(name, ""); }),
                    "key has");
  }
  image->setChannel(std::string(63, 'n'), &pixel);
  image->setMetadata(std::string(63, 'k'), "value");
  EXPECT_NE(image->channel(std::string(63, 'n')), nullptr);
}

TEST_F(ImageClass, NamesTheChannelsThereAre) {
  const Ref<Image> image = Image::make(context(), 1, 1);
  float pixel = 1;
  EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_ARGUMENT, [&] { image->getChannel("Z", &pixel); }),
                  "it has none");
  image->setChannel("R", &pixel);
  image->setChannel("variance.R", &pixel);
  const std::string text =
      errorOf(AWD_ERROR_INVALID_ARGUMENT, [&] { image->getChannel("Z", &pixel); });
  EXPECT_CONTAINS(text, "\"Z\"");
  EXPECT_CONTAINS(text, "R variance.R");
}

TEST_F(ImageClass, KeepsMetadata) {
  const Ref<Image> image = Image::make(context(), 1, 1);
  image->setMetadata("awd.seed", "1");
  image->setMetadata("awd.seed", "2");
  image->setMetadata("owner", "");
  EXPECT_STREQ(image->metadataValue("awd.seed"), "2");
  EXPECT_STREQ(image->metadataValue("owner"), "");
  EXPECT_EQ(image->metadataValue("awd"), nullptr);
  image->removeMetadata("awd.seed");
  image->removeMetadata("awd.seed");
  EXPECT_EQ(image->metadataValue("awd.seed"), nullptr);
  EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_ARGUMENT, [&] { image->setMetadata("channels", "R"); }),
                  "\"channels\"");
}

}  // namespace
}  // namespace awd
