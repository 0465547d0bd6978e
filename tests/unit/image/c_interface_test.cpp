// SPDX-License-Identifier: Apache-2.0
// awd/image.h through its C functions: arguments, errors and results.
#include <gtest/gtest.h>

#include <cmath>

#include "awd/awd.h"
#include "support.h"

namespace {

using awd::test::awkward;
using awd::test::Counter;

class ImageInterface : public testing::Test {
 protected:
  ImageInterface() {
    AWDDeviceDesc desc = counter_.desc();
    desc.alloc = [](void* user, size_t size, size_t alignment) -> void* {
      auto& self = *static_cast<ImageInterface*>(user);
      if (self.allocationsLeft_ == 0) return nullptr;
      if (self.allocationsLeft_ > 0) --self.allocationsLeft_;
      return self.counter_.desc().alloc(&self.counter_, size, alignment);
    };
    desc.free = [](void* user, void* place, size_t size, size_t alignment) {
      auto& self = *static_cast<ImageInterface*>(user);
      self.counter_.desc().free(&self.counter_, place, size, alignment);
    };
    desc.allocUser = this;
    EXPECT_EQ(awdNewDevice(&desc, &device_), AWD_SUCCESS);
    EXPECT_EQ(awdNewImage(device_, 4, 3, &image_), AWD_SUCCESS);
    EXPECT_EQ(awdSetImageChannel(image_, "R", awkward(12).data(), 0, 0), AWD_SUCCESS);
    EXPECT_EQ(awdSetImageChannel(image_, "variance.R", awkward(12, 2).data(), 0, 0), AWD_SUCCESS);
    EXPECT_EQ(awdSetImageMetadata(image_, "awd.seed", "7"), AWD_SUCCESS);
  }
  ~ImageInterface() override {
    awdReleaseDevice(device_);  // the image keeps what it needs
    awdReleaseImage(image_);
    std::remove(path_.c_str());
    EXPECT_EQ(counter_.now, 0u);
  }

  /// The call failed with this code and a message that contains these texts.
  static void expect(AWDResult code, AWDResult result, const char* function, const char* text) {
    EXPECT_EQ(result, code);
    EXPECT_CONTAINS(awdGetLastErrorMessage(), function);
    EXPECT_CONTAINS(awdGetLastErrorMessage(), text);
  }
  static void expectInvalid(AWDResult result, const char* function, const char* text) {
    expect(AWD_ERROR_INVALID_ARGUMENT, result, function, text);
  }

