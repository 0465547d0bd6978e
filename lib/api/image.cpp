// SPDX-License-Identifier: Apache-2.0
// awd/image.h, but for the images of films and patches, which film_image.cpp makes.
#include "awd/image.h"

#include <iterator>

#include "api/handles.h"
#include "basis/device.h"
#include "image/exr_read.h"
#include "image/exr_write.h"
#include "image/image.h"
#include "image/png_write.h"

using awd::clearOutput;
using awd::fail;
using awd::give;
using awd::guard;
using awd::Image;
using awd::need;
using awd::object;

extern "C" {

AWDResult AWD_CALL awdNewImage(AWDDevice device, uint32_t width, uint32_t height,
                               AWDImage* image) noexcept {
  return guard("awdNewImage", [&] {
    clearOutput(image, "image");
    give(image, Image::make(object(device, "device").context(), width, height));
  });
}

AWDResult AWD_CALL awdReadImage(AWDDevice device, const char* path, AWDImage* image) noexcept {
  return guard("awdReadImage", [&] {
    clearOutput(image, "image");
    give(image, awd::readExr(object(device, "device").context(), need(path, "path")));
  });
}

void AWD_CALL awdRetainImage(AWDImage image) noexcept {
  if (image) awd::behind(image)->retain();
}

void AWD_CALL awdReleaseImage(AWDImage image) noexcept {
  if (image) awd::behind(image)->release();
}

AWDResult AWD_CALL awdGetImageInfo(AWDImage image, uint32_t* width, uint32_t* height,
                                   uint32_t* channelCount) noexcept {
  return guard("awdGetImageInfo", [&] {
    const Image& from = object(image, "image");
    if (width) *width = from.width();
    if (height) *height = from.height();
    if (channelCount) *channelCount = static_cast<uint32_t>(from.channels().size());
  });
}

AWDResult AWD_CALL awdGetImageChannelName(AWDImage image, uint32_t index,
                                          const char** name) noexcept {
  return guard("awdGetImageChannelName", [&] {
    clearOutput(name, "name");
    const Image::Channels& channels = object(image, "image").channels();
    if (index >= channels.size()) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "index is %u: the image has %zu channels", index,
           channels.size());
    }
    *name = std::next(channels.begin(), index)->first.c_str();
  });
}

AWDResult AWD_CALL awdSetImageChannel(AWDImage image, const char* name, const float* pixels,
                                      size_t pixelStride, size_t rowStride) noexcept {
  return guard("awdSetImageChannel", [&] {
    object(image, "image")
        .setChannel(need(name, "name"), need(pixels, "pixels"), pixelStride, rowStride);
  });
}

AWDResult AWD_CALL awdGetImageChannel(AWDImage image, const char* name, float* pixels,
                                      size_t pixelStride, size_t rowStride) noexcept {
  return guard("awdGetImageChannel", [&] {
    object(image, "image")
        .getChannel(need(name, "name"), need(pixels, "pixels"), pixelStride, rowStride);
  });
}

AWDResult AWD_CALL awdSetImageMetadata(AWDImage image, const char* key,
                                       const char* value) noexcept {
  return guard("awdSetImageMetadata", [&] {
    Image& to = object(image, "image");
    if (value) {
      to.setMetadata(need(key, "key"), value);
    } else {
      to.removeMetadata(need(key, "key"));
    }
  });
}

AWDResult AWD_CALL awdGetImageMetadata(AWDImage image, const char* key,
                                       const char** value) noexcept {
  return guard("awdGetImageMetadata", [&] {
    clearOutput(value, "value");
    *value = object(image, "image").metadataValue(need(key, "key"));
  });
}

AWDResult AWD_CALL awdWriteImageEXR(AWDImage image, const char* path) noexcept {
  return guard("awdWriteImageEXR",
               [&] { awd::writeExr(object(image, "image"), need(path, "path")); });
}

AWDResult AWD_CALL awdWriteImagePNG(AWDImage image, const char* path,
                                    const AWDPNGDesc* desc) noexcept {
  return guard("awdWriteImagePNG", [&] {
    const Image& from = object(image, "image");
    AWDPNGDesc known = AWD_PNG_DESC_INIT;
    if (desc) known = awd::readStruct(desc, "desc", "AWD_PNG_DESC_INIT");
    if (known.reserved != 0) {
      fail(AWD_ERROR_INVALID_ARGUMENT, "desc->reserved is %u: must be 0", known.reserved);
    }
    awd::writePng(from, need(path, "path"), known.exposure);
  });
}

}  // extern "C"
