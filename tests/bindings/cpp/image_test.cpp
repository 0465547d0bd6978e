// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

std::filesystem::path temporary(const char* name) {
  return std::filesystem::path(testing::TempDir()) / name;
}

TEST(Image, ChannelsGoThroughStrides) {
  awd::Image image = MUST(awd::Image::create(oneThread(), 2, 2));
  const float in[] = {1, 9, 2, 9, 9, 3, 9, 4, 9, 9};  // a gap after each pixel and row
  MUST(image.setChannel("Y", {in, 2, 2, 2 * sizeof(float), 5 * sizeof(float)}));
  EXPECT_EQ(MUST(image.channel("Y")), std::vector<float>({1, 2, 3, 4}));
  std::vector<float> out(6, -1.0f);
  MUST(image.readChannel(std::string("Y"), {out.data(), 2, 2, 0, 3 * sizeof(float)}));
  EXPECT_EQ(out, std::vector<float>({1, 2, -1, 3, 4, -1}));

  EXPECT_EQ(MUST(image.info()).channelCount, 1u);
  EXPECT_EQ(MUST(image.channelName(0)), "Y");
  expectError([&] { return image.channelName(1); }, AWD_ERROR_INVALID_ARGUMENT, "1");
  expectError([&] { return image.channel("Z"); }, AWD_ERROR_INVALID_ARGUMENT, "Y");
  expectError(
      [&] {
        return image.setChannel("Z", {in, 3, 2});
      },
      AWD_ERROR_INVALID_ARGUMENT, "3 x 2");
  expectError(
      [&] {
        return image.readChannel("Y", {out.data(), 2, 3});
      },
      AWD_ERROR_INVALID_ARGUMENT, "2 x 3");
}

TEST(Image, MetadataComesAndGoes) {
  awd::Image image = MUST(awd::Image::create(oneThread(), 1, 1));
  EXPECT_EQ(MUST(image.metadata("who")), nullptr);
  MUST(image.setMetadata("who", "we"));
  EXPECT_STREQ(MUST(image.metadata("who")), "we");
  MUST(image.removeMetadata("who"));
  EXPECT_EQ(MUST(image.metadata("who")), nullptr);
}

TEST(Image, FilesAreWrittenAndRead) {
  const awd::Device device = oneThread();
  const awd::Scene scene = makeRoom(device);
  const awd::Camera camera = roomCamera(4, 2);
  awd::Render render = MUST(awd::Render::create(scene, awd::RenderDesc(camera)));
  MUST(render.pass(1));
  const awd::Image film = MUST(awd::Image::ofFilm(render));
  const std::filesystem::path exr = temporary("bindings-cpp.exr");
  MUST(film.writeEXR(exr));
  const awd::Image read = MUST(awd::Image::read(device, exr));
  EXPECT_EQ(MUST(read.channel("G")), MUST(film.channel("G")));
  std::filesystem::remove(exr);
  expectError([&] { return awd::Image::read(device, exr); }, AWD_ERROR_IO, exr.string());

  const awd::Image patch = MUST(awd::Image::ofPatch(MUST(render.field()), 0, 8));
  EXPECT_EQ(MUST(patch.info()).width, 8u);
  awd::PNGDesc desc;
  desc.exposure = 1.0f;
  const std::filesystem::path png = temporary("bindings-cpp.png");
  MUST(patch.writePNG(png, desc));
  EXPECT_GT(std::filesystem::file_size(png), 50u);
  MUST(patch.writePNG(png));
  std::filesystem::remove(png);
}

}  // namespace
