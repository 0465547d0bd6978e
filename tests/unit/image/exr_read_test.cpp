// SPDX-License-Identifier: Apache-2.0
#include "image/exr_read.h"

#include <ImfChannelList.h>
#include <ImfFloatAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfRgbaFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include "exr_files.h"
#include "support.h"

namespace awd {
namespace {

using test::FileKind;
using test::smooth;

class ExrRead : public test::ImageTest {
 protected:
  Ref<Image> read() { return readExr(context(), path().c_str()); }

  /// That channel `name` is scale * smooth(.., channel) + up to `tolerance`, where `inside` is.
  static void expectSmooth(const Image& image, const char* name, int channel, float scale = 1,
                           float tolerance = 0) {
    const Image::Pixels* const pixels = image.channel(name);
    ASSERT_NE(pixels, nullptr) << name;
    for (uint32_t y = 0; y < image.height(); ++y) {
      for (uint32_t x = 0; x < image.width(); ++x) {
        const float expected = scale * smooth(static_cast<int>(x), static_cast<int>(y), channel);
        ASSERT_NEAR((*pixels)[y * image.width() + x], expected, tolerance)
            << name << " at " << x << " " << y;
      }
    }
  }
  static void expectRgb(const Image& image, const FileKind& kind, float tolerance = 0) {
    EXPECT_EQ(image.width(), static_cast<uint32_t>(kind.width));
    EXPECT_EQ(image.height(), static_cast<uint32_t>(kind.height));
    EXPECT_EQ(image.channels().size(), 3u);
    const bool uints = kind.type == Imf::UINT;
    if (uints) tolerance += 1;  // they are rounded down
    expectSmooth(image, "R", 0, uints ? 1000 : 1, tolerance);
    expectSmooth(image, "G", 1, uints ? 1000 : 1, tolerance);
    expectSmooth(image, "B", 2, uints ? 1000 : 1, tolerance);
  }

  /// What a compression may lose.
  static float lossOf(const FileKind& kind) {
    if (kind.type == Imf::UINT) return 0;
    switch (kind.compression) {
      case Imf::PXR24_COMPRESSION:
        return kind.type == Imf::FLOAT ? 1e-4f : 0;
      case Imf::B44_COMPRESSION:
      case Imf::B44A_COMPRESSION:
        return kind.type == Imf::HALF ? 0.02f : 0;
      case Imf::DWAA_COMPRESSION:
      case Imf::DWAB_COMPRESSION:
        return 0.03f;
      default:
        return 0;
    }
  }
};

TEST_F(ExrRead, EveryCompressionOfEveryTypeInScanlinesAndTiles) {
  for (const Imf::Compression compression : test::compressions()) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
      SCOPED_TRACE(testing::Message() << "compression " << compression << ", type " << type);
      FileKind kind;
      kind.compression = compression;
      kind.type = type;
      test::writeScanlines(path(), kind);
      expectRgb(*read(), kind, lossOf(kind));
      test::writeTiles(path(), kind, Imf::ONE_LEVEL);
      expectRgb(*read(), kind, lossOf(kind));
    }
  }
}

TEST_F(ExrRead, LineOrdersLevelsAndWindows) {
  for (const Imf::LineOrder order : {Imf::INCREASING_Y, Imf::DECREASING_Y, Imf::RANDOM_Y}) {
    for (const int shift : {0, -1000, 123456}) {
      SCOPED_TRACE(testing::Message() << "order " << order << ", shift " << shift);
      FileKind kind;
      kind.order = order;
      kind.left = shift;
      kind.top = 3 - shift;
      if (order != Imf::RANDOM_Y) {
        test::writeScanlines(path(), kind);
        expectRgb(*read(), kind);
      }
      for (const Imf::LevelMode mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS, Imf::RIPMAP_LEVELS}) {
        test::writeTiles(path(), kind, mode);
        expectRgb(*read(), kind);
      }
    }
  }
}

TEST_F(ExrRead, OnePixelAndLongRows) {
  for (const auto& [width, height] : {std::pair{1, 1}, {3000, 1}, {1, 3000}}) {
    FileKind kind;
    kind.width = width;
    kind.height = height;
    test::writeScanlines(path(), kind);
    expectRgb(*read(), kind);
    test::writeTiles(path(), kind, Imf::MIPMAP_LEVELS);
    expectRgb(*read(), kind);
  }
}

TEST_F(ExrRead, PartsKeepTheirNamesAndPlaces) {
  FileKind kind;
  kind.left = -20;
  test::writeParts(path(), kind);
  const Ref<Image> image = read();
  ASSERT_EQ(image->channels().size(), 3u);
  expectSmooth(*image, "Y", 0);
  expectSmooth(*image, "second.Y", 1);
  const Image::Pixels* const third = image->channel("third.Y");
  ASSERT_NE(third, nullptr);
  for (int y = 0; y < kind.height; ++y) {
    for (int x = 0; x < kind.width; ++x) {
      const bool inside = x >= 5 && x < 5 + kind.width / 2 && y >= 5 && y < 5 + kind.height / 2;
      EXPECT_EQ((*third)[static_cast<std::size_t>(y * kind.width + x)],
                inside ? smooth(x - 5, y - 5, 2) : 0.0f);
    }
  }
}

/// The second part's channel R of part "a.b" is not the first's channel "b.R" of part "a".
TEST_F(ExrRead, RefusesTwoChannelsOfOneName) {
  const char* const names[2][2] = {{"first", "a.b.R"}, {"a.b", "R"}};
  test::writeTwoParts(path(), names);
  EXPECT_CONTAINS(test::errorOf(AWD_ERROR_UNSUPPORTED, [&] { read(); }), "a.b.R");
}

