// SPDX-License-Identifier: Apache-2.0
// An image in memory: float channels of one size, sorted by name, and lines of text about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory_resource>
#include <string>
#include <string_view>
#include <vector>

#include "util/context.h"
#include "util/ref.h"

namespace awd {

/// Pixels, at most, along each axis.
constexpr uint32_t kLongestImageAxis = 65536;

class Image final : public RefCounted {
 public:
  /// Row by row from the top, without gaps.
  using Pixels = std::pmr::vector<float>;
  using Channels = std::pmr::map<std::pmr::string, Pixels, std::less<>>;
  using Metadata = std::pmr::map<std::pmr::string, std::pmr::string, std::less<>>;

  /// Without channels. AWD_ERROR_INVALID_ARGUMENT unless 1 <= width, height <= 65536.
  static Ref<Image> make(Context& context, uint32_t width, uint32_t height);

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  std::size_t pixelCount() const { return std::size_t{width_} * height_; }
  Context& context() const { return *context_; }
  const Channels& channels() const { return channels_; }
  const Metadata& metadata() const { return metadata_; }

  /// The channel of that name, or null.
  const Pixels* channel(std::string_view name) const;
  /// Adds or replaces a channel of zeros; the caller fills it in.
  Pixels& addChannel(std::string_view name);
  /// Adds or replaces a channel. Pixel (i, j) lies j * rowStride + i * pixelStride bytes after
  /// `pixels`; a stride of 0 means packed. The name must be 1 to 63 printable characters.
  void setChannel(std::string_view name, const float* pixels, std::size_t pixelStride = 0,
                  std::size_t rowStride = 0);
  /// Copies a channel out in the same layout. AWD_ERROR_INVALID_ARGUMENT with the names of all
  /// channels if there is none of that name.
  void getChannel(std::string_view name, float* pixels, std::size_t pixelStride = 0,
                  std::size_t rowStride = 0) const;

  /// Adds or replaces a line of metadata. The key must be 1 to 63 printable characters and not be
  /// a word of the file format.
  void setMetadata(std::string_view key, std::string_view value);
  /// The same for keys that a file brings along, whatever they are.
  void addMetadata(std::string_view key, std::string_view value);
  void removeMetadata(std::string_view key);
  /// Null if there is none of that key.
  const char* metadataValue(std::string_view key) const;

 private:
  template <class T, class... Arguments>
  friend T* awd::make(std::pmr::memory_resource* memory, Arguments&&... arguments);
  template <class T>
  friend void awd::unmake(std::pmr::memory_resource* memory, T* object) noexcept;

  Image(Context& context, uint32_t width, uint32_t height);
  ~Image() override = default;
  void destroy() noexcept override;

  struct Layout {
    std::size_t pixelStride, rowStride;
  };
  Layout layout(std::size_t pixelStride, std::size_t rowStride) const;

  Ref<Context> context_;
  uint32_t width_, height_;
  Channels channels_;
  Metadata metadata_;
};

}  // namespace awd
