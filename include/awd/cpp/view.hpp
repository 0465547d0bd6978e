// SPDX-License-Identifier: Apache-2.0
//
// Arguments that refer to what the host has: nothing is copied, and what they refer to must live
// until the call has ended.
#ifndef AWD_CPP_VIEW_HPP
#define AWD_CPP_VIEW_HPP

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#if __cplusplus >= 202002L
#include <span>
#endif

#include "awd/cpp/error.hpp"

namespace awd {
inline namespace AWD_CPP_MODE {

/// Elements in a row: of a std::vector, std::array, std::span, array of C, or any such container.
template <class T>
class View {
  template <class Container>
  using Element = std::remove_pointer_t<decltype(std::data(std::declval<Container&>()))>;
  /// Of T or, where T is const, of what it is made of; not of classes derived from it.
  template <class E>
  using IfFits = std::enable_if_t<std::is_convertible_v<E (*)[], T (*)[]>>;

 public:
  constexpr View() noexcept = default;
  constexpr View(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
  template <class Container, class = IfFits<Element<Container>>>
  constexpr View(Container&& container) noexcept
      : data_(std::data(container)), size_(std::size(container)) {}

  constexpr T* data() const noexcept { return data_; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T* begin() const noexcept { return data_; }
  constexpr T* end() const noexcept { return data_ + size_; }
  constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }
#if __cplusplus >= 202002L
  constexpr operator std::span<T>() const noexcept { return {data_, size_}; }
#endif

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};

/// N numbers, such as a direction: a std::array, an array of C, or a pointer that the host vouches
/// for, as in Float3(&v.x).
template <class T, std::size_t N>
class Fixed {
 public:
  constexpr Fixed(T (&numbers)[N]) noexcept : data_(numbers) {}
  constexpr Fixed(const std::array<std::remove_const_t<T>, N>& numbers) noexcept
      : data_(numbers.data()) {}
  template <class Pointer, class = std::enable_if_t<std::is_same_v<
                               std::add_const_t<std::remove_pointer_t<Pointer>>*, const T*>>>
  constexpr explicit Fixed(Pointer numbers) noexcept : data_(numbers) {}

  constexpr T* data() const noexcept { return data_; }

 private:
  T* data_;
};
using Float3 = Fixed<const float, 3>;
using Double3 = Fixed<const double, 3>;

/// Bytes of anything: of a container of char, unsigned char or std::byte.
class Bytes {
 public:
  Bytes(const void* data, std::size_t size) noexcept : data_(data), size_(size) {}
  template <class Container,
            class = std::enable_if_t<sizeof(*std::data(std::declval<const Container&>())) == 1>>
  Bytes(const Container& container) noexcept
      : data_(std::data(container)), size_(std::size(container)) {}

  const void* data() const noexcept { return data_; }
  std::size_t size() const noexcept { return size_; }

 private:
  const void* data_;
  std::size_t size_;
};

/// A text that ends in a 0: a literal, a std::string, or a std::filesystem::path.
class Text {
 public:
  Text(const char* text) noexcept : text_(text) {}
  template <class String, class = std::enable_if_t<std::is_convertible_v<
                              decltype(std::declval<const String&>().c_str()), const char*>>>
  Text(const String& text) noexcept : text_(text.c_str()) {}

  const char* get() const noexcept { return text_; }

 private:
  const char* text_;
};

}  // namespace AWD_CPP_MODE
}  // namespace awd

#endif
