// SPDX-License-Identifier: Apache-2.0
//
// awd/image.h in C++.
#ifndef AWD_CPP_IMAGE_HPP
#define AWD_CPP_IMAGE_HPP

#include <string>
#include <vector>

#include "awd/cpp/render.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

struct ImageInfo {
  std::uint32_t width, height, channelCount;
};

/// Named float channels and text metadata.
class Image : public Owner<Image, AWDImage, awdRetainImage, awdReleaseImage> {
 public:
  /// Without channels.
  static Returns<Image> create(const Device& device, std::uint32_t width, std::uint32_t height) {
    Image image;
    return detail::outcome(awdNewImage(device.get(), width, height, image.out()), image);
  }
  static Returns<Image> ofFilm(Render& render) {
    Image image;
    return detail::outcome(awdNewFilmImage(render.get(), image.out()), image);
  }
  /// The density of a patch, n x n pixels.
  static Returns<Image> ofPatch(const Field& field, std::uint32_t patch, std::uint32_t n) {
    Image image;
    return detail::outcome(awdNewPatchImage(field.get(), patch, n, image.out()), image);
  }
  /// Of an OpenEXR file.
  static Returns<Image> read(const Device& device, Text path) {
    Image image;
    return detail::outcome(awdReadImage(device.get(), path.get(), image.out()), image);
  }

  Returns<ImageInfo> info() const {
    ImageInfo info = {};
    return detail::outcome(awdGetImageInfo(get(), &info.width, &info.height, &info.channelCount),
                           info);
  }
  /// Sorted by name.
  Returns<std::string> channelName(std::uint32_t index) const {
    const char* text = nullptr;
    const AWDResult result = awdGetImageChannelName(get(), index, &text);
    std::string name = text ? text : "";
    return detail::outcome(result, name);
  }
  /// Adds or replaces a channel.
  Returns<void> setChannel(Text name, ConstChannelPixels pixels) {
    std::uint32_t width = 0, height = 0;
    AWDResult result = awdGetImageInfo(get(), &width, &height, nullptr);
    if (result == AWD_SUCCESS) {
      if (!pixels.is(width, height)) return detail::wrongPixels(pixels, width, height);
      result =
          awdSetImageChannel(get(), name.get(), pixels.data, pixels.pixelStride, pixels.rowStride);
    }
    return detail::outcome(result);
  }
  /// Writes a channel into the host's pixels.
  Returns<void> readChannel(Text name, ChannelPixels pixels) const {
    std::uint32_t width = 0, height = 0;
    AWDResult result = awdGetImageInfo(get(), &width, &height, nullptr);
    if (result == AWD_SUCCESS) {
      if (!pixels.is(width, height)) return detail::wrongPixels(pixels, width, height);
      result =
          awdGetImageChannel(get(), name.get(), pixels.data, pixels.pixelStride, pixels.rowStride);
    }
    return detail::outcome(result);
  }
  /// A channel, row by row.
  Returns<std::vector<float>> channel(Text name) const {
    std::uint32_t width = 0, height = 0;
    std::vector<float> pixels;
    AWDResult result = awdGetImageInfo(get(), &width, &height, nullptr);
    if (result == AWD_SUCCESS) {
      pixels.resize(std::size_t{width} * height);
      result = awdGetImageChannel(get(), name.get(), pixels.data(), 0, 0);
    }
    return detail::outcome(result, pixels);
  }
  Returns<void> setMetadata(Text key, Text value) {
    return detail::outcome(awdSetImageMetadata(get(), key.get(), value.get()));
  }
  Returns<void> removeMetadata(Text key) {
    return detail::outcome(awdSetImageMetadata(get(), key.get(), nullptr));
  }
  /// Null when there is none of that key; else lives until the image changes.
  Returns<const char*> metadata(Text key) const {
    const char* value = nullptr;
    return detail::outcome(awdGetImageMetadata(get(), key.get(), &value), value);
  }

  Returns<void> writeEXR(Text path) const {
    return detail::outcome(awdWriteImageEXR(get(), path.get()));
  }
  Returns<void> writePNG(Text path, const AWDPNGDesc& desc = PNGDesc()) const {
    return detail::outcome(awdWriteImagePNG(get(), path.get(), &desc));
  }
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
