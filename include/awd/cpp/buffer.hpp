// SPDX-License-Identifier: Apache-2.0
//
// Views with strides: of what is part of the host's own structs, and of pixels.
#ifndef AWD_CPP_BUFFER_HPP
#define AWD_CPP_BUFFER_HPP

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <type_traits>

#include "awd/cpp/error.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {
namespace detail {

/// `count` items of `width` numbers of type T, one in each of the host's elements.
template <class T, std::size_t width, class Container>
AWDBuffer bufferOf(const Container& container, AWDFormat format) noexcept {
  using Element = std::remove_reference_t<decltype(*std::data(container))>;
  static_assert(std::is_trivially_copyable_v<Element>, "elements are read as plain memory");
  static_assert(sizeof(Element) >= width * sizeof(T) && sizeof(Element) % sizeof(T) == 0,
                "an element begins with the numbers wanted");
  return {std::data(container), 0u, sizeof(Element), std::size(container), format, 0u};
}

/// The same, in a member of each element.
template <class T, std::size_t width, class Container, class Element, class Member>
AWDBuffer bufferOf(const Container& container, Member Element::*member, AWDFormat format) noexcept {
  static_assert(std::is_trivially_copyable_v<Element>, "elements are read as plain memory");
  static_assert(sizeof(Member) >= width * sizeof(T), "the member begins with the numbers wanted");
  const Element* first = std::data(container);
  const std::size_t count = std::size(container);
  return {count ? &(first->*member) : nullptr, 0u, sizeof(Element), count, format, 0u};
}

}  // namespace detail

/// Three floats, three uint32_t, or one uint32_t from each element of a contiguous container, such
/// as std::vector<Vertex>: its first bytes, or a member of it, as in
///   mesh.vertices = awd::float3Buffer(vertices, &Vertex::position);
/// Nothing is copied here. Numbers without structure: awd::float3Buffer(numbers.data(), count).
template <class Container>
AWDBuffer float3Buffer(const Container& container) noexcept {
  return detail::bufferOf<float, 3>(container, AWD_FORMAT_FLOAT3);
}
template <class Container, class Element, class Member>
AWDBuffer float3Buffer(const Container& container, Member Element::*member) noexcept {
  return detail::bufferOf<float, 3>(container, member, AWD_FORMAT_FLOAT3);
}
template <class Container>
AWDBuffer uint3Buffer(const Container& container) noexcept {
  return detail::bufferOf<std::uint32_t, 3>(container, AWD_FORMAT_UINT3);
}
template <class Container, class Element, class Member>
AWDBuffer uint3Buffer(const Container& container, Member Element::*member) noexcept {
  return detail::bufferOf<std::uint32_t, 3>(container, member, AWD_FORMAT_UINT3);
}
template <class Container>
AWDBuffer uintBuffer(const Container& container) noexcept {
  return detail::bufferOf<std::uint32_t, 1>(container, AWD_FORMAT_UINT);
}
template <class Container, class Element, class Member>
AWDBuffer uintBuffer(const Container& container, Member Element::*member) noexcept {
  return detail::bufferOf<std::uint32_t, 1>(container, member, AWD_FORMAT_UINT);
}
/// `count` items that are byteStride bytes apart; 0: packed.
inline AWDBuffer float3Buffer(const float* data, std::size_t count,
                              std::size_t byteStride = 0) noexcept {
  return {data, 0u, byteStride, count, AWD_FORMAT_FLOAT3, 0u};
}
inline AWDBuffer uint3Buffer(const std::uint32_t* data, std::size_t count,
                             std::size_t byteStride = 0) noexcept {
  return {data, 0u, byteStride, count, AWD_FORMAT_UINT3, 0u};
}
inline AWDBuffer uintBuffer(const std::uint32_t* data, std::size_t count,
                            std::size_t byteStride = 0) noexcept {
  return {data, 0u, byteStride, count, AWD_FORMAT_UINT, 0u};
}

/// Pixels of the host's, of `channels` floats each; row 0 is on top. Strides are in bytes; 0:
/// packed.
template <class T, std::size_t channels>
struct Pixels {
  T* data;
  std::uint32_t width, height;
  std::size_t pixelStride, rowStride;

  Pixels(T* pixels, std::uint32_t w, std::uint32_t h, std::size_t bytesPerPixel = 0,
         std::size_t bytesPerRow = 0) noexcept
      : data(pixels),
        width(w),
        height(h),
        pixelStride(bytesPerPixel ? bytesPerPixel : channels * sizeof(T)),
        rowStride(bytesPerRow ? bytesPerRow : w * pixelStride) {}

  bool is(std::uint32_t w, std::uint32_t h) const noexcept { return width == w && height == h; }
};
using ColourPixels = Pixels<float, 3>;
using ChannelPixels = Pixels<float, 1>;
using ConstChannelPixels = Pixels<const float, 1>;

namespace detail {

template <class T, std::size_t channels>
Returns<void> wrongPixels(const Pixels<T, channels>& pixels, std::uint32_t width,
                          std::uint32_t height) {
  return failure<void>(Error(AWD_ERROR_INVALID_ARGUMENT,
                             "pixels has " + std::to_string(pixels.width) + " x " +
                                 std::to_string(pixels.height) + " of them: give " +
                                 std::to_string(width) + " x " + std::to_string(height)));
}

}  // namespace detail
}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
