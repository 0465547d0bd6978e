// SPDX-License-Identifier: Apache-2.0
// Damaged files must end in an error, or at least in a picture, soon and without much memory.
#include "image/exr_check.h"

#include <gtest/gtest.h>

#include <random>

#include "exr_files.h"
#include "image/exr_read.h"
#include "image/exr_write.h"
#include "support.h"

namespace awd {
namespace {

using test::FileKind;

class ExrCheck : public test::ImageTest {
 protected:
  /// Files of every kind, small, as bytes.
  std::vector<std::string> files() {
    std::vector<std::string> result;
    const auto keep = [&] { result.push_back(test::readBytes(path())); };
    FileKind kind;
    kind.width = 7;
    kind.height = 5;
    kind.type = Imf::HALF;
    for (const Imf::Compression compression : test::compressions()) {
      kind.compression = compression;
      test::writeScanlines(path(), kind);
      keep();
    }
    kind.compression = Imf::ZIP_COMPRESSION;
    test::writeTiles(path(), kind, Imf::ONE_LEVEL);
    keep();
    test::writeParts(path(), kind);
    keep();
    kind.compression = Imf::ZIPS_COMPRESSION;
    for (const bool tiles : {false, true}) {
      test::writeDeep(path(), kind, tiles, test::someSamples(kind));
      keep();
    }
    kind.width = 8;
    kind.height = 6;
    test::writeLumaChroma(path(), kind, true);
    keep();
    const Ref<Image> image = Image::make(context(), 11, 9);
    image->setChannel("Y", test::awkward(99).data());
    image->setMetadata("awd.seed", "1");
    writeExr(*image, path().c_str());
    keep();
    return result;
  }

  /// Reads these bytes: whether that gave a picture. Fails on any error but those it may give.
  bool readable(const std::string& bytes) {
    test::writeBytes(path("damaged.exr"), bytes);
    try {
      readExr(context(), path("damaged.exr").c_str());
      return true;
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == AWD_ERROR_IO || error.code() == AWD_ERROR_UNSUPPORTED)
          << error.what();
      EXPECT_CONTAINS(error.what(), "damaged.exr");
    }
    return false;
  }

  /// The file with other bytes `from` the beginning of an attribute on.
  std::string patched(const char* attribute, std::size_t from, const std::string& value) {
    std::string bytes = test::readBytes(path());
    const std::size_t at = bytes.find(attribute);
    EXPECT_NE(at, std::string::npos);
    return bytes.replace(at + from, value.size(), value);
  }
};

TEST_F(ExrCheck, AFileCutOffAnywhereIsAnError) {
  for (const std::string& bytes : files()) {
    EXPECT_TRUE(readable(bytes));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      ASSERT_FALSE(readable(bytes.substr(0, length))) << length << " of " << bytes.size();
    }
  }
}

TEST_F(ExrCheck, RandomDamageNeitherCrashesNorPrintsNorEatsMemory) {
  std::mt19937 random(12345);
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  int unreadable = 0;
  for (const std::string& bytes : files()) {
    for (int i = 0; i < 300; ++i) {
      std::string damaged = bytes;
      for (int flips = 1 + static_cast<int>(random() % 4); flips > 0; --flips) {
        // Half of them in the header, where there is more to break.
        const std::size_t range =
            random() % 2 ? damaged.size() : std::min<std::size_t>(400, damaged.size());
        damaged[random() % range] = static_cast<char>(random());
      }
      unreadable += !readable(damaged);
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_GT(unreadable, 1000);
  EXPECT_LT(counter_.peak, 64u << 20);
}

TEST_F(ExrCheck, RefusesAbsurdClaims) {
  FileKind kind;
  test::writeScanlines(path(), kind);
  constexpr std::size_t window = 11 + 6 + 4;  // "dataWindow", "box2i", size
  const std::string huge("\xFF\xFF\xFF\x3F\xFF\xFF\xFF\x3F", 8);
  const std::string big("\xFF\x7F\0\0\xFF\x7F\0\0", 8);
  const std::string none("\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 8);
  const auto textOf = [&](AWDResult code, const std::string& bytes) {
    return test::errorOf(code, [&] { checkExrHeaders(bytes.data(), bytes.size(), "a.exr"); });
  };
  EXPECT_CONTAINS(textOf(AWD_ERROR_UNSUPPORTED, patched("dataWindow", window + 8, huge)),
                  "1073741824 x 1073741824");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("dataWindow", window + 8, big)), "32768 x 32768");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("dataWindow", window + 8, none)), "empty");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("dataWindow", 0, "D")), "lacks");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("dataWindow", 11 + 6, "\x7F\x7F\x7F\x7F")),
                  "cut off");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("dataWindow", 11 + 6, "\xFF\xFF\xFF\xFF")),
                  "negative");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("dataWindow", 11 + 6, "\x11")), "wrong size");
  EXPECT_CONTAINS(textOf(AWD_ERROR_UNSUPPORTED, test::readBytes(path()).replace(4, 1, "\3")),
                  "version 3");

  test::writeTiles(path(), kind, Imf::ONE_LEVEL);
  constexpr std::size_t tiles = 6 + 9 + 4;  // "tiles", "tiledesc", size
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("tiles", tiles, std::string("\0\0\0\0", 4))),
                  "tiles are empty");
  EXPECT_CONTAINS(textOf(AWD_ERROR_IO, patched("tiles", tiles, "\xFF\xFF\xFF\xFF")), "claims");
}

TEST_F(ExrCheck, TellsDeepFiles) {
  const auto check = [&] {
    const std::string bytes = test::readBytes(path());
    return checkExrHeaders(bytes.data(), bytes.size(), "a.exr");
  };
  const FileKind kind;
  test::writeScanlines(path(), kind);
  EXPECT_FALSE(check());
  test::writeParts(path(), kind);
  EXPECT_FALSE(check());
  FileKind deep;
  deep.compression = Imf::ZIPS_COMPRESSION;
  test::writeDeep(path(), deep, true, test::someSamples(deep));
  EXPECT_TRUE(check());
}

TEST_F(ExrCheck, BelievesTheEmptiestPicturesThereAre) {
  // What compresses best must not be taken for damage.
  FileKind kind;
  kind.width = 2048;
  kind.height = 300;
  kind.black = true;
  for (const Imf::Compression compression : test::compressions()) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT, Imf::UINT}) {
      kind.compression = compression;
      kind.type = type;
      test::writeScanlines(path(), kind);
      EXPECT_TRUE(readable(test::readBytes(path()))) << compression << " " << type;
    }
  }
}

}  // namespace
}  // namespace awd