  Counter counter_;
  long allocationsLeft_ = -1;  // -1: no end of them
  AWDDevice device_ = nullptr;
  AWDImage image_ = nullptr;
  std::string path_ = testing::TempDir() + "awd-image-" + std::to_string(getpid());
};

TEST_F(ImageInterface, NullsAreErrors) {
  AWDImage image = image_;
  const char* text = "kept";
  float pixels[12] = {};
  expectInvalid(awdNewImage(nullptr, 1, 1, &image), "awdNewImage", "device is NULL");
  EXPECT_EQ(image, nullptr);
  expectInvalid(awdNewImage(device_, 1, 1, nullptr), "awdNewImage", "image is NULL");
  image = image_;
  expectInvalid(awdReadImage(nullptr, "x", &image), "awdReadImage", "device is NULL");
  EXPECT_EQ(image, nullptr);
  expectInvalid(awdReadImage(device_, nullptr, &image), "awdReadImage", "path is NULL");
  expectInvalid(awdReadImage(device_, "x", nullptr), "awdReadImage", "image is NULL");
  expectInvalid(awdGetImageInfo(nullptr, nullptr, nullptr, nullptr), "awdGetImageInfo",
                "image is NULL");
  expectInvalid(awdGetImageChannelName(nullptr, 0, &text), "awdGetImageChannelName",
                "image is NULL");
  EXPECT_EQ(text, nullptr);
  expectInvalid(awdGetImageChannelName(image_, 0, nullptr), "awdGetImageChannelName",
                "name is NULL");
  expectInvalid(awdSetImageChannel(nullptr, "R", pixels, 0, 0), "awdSetImageChannel",
                "image is NULL");
  expectInvalid(awdSetImageChannel(image_, nullptr, pixels, 0, 0), "awdSetImageChannel",
                "name is NULL");
  expectInvalid(awdSetImageChannel(image_, "R", nullptr, 0, 0), "awdSetImageChannel",
                "pixels is NULL");
  expectInvalid(awdGetImageChannel(nullptr, "R", pixels, 0, 0), "awdGetImageChannel",
                "image is NULL");
  expectInvalid(awdGetImageChannel(image_, nullptr, pixels, 0, 0), "awdGetImageChannel",
                "name is NULL");
  expectInvalid(awdGetImageChannel(image_, "R", nullptr, 0, 0), "awdGetImageChannel",
                "pixels is NULL");
  expectInvalid(awdSetImageMetadata(nullptr, "k", "v"), "awdSetImageMetadata", "image is NULL");
  expectInvalid(awdSetImageMetadata(image_, nullptr, "v"), "awdSetImageMetadata", "key is NULL");
  expectInvalid(awdSetImageMetadata(image_, nullptr, nullptr), "awdSetImageMetadata",
                "key is NULL");
  expectInvalid(awdGetImageMetadata(nullptr, "k", &text), "awdGetImageMetadata", "image is NULL");
  expectInvalid(awdGetImageMetadata(image_, nullptr, &text), "awdGetImageMetadata", "key is NULL");
  expectInvalid(awdGetImageMetadata(image_, "k", nullptr), "awdGetImageMetadata", "value is NULL");
  expectInvalid(awdWriteImageEXR(nullptr, "x"), "awdWriteImageEXR", "image is NULL");
  expectInvalid(awdWriteImageEXR(image_, nullptr), "awdWriteImageEXR", "path is NULL");
  expectInvalid(awdWriteImagePNG(nullptr, "x", nullptr), "awdWriteImagePNG", "image is NULL");
  expectInvalid(awdWriteImagePNG(image_, nullptr, nullptr), "awdWriteImagePNG", "path is NULL");
  awdRetainImage(nullptr);
  awdReleaseImage(nullptr);
}

TEST_F(ImageInterface, WrongArguments) {
  AWDImage image = image_;
  expectInvalid(awdNewImage(device_, 0, 1, &image), "awdNewImage", "0 x 1");
  EXPECT_EQ(image, nullptr);
  const char* name = "kept";
  expectInvalid(awdGetImageChannelName(image_, 2, &name), "awdGetImageChannelName", "index is 2");
  EXPECT_EQ(name, nullptr);
  float pixels[12] = {};
  expectInvalid(awdGetImageChannel(image_, "G", pixels, 0, 0), "awdGetImageChannel",
                "R variance.R");
  expectInvalid(awdSetImageChannel(image_, "R", pixels, 1, 0), "awdSetImageChannel", "pixelStride");
  expectInvalid(awdSetImageMetadata(image_, "tiles", "v"), "awdSetImageMetadata", "tiles");
  AWDPNGDesc desc = AWD_PNG_DESC_INIT;
  desc.reserved = 1;
  expectInvalid(awdWriteImagePNG(image_, path_.c_str(), &desc), "awdWriteImagePNG", "reserved");
  desc = AWD_PNG_DESC_INIT;
  desc.exposure = NAN;
  expectInvalid(awdWriteImagePNG(image_, path_.c_str(), &desc), "awdWriteImagePNG", "exposure");
  desc = AWD_PNG_DESC_INIT;
  desc.structSize = 0;
  expectInvalid(awdWriteImagePNG(image_, path_.c_str(), &desc), "awdWriteImagePNG",
                "AWD_PNG_DESC_INIT");
}

TEST_F(ImageInterface, TellsWhatIsInAnImage) {
  uint32_t width = 0, height = 0, count = 0;
  ASSERT_EQ(awdGetImageInfo(image_, &width, &height, &count), AWD_SUCCESS);
  EXPECT_EQ(width, 4u);
  EXPECT_EQ(height, 3u);
  EXPECT_EQ(count, 2u);
  EXPECT_EQ(awdGetImageInfo(image_, nullptr, nullptr, nullptr), AWD_SUCCESS);
  const char* text = nullptr;
  ASSERT_EQ(awdGetImageChannelName(image_, 1, &text), AWD_SUCCESS);
  EXPECT_STREQ(text, "variance.R");
  ASSERT_EQ(awdGetImageMetadata(image_, "awd.seed", &text), AWD_SUCCESS);
  EXPECT_STREQ(text, "7");
  ASSERT_EQ(awdSetImageMetadata(image_, "awd.seed", nullptr), AWD_SUCCESS);
  ASSERT_EQ(awdGetImageMetadata(image_, "awd.seed", &text), AWD_SUCCESS);
  EXPECT_EQ(text, nullptr);
}

TEST_F(ImageInterface, WritesAndReads) {
  ASSERT_EQ(awdWriteImageEXR(image_, path_.c_str()), AWD_SUCCESS);
  AWDImage back = nullptr;
  ASSERT_EQ(awdReadImage(device_, path_.c_str(), &back), AWD_SUCCESS);
  std::vector<float> pixels(12);
  ASSERT_EQ(awdGetImageChannel(back, "variance.R", pixels.data(), 0, 0), AWD_SUCCESS);
  EXPECT_EQ(std::memcmp(pixels.data(), awkward(12, 2).data(), 48), 0);
  awdRetainImage(back);
  awdReleaseImage(back);
  const char* text = nullptr;
  ASSERT_EQ(awdGetImageMetadata(back, "awd.seed", &text), AWD_SUCCESS);
  EXPECT_STREQ(text, "7");
  awdReleaseImage(back);
  ASSERT_EQ(awdWriteImagePNG(image_, path_.c_str(), nullptr), AWD_SUCCESS);
  expect(AWD_ERROR_IO, awdReadImage(device_, path_.c_str(), &back), "awdReadImage",
         "not an OpenEXR file");
  EXPECT_EQ(back, nullptr);
}

TEST_F(ImageInterface, RunsOutOfMemoryAnywhere) {
  ASSERT_EQ(awdWriteImageEXR(image_, path_.c_str()), AWD_SUCCESS);
  const std::size_t before = counter_.now;
  long failures = 0;
  for (bool done = false; !done; ++failures) {
    allocationsLeft_ = failures;
    AWDImage back = nullptr;
    AWDResult result = awdReadImage(device_, path_.c_str(), &back);
    if (result == AWD_SUCCESS) result = awdSetImageChannel(back, "G", awkward(12).data(), 0, 0);
    if (result == AWD_SUCCESS) result = awdSetImageMetadata(back, "key that is long", "value");
    if (result == AWD_SUCCESS) result = awdWriteImagePNG(back, path_.c_str(), nullptr);
    done = result == AWD_SUCCESS;
    if (!done) expect(AWD_ERROR_OUT_OF_MEMORY, result, "awd", "out of memory");
    awdReleaseImage(back);
    EXPECT_EQ(counter_.now, before);
  }
  allocationsLeft_ = -1;
  EXPECT_GT(failures, 10);
}

}  // namespace
