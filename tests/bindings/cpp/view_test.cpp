// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#if __cplusplus >= 202002L
#include <span>
#endif

#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

/// Where a view points to, and how far.
template <class T>
std::pair<T*, size_t> of(awd::View<T> view) {
  return {view.data(), view.size()};
}

TEST(Views, OfAnyContiguousContainer) {
  std::vector<double> vector = {1, 2, 3};
  std::array<double, 2> array = {4, 5};
  double plain[] = {6, 7, 8, 9};
  EXPECT_EQ(of<double>(vector), std::make_pair(vector.data(), size_t{3}));
  EXPECT_EQ(of<double>(array), std::make_pair(array.data(), size_t{2}));
  EXPECT_EQ(of<double>(plain), std::make_pair(&plain[0], size_t{4}));
  const awd::View<double> view = {&plain[1], 2};
  EXPECT_EQ(of<const double>(view),
            std::make_pair(static_cast<const double*>(&plain[1]), size_t{2}));
  EXPECT_EQ(of<const double>(std::as_const(vector)).first, vector.data());
  EXPECT_TRUE(awd::View<double>().empty());
  double sum = 0;
  for (const double x : view) sum += x;
  EXPECT_EQ(sum, 15.0);
  view[0] = 70;
  EXPECT_EQ(plain[1], 70.0);
#if __cplusplus >= 202002L
  const std::span<double> span = view;
  EXPECT_EQ(span.data(), &plain[1]);
  EXPECT_EQ(of<double>(span).second, 2u);
#endif
}

TEST(Views, AreOfTheRightType) {
  using Doubles = awd::View<double>;
  using ConstDoubles = awd::View<const double>;
  static_assert(!std::is_convertible_v<const std::vector<double>&, Doubles>);
  static_assert(!std::is_convertible_v<ConstDoubles, Doubles>);
  static_assert(!std::is_convertible_v<std::vector<float>&, ConstDoubles>);
  static_assert(!std::is_convertible_v<std::vector<bool>&, awd::View<bool>>);
  static_assert(std::is_convertible_v<std::vector<double>, ConstDoubles>);
  static_assert(!std::is_convertible_v<std::array<float, 2>, awd::Float3>);
  static_assert(!std::is_convertible_v<float*, awd::Float3>);
  static_assert(!std::is_convertible_v<std::vector<int>&, awd::Bytes>);
  static_assert(!std::is_convertible_v<int, awd::Text>);
  struct Derived : AWDHit {
    int more;
  };
  static_assert(!std::is_convertible_v<std::vector<Derived>&, awd::View<AWDHit>>);
}

TEST(Views, OfNumbersBytesAndTexts) {
  const float plain[3] = {1, 2, 3};
  const std::array<float, 3> array = {1, 2, 3};
  EXPECT_EQ(awd::Float3(plain).data(), plain);
  EXPECT_EQ(awd::Float3(array).data(), array.data());
  EXPECT_EQ(awd::Float3(&plain[0]).data(), plain);

  const std::vector<char> chars(5);
  const awd::Bytes bytes = chars;
  EXPECT_EQ(bytes.data(), chars.data());
  EXPECT_EQ(bytes.size(), 5u);

  const std::string text = "a";
  const std::filesystem::path path = "b";
  EXPECT_EQ(awd::Text(text).get(), text.c_str());
  EXPECT_EQ(awd::Text(path).get(), path.c_str());
}

TEST(Buffers, TakeStridesFromTheElements) {
  const std::vector<Vertex> vertices = roomVertices();
  const AWDBuffer member = awd::float3Buffer(vertices, &Vertex::position);
  EXPECT_EQ(member.data, vertices[0].position);
  EXPECT_EQ(member.byteStride, sizeof(Vertex));
  EXPECT_EQ(member.count, vertices.size());
  EXPECT_EQ(member.format, AWD_FORMAT_FLOAT3);

  const std::array<uint32_t, 4> quads[2] = {};
  const AWDBuffer front = awd::uint3Buffer(quads);
  EXPECT_EQ(front.data, &quads[0]);
  EXPECT_EQ(front.byteStride, 16u);
  EXPECT_EQ(front.count, 2u);
  EXPECT_EQ(front.format, AWD_FORMAT_UINT3);

  const std::vector<Vertex> none;
  EXPECT_EQ(awd::float3Buffer(none, &Vertex::position).count, 0u);
  EXPECT_EQ(awd::float3Buffer(none, &Vertex::position).data, nullptr);

  const float numbers[6] = {};
  const AWDBuffer packed = awd::float3Buffer(numbers, 2);
  EXPECT_EQ(packed.byteStride, 0u);
  EXPECT_EQ(packed.count, 2u);
}

TEST(Pixels, AreSteppedThroughByTheirStrides) {
  float memory[64] = {};
  const awd::ColourPixels packed(memory, 4, 2);
  EXPECT_EQ(packed.pixelStride, 3 * sizeof(float));
  EXPECT_EQ(packed.rowStride, 12 * sizeof(float));
  const awd::ChannelPixels padded(memory, 4, 2, 3 * sizeof(float));
  EXPECT_EQ(padded.rowStride, 12 * sizeof(float));
}

}  // namespace
