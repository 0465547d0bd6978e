// SPDX-License-Identifier: Apache-2.0
// How the functions of awd/image.h are called.
#include "misuse/functions.h"

namespace awdmisuse {

namespace {

constexpr uint32_t kPixels = 4;  // pixels along an axis

const std::vector<std::string>& wildNames() {
  static const std::vector<std::string> kNames = {"",
                                                  "R",
                                                  "key",
                                                  "part.Y",
                                                  std::string(63, 'n'),
                                                  std::string(64, 'n'),
                                                  "line\nbreak",
                                                  "%s%n",
                                                  "\x7f",
                                                  "\xc3\xa4"};
  return kNames;
}

}  // namespace

void addImageFunctions(std::vector<Function>& all) {
  const auto add = [&](const char* name, std::function<void(Caller&)> call) {
    all.push_back({name, std::move(call), true});
  };
  const std::vector<uint32_t> sizes = {0, 1, 3, 65537, UINT32_MAX};
  add("awdNewImage", [=](Caller& c) {
    c(awdNewImage, Args{c.device(), c.number<uint32_t>(kPixels, sizes),
                        c.number<uint32_t>(kPixels, sizes), c.made<AWDImage>()});
  });
  add("awdNewFilmImage", [](Caller& c) {
    c(awdNewFilmImage, Args{c.render(), c.made<AWDImage>()});
  });
  add("awdNewPatchImage", [](Caller& c) {
    c(awdNewPatchImage,
      Args{c.field(), c.patch(), c.number<uint32_t>(kPixels, {0, 1, 3, 16385, UINT32_MAX}),
           c.made<AWDImage>()});
  });
  add("awdReadImage", [](Caller& c) {
    c(awdReadImage, Args{c.device(), c.path(c.world().imageFile), c.made<AWDImage>()});
  });
  add("awdRetainImage", [](Caller& c) { c.retained(awdRetainImage); });
  add("awdReleaseImage", [](Caller& c) { c.released(awdReleaseImage); });
  add("awdGetImageInfo", [](Caller& c) {
    c(awdGetImageInfo, Args{c.image(), c.out<uint32_t>(1, true), c.out<uint32_t>(1, true),
                            c.out<uint32_t>(1, true)});
  });
  add("awdGetImageChannelName", [](Caller& c) {
    c(awdGetImageChannelName, Args{c.image(), c.number<uint32_t>(0), c.out<const char*>(1)});
  });
  add("awdSetImageChannel", [](Caller& c) {
    const AWDImage image = c.image();
    const char* name = c.text("B", wildNames());
    const float* pixels = c.in<float>(kPixels * 100, [&] { return c.coordinate(); });
    c(awdSetImageChannel, Args{image, name, pixels, c.number<size_t>(8, {0, 1, 4, 5, SIZE_MAX}),
                               c.number<size_t>(40, {0, 1, 16, 33, SIZE_MAX})});
  });
  add("awdGetImageChannel", [](Caller& c) {
    c(awdGetImageChannel, Args{c.image(), c.text("G", wildNames()), c.out<float>(kPixels * 100),
                               c.number<size_t>(8, {0, 1, 4, 5, SIZE_MAX}),
                               c.number<size_t>(40, {0, 1, 16, 33, SIZE_MAX})});
  });
  add("awdSetImageMetadata", [](Caller& c) {
    c(awdSetImageMetadata,
      Args{c.image(), c.text("key", wildNames()), c.text("value", wildNames(), true)});
  });
  add("awdGetImageMetadata", [](Caller& c) {
    c(awdGetImageMetadata, Args{c.image(), c.text("key", wildNames()), c.out<const char*>(1)});
  });
  add("awdWriteImageEXR", [](Caller& c) { c(awdWriteImageEXR, Args{c.image(), c.outPath()}); });
  add("awdWriteImagePNG", [](Caller& c) {
    const AWDImage image = c.image();
    const char* path = c.outPath();
    const AWDPNGDesc* desc = c.desc<AWDPNGDesc>(
        AWD_PNG_DESC_INIT,
        [&](AWDPNGDesc& png) {
          c.spoil(png.exposure);
          c.spoil(png.reserved);
        },
        true);
    c(awdWriteImagePNG, Args{image, path, desc});
  });
}

}  // namespace awdmisuse
