// SPDX-License-Identifier: Apache-2.0
// Files that can't be written or read.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/expect.h"
#include "support/handles.h"
#include "support/random.h"

namespace {

using namespace awdtest;
namespace fs = std::filesystem;

constexpr uint32_t kWidth = 61, kHeight = 47;

std::string bytesOf(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void writeBytes(const fs::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class BadFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "awd-image-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    device_ = newDevice(1u);
    must(awdNewImage(device_, kWidth, kHeight, image_.out()));
    Random random(1);
    for (const char* channel : {"R", "G", "B", "extra.Y"}) {
      std::vector<float> pixels(size_t{kWidth} * kHeight);
      for (float& value : pixels) value = static_cast<float>(random.uniform());
      must(awdSetImageChannel(image_, channel, pixels.data(), 0, 0));
    }
  }
  void TearDown() override { fs::remove_all(folder_); }

  void expectUnreadable(const fs::path& path) {
    AWDImage image = nullptr;
    expectFailure(awdReadImage(device_, path.c_str(), &image), AWD_ERROR_IO, {path.string()});
    EXPECT_EQ(image, nullptr);
    awdReleaseImage(image);
  }

  fs::path folder_;
  Device device_;
  Image image_;
};

TEST_F(BadFile, UnwritablePaths) {
  const fs::path folder = folder_ / "folder.exr";
  fs::create_directory(folder);
  for (const fs::path& path :
       {folder_ / "missing" / "a.exr", folder, fs::path("/proc/a.exr"), fs::path("")}) {
    for (const bool exr : {true, false}) {
      const AWDResult result = exr ? awdWriteImageEXR(image_, path.c_str())
                                   : awdWriteImagePNG(image_, path.c_str(), nullptr);
      if (path.empty()) {
        EXPECT_NE(result, AWD_SUCCESS);
      } else {
        expectFailure(result, AWD_ERROR_IO, {path.string()});
      }
    }
  }
  EXPECT_TRUE(fs::is_empty(folder)) << "no half file is left";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no half file is left";
}

TEST_F(BadFile, AnOlderFileSurvivesAFailure) {
  const fs::path path = folder_ / "old.exr";
  Image empty;  // without channels there is nothing to write
  must(awdNewImage(device_, 2, 2, empty.out()));
  writeBytes(path, "precious");
  EXPECT_NE(awdWriteImageEXR(empty, path.c_str()), AWD_SUCCESS);
  EXPECT_EQ(bytesOf(path), "precious");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "no half file is left";
}

TEST_F(BadFile, TruncatedAnywhere) {
  const fs::path whole = folder_ / "whole.exr", part = folder_ / "part.exr";
  must(awdWriteImageEXR(image_, whole.c_str()));
  const std::string bytes = bytesOf(whole);
  ASSERT_GT(bytes.size(), 1000u);
  Image image;
  must(awdReadImage(device_, whole.c_str(), image.out()));
  for (size_t i = 0; i < 64; ++i) {
    const size_t length = i < 16 ? 32 * i : bytes.size() * (i - 16) / 48;
    SCOPED_TRACE(length);
    writeBytes(part, bytes.substr(0, length));
    expectUnreadable(part);
  }
  writeBytes(part, bytes.substr(0, bytes.size() - 1));
  expectUnreadable(part);
}

/// Damage is found or, where it only changes texts or pixels, harmless; never a crash.
TEST_F(BadFile, DamagedAnywhere) {
  const fs::path whole = folder_ / "whole.exr", bad = folder_ / "bad.exr";
  must(awdWriteImageEXR(image_, whole.c_str()));
  const std::string bytes = bytesOf(whole);
  Random random(2);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = bytes;
    for (int flips = 0; flips < 3; ++flips) {
      const size_t range = i % 2 ? damaged.size() : 1000;  // the header, more often
      damaged[random.bits() % range] = static_cast<char>(random.bits());
    }
    writeBytes(bad, damaged);
    Image image;
    const AWDResult result = awdReadImage(device_, bad.c_str(), image.out());
    if (result == AWD_SUCCESS || result == AWD_ERROR_OUT_OF_MEMORY) continue;
    // A size in the header may have become one that no film of ours has.
    if (result != AWD_ERROR_UNSUPPORTED) expectFailure(result, AWD_ERROR_IO, {bad.string()});
  }
}

TEST_F(BadFile, ThingsThatAreNoImage) {
  expectUnreadable(folder_ / "missing.exr");
  expectUnreadable(folder_);
  const fs::path text = folder_ / "text.exr";
  writeBytes(text, "");
  expectUnreadable(text);
  writeBytes(text, "P6 2 2 255 no OpenEXR at all, but a good deal of text instead");
  expectUnreadable(text);
}

TEST_F(BadFile, SizesAndNamesOutOfRange) {
  AWDImage image;
  for (const uint32_t bad : {0u, 65537u, 0xFFFFFFFFu}) {
    expectFailure(awdNewImage(device_, bad, 1, &image), AWD_ERROR_INVALID_ARGUMENT, {"width"});
    expectFailure(awdNewImage(device_, 1, bad, &image), AWD_ERROR_INVALID_ARGUMENT, {"height"});
  }
  std::vector<float> pixels(size_t{kWidth} * kHeight);
  const std::string longName(64, 'a');
  for (const char* name : {"", "tab\there", "\x7f", longName.c_str()}) {
    expectFailure(awdSetImageChannel(image_, name, pixels.data(), 0, 0), AWD_ERROR_INVALID_ARGUMENT,
                  {"name"});
    expectFailure(awdSetImageMetadata(image_, name, "x"), AWD_ERROR_INVALID_ARGUMENT, {"key"});
  }
  expectFailure(awdGetImageChannel(image_, "Z", pixels.data(), 0, 0), AWD_ERROR_INVALID_ARGUMENT,
                {"Z", "extra.Y", "R", "G", "B"});
  const char* name;
  expectFailure(awdGetImageChannelName(image_, 4, &name), AWD_ERROR_INVALID_ARGUMENT, {"index"});
  expectFailure(awdSetImageChannel(image_, "R", pixels.data(), 3, 0), AWD_ERROR_INVALID_ARGUMENT,
                {"pixelStride"});
  expectFailure(awdSetImageChannel(image_, "R", pixels.data(), 0, 3), AWD_ERROR_INVALID_ARGUMENT,
                {"rowStride"});
  expectFailure(awdGetImageChannel(image_, "R", pixels.data(), ~size_t{0} / 8, 0),
                AWD_ERROR_INVALID_ARGUMENT, {"pixelStride"});
}

}  // namespace
