// SPDX-License-Identifier: Apache-2.0
#include "image/exr_write.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>

#include "image/exr_read.h"
#include "support.h"

namespace awd {
namespace {

using test::awkward;
using test::errorOf;
using test::FullDisk;
using test::readBytes;
using test::sameBits;

using ExrWrite = test::ImageTest;

TEST_F(ExrWrite, RoundTripsEveryBit) {
  for (const auto& [width, height] :
       {std::pair{1u, 1u}, {7u, 5u}, {1u, 100u}, {65536u, 1u}, {1u, 65536u}, {123u, 45u}}) {
    const Ref<Image> image = Image::make(context(), width, height);
    const char* const names[] = {"R", "G", "B", "variance.R", "a.b.c.d e", "samples.Y"};
    uint32_t seed = 0;
    for (const char* name : names) {
      image->setChannel(name, awkward(image->pixelCount(), seed++).data());
    }
    image->setChannel(std::string(63, 'n'), awkward(image->pixelCount(), seed).data());
    writeExr(*image, path().c_str());

    const Ref<Image> back = readExr(context(), path().c_str());
    EXPECT_EQ(back->width(), width);
    EXPECT_EQ(back->height(), height);
    ASSERT_EQ(back->channels().size(), 7u);
    seed = 0;
    for (const char* name : names) {
      EXPECT_TRUE(sameBits(back->channel(name), awkward(image->pixelCount(), seed++))) << name;
    }
    EXPECT_TRUE(sameBits(back->channel(std::string(63, 'n')), awkward(image->pixelCount(), seed)));
  }
}

TEST_F(ExrWrite, WritesOnePartOfZippedFloatScanlines) {
  const Ref<Image> image = Image::make(context(), 20, 30);
  image->setChannel("Y", awkward(600).data());
  image->setChannel("variance.Y", awkward(600).data());
  image->setMetadata("awd.seed", "42");
  writeExr(*image, path().c_str());

  const Imf::MultiPartInputFile file(path().c_str());
  ASSERT_EQ(file.parts(), 1);
  const Imf::Header& header = file.header(0);
  EXPECT_EQ(file.version(), 2);  // neither tiles nor parts nor long names
  EXPECT_EQ(header.compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(header.lineOrder(), Imf::INCREASING_Y);
  EXPECT_EQ(header.dataWindow(), Imath::Box2i({0, 0}, {19, 29}));
  EXPECT_EQ(header.displayWindow(), header.dataWindow());
  ASSERT_NE(header.channels().findChannel("variance.Y"), nullptr);
  EXPECT_EQ(header.channels().findChannel("variance.Y")->type, Imf::FLOAT);
  EXPECT_EQ(header.typedAttribute<Imf::StringAttribute>("awd.seed").value(), "42");
}

TEST_F(ExrWrite, RoundTripsMetadata) {
  const Ref<Image> image = Image::make(context(), 1, 1);
  const float pixel = 1;
  image->setChannel("Y", &pixel);
  const std::string longText(100000, 'x'), text = "two\nlines and \xC3\xA4";
  image->setMetadata("awd.command", text);
  image->setMetadata("comments", longText);
  image->setMetadata("empty", "");
  image->setMetadata(std::string(63, 'k'), "v");
  writeExr(*image, path().c_str());
  const Ref<Image> back = readExr(context(), path().c_str());
  EXPECT_EQ(back->metadata(), image->metadata());
}

TEST_F(ExrWrite, RefusesAnImageWithoutChannels) {
  const Ref<Image> image = Image::make(context(), 1, 1);
  EXPECT_CONTAINS(errorOf(AWD_ERROR_INVALID_OPERATION, [&] { writeExr(*image, path().c_str()); }),
                  "no channel");
  EXPECT_EQ(fileCount(), 0u);
}

/// Of two names that begin alike OpenEXR would make one.
TEST_F(ExrWrite, RefusesNamesThatWouldBeCut) {
  const Ref<Image> image = Image::make(context(), 1, 1);
  const std::string longest(255, 'p');
  image->addChannel(longest);
  writeExr(*image, path().c_str());
  EXPECT_EQ(readExr(context(), path().c_str())->channels().size(), 1u);
  image->addChannel(longest + "R");
  EXPECT_CONTAINS(errorOf(AWD_ERROR_UNSUPPORTED, [&] { writeExr(*image, path().c_str()); }),
                  "256 characters");
}

class ExrWriteFailure : public ExrWrite {
 protected:
  ExrWriteFailure() {
    image_->setChannel("Y", awkward(4096).data());
    test::writeBytes(path(), "old");
  }
  void expectFailure(const std::string& to, const char* reason) {
    const std::string text = errorOf(AWD_ERROR_IO, [&] { writeExr(*image_, to.c_str()); });
    EXPECT_CONTAINS(text, to);
    EXPECT_CONTAINS(text, reason);
    EXPECT_EQ(readBytes(path()), "old");
    EXPECT_EQ(fileCount(), 1u);
  }

  Ref<Image> image_ = Image::make(context(), 64, 64);
};

TEST_F(ExrWriteFailure, PathsThatCantBeWritten) {
  expectFailure(path("no/folder.exr"), "No such file or directory");
  expectFailure(path("image.exr") + "/x.exr", "Not a directory");
  expectFailure(path(""), "it is not a file");
  expectFailure("/proc/awd.exr", "");
  expectFailure("", "");
}

TEST_F(ExrWriteFailure, AFullDiskAtAnyByte) {
  writeExr(*image_, path("whole.exr").c_str());
  const std::size_t size = readBytes(path("whole.exr")).size();
  std::filesystem::remove(path("whole.exr"));
  testing::internal::CaptureStderr();
  for (std::size_t room = 0; room < size; room += room < 600 ? 1 : 97) {
    const FullDisk disk(room);
    expectFailure(path(), "File too large");
  }
  {
    const FullDisk disk(size - 1);
    expectFailure(path(), "File too large");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  const FullDisk disk(size);
  writeExr(*image_, path().c_str());
  EXPECT_TRUE(sameBits(readExr(context(), path().c_str())->channel("Y"), awkward(4096)));
}

}  // namespace
}  // namespace awd