/// In memory its one pixel would take 17 GB.
TEST_F(ExrRead, RefusesWhatIsOutOfAllProportion) {
  test::writeSubsampled(path(), 65536);
  test::errorOf(AWD_ERROR_IO, [&] { read(); });
  test::writeSubsampled(path(), 64);
  EXPECT_EQ(read()->channels().size(), 1u);
}

TEST_F(ExrRead, LuminanceAndChromaAsOpenExrDoes) {
  for (const bool alpha : {false, true}) {
    FileKind kind;
    kind.left = -4;
    kind.top = 6;
    kind.width = 38;
    kind.height = 24;
    test::writeLumaChroma(path(), kind, alpha);
    const Ref<Image> image = read();
    ASSERT_EQ(image->channels().size(), alpha ? 4u : 3u);
    // What subsampling loses, at the border above all.
    expectSmooth(*image, "R", 0, 1, 0.1f);
    expectSmooth(*image, "G", 1, 1, 0.1f);
    expectSmooth(*image, "B", 2, 1, 0.1f);
    if (alpha) expectSmooth(*image, "A", 3);

    Imf::RgbaInputFile file(path().c_str());
    std::vector<Imf::Rgba> pixels(image->pixelCount());
    file.setFrameBuffer(pixels.data() - kind.left - kind.top * kind.width, 1,
                        static_cast<std::size_t>(kind.width));
    file.readPixels(kind.top, kind.top + kind.height - 1);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      ASSERT_EQ((*image->channel("R"))[i], pixels[i].r);
      ASSERT_EQ((*image->channel("G"))[i], pixels[i].g);
      ASSERT_EQ((*image->channel("B"))[i], pixels[i].b);
    }
  }
}

/// A file of 4 x 4 pixels at (2, 4) with these channels, where pixel (x, y) is 10 y + x.
void writeSampled(const std::string& path,
                  const std::vector<std::pair<const char*, Imath::V2i>>& channels) {
  const Imath::Box2i window({2, 4}, {5, 7});
  Imf::Header header(window, window);
  std::vector<float> pixels;
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) pixels.push_back(static_cast<float>(10 * y + x));
  }
  Imf::FrameBuffer frame;
  for (const auto& [name, sampling] : channels) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT, sampling.x, sampling.y));
    frame.insert(
        name, Imf::Slice::Make(Imf::FLOAT, pixels.data(), window,
                               4 * static_cast<std::size_t>(sampling.x),
                               16 * static_cast<std::size_t>(sampling.y), sampling.x, sampling.y));
  }
  header.insert("owner", Imf::StringAttribute("nobody"));
  header.insert("awd.seed", Imf::StringAttribute("7"));
  header.insert("name", Imf::StringAttribute("a name of OpenEXR's"));
  header.insert("speed", Imf::FloatAttribute(3.0f));
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(4);
}

TEST_F(ExrRead, RepeatsSubsampledChannels) {
  writeSampled(path(), {{"full", {1, 1}}, {"half", {2, 2}}, {"wide", {1, 4}}, {"tall", {2, 1}}});
  const Ref<Image> image = read();
  const auto is = [&](const char* name, const std::vector<float>& pixels) {
    EXPECT_TRUE(test::sameBits(image->channel(name), pixels)) << name;
  };
  is("full", {0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23, 30, 31, 32, 33});
  is("half", {0, 0, 2, 2, 0, 0, 2, 2, 20, 20, 22, 22, 20, 20, 22, 22});
  is("wide", {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3});
  is("tall", {0, 0, 2, 2, 10, 10, 12, 12, 20, 20, 22, 22, 30, 30, 32, 32});
}

TEST_F(ExrRead, RefusesChromaThatOpenExrDoesNotKnow) {
  writeSampled(path(), {{"Y", {1, 1}}, {"RY", {2, 1}}, {"BY", {2, 1}}});
  EXPECT_CONTAINS(test::errorOf(AWD_ERROR_UNSUPPORTED, [&] { read(); }), "2 x 1");
}

TEST_F(ExrRead, KeepsLuminanceWithoutChroma) {
  writeSampled(path(), {{"Y", {1, 1}}, {"BY", {2, 2}}});
  const Ref<Image> image = read();
  EXPECT_NE(image->channel("Y"), nullptr);
  EXPECT_NE(image->channel("BY"), nullptr);
}

TEST_F(ExrRead, TakesTextAttributesAsMetadata) {
  writeSampled(path(), {{"Y", {1, 1}}});
  const Ref<Image> image = read();
  EXPECT_EQ(image->metadata().size(), 2u);
  EXPECT_STREQ(image->metadataValue("owner"), "nobody");
  EXPECT_STREQ(image->metadataValue("awd.seed"), "7");
}

TEST_F(ExrRead, SaysWhatIsNotAPicture) {
  const auto errorOfRead = [&](const std::string& name) {
    return test::errorOf(AWD_ERROR_IO, [&] { readExr(context(), name.c_str()); });
  };
  EXPECT_CONTAINS(errorOfRead(path("missing.exr")), "No such file");
  EXPECT_CONTAINS(errorOfRead(path("")), "Is a directory");
  test::writeBytes(path("empty.exr"), "");
  EXPECT_CONTAINS(errorOfRead(path("empty.exr")), "empty.exr\": the file is empty");
  test::writeBytes(path("text.exr"), "P3\n1 1\n255\n0 0 0\n");
  EXPECT_CONTAINS(errorOfRead(path("text.exr")), "not an OpenEXR file");
}

}  // namespace
}  // namespace awd
