// SPDX-License-Identifier: Apache-2.0
#include "image/image.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "image/exr_names.h"
#include "util/error.h"

namespace awd {

namespace {

constexpr std::size_t kLongestName = 63;

void checkName(std::string_view name, const char* argument) {
  const bool printable =
      std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (name.empty() || name.size() > kLongestName || !printable) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "%s has %zu characters%s: must be 1 to %zu printable ASCII characters", argument,
         name.size(), printable ? "" : ", some not printable", kLongestName);
  }
}

int lengthOf(std::string_view text) { return static_cast<int>(text.size()); }

}  // namespace

Image::Image(Context& context, uint32_t width, uint32_t height)
    : context_(Ref<Context>::share(&context)),
      width_(width),
      height_(height),
      channels_(context.memory()),
      metadata_(context.memory()) {}

Ref<Image> Image::make(Context& context, uint32_t width, uint32_t height) {
  if (width < 1 || width > kLongestImageAxis || height < 1 || height > kLongestImageAxis) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "width x height is %u x %u: each must be 1 to %u pixels",
         width, height, kLongestImageAxis);
  }
  return Ref<Image>::adopt(awd::make<Image>(context.memory(), context, width, height));
}

void Image::destroy() noexcept {
  const Ref<Context> context = context_;  // outlives the memory that it gave us
  unmake(context->memory(), this);
}

const Image::Pixels* Image::channel(std::string_view name) const {
  const auto found = channels_.find(name);
  return found == channels_.end() ? nullptr : &found->second;
}

Image::Pixels& Image::addChannel(std::string_view name) {
  Pixels zeros(pixelCount(), 0.0f, context_->memory());
  auto place = channels_.find(name);
  if (place == channels_.end()) {
    place = channels_.emplace(std::pmr::string(name, context_->memory()), Pixels()).first;
  }
  place->second.swap(zeros);
  return place->second;
}

Image::Layout Image::layout(std::size_t pixelStride, std::size_t rowStride) const {
  constexpr std::size_t limit = std::numeric_limits<std::ptrdiff_t>::max();
  if (pixelStride == 0) pixelStride = sizeof(float);
  if (rowStride == 0 && pixelStride <= limit / width_) rowStride = width_ * pixelStride;
  if (pixelStride < sizeof(float) || rowStride < sizeof(float)) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "pixelStride is %zu and rowStride %zu bytes: each must be 0 (packed) or at least %zu",
         pixelStride, rowStride, sizeof(float));
  }
  const std::size_t room = (limit - sizeof(float)) / 2;
  if ((width_ > 1 && pixelStride > room / (width_ - 1)) ||
      (height_ > 1 && rowStride > room / (height_ - 1))) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "pixelStride %zu and rowStride %zu reach beyond the address space: pass strides in bytes",
         pixelStride, rowStride);
  }
  return {pixelStride, rowStride};
}

void Image::setChannel(std::string_view name, const float* pixels, std::size_t pixelStride,
                       std::size_t rowStride) {
  checkName(name, "name");
  const Layout from = layout(pixelStride, rowStride);
  Pixels& to = addChannel(name);
  const char* row = reinterpret_cast<const char*>(pixels);
  float* next = to.data();
  for (uint32_t j = 0; j < height_; ++j) {
    for (uint32_t i = 0; i < width_; ++i) {
      // The host's pixels may lie at any address.
      std::memcpy(next++, row + j * from.rowStride + i * from.pixelStride, sizeof(float));
    }
  }
}

void Image::getChannel(std::string_view name, float* pixels, std::size_t pixelStride,
                       std::size_t rowStride) const {
  const Pixels* const found = channel(name);
  if (!found) {
    std::string names;
    for (const auto& entry : channels_) {
      names.append(names.empty() ? "" : " ").append(entry.first);
    }
    fail(AWD_ERROR_INVALID_ARGUMENT, "the image has no channel \"%.*s\": it has %s", lengthOf(name),
         name.data(), names.empty() ? "none" : names.c_str());
  }
  const Layout to = layout(pixelStride, rowStride);
  char* row = reinterpret_cast<char*>(pixels);
  const float* next = found->data();
  for (uint32_t j = 0; j < height_; ++j) {
    for (uint32_t i = 0; i < width_; ++i) {
      std::memcpy(row + j * to.rowStride + i * to.pixelStride, next++, sizeof(float));
    }
  }
}

void Image::setMetadata(std::string_view key, std::string_view value) {
  checkName(key, "key");
  if (isReservedAttribute(key)) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "key is \"%.*s\", which OpenEXR uses itself: choose another, such as \"host.%.*s\"",
         lengthOf(key), key.data(), lengthOf(key), key.data());
  }
  addMetadata(key, value);
}

void Image::addMetadata(std::string_view key, std::string_view value) {
  std::pmr::string text(value, context_->memory());
  auto place = metadata_.find(key);
  if (place == metadata_.end()) {
    place = metadata_.emplace(std::pmr::string(key, context_->memory()), "").first;
  }
  place->second.swap(text);
}

void Image::removeMetadata(std::string_view key) {
  const auto place = metadata_.find(key);
  if (place != metadata_.end()) metadata_.erase(place);
}

const char* Image::metadataValue(std::string_view key) const {
  const auto found = metadata_.find(key);
  return found == metadata_.end() ? nullptr : found->second.c_str();
}

}  // namespace awd
