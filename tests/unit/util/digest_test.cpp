// SPDX-License-Identifier: Apache-2.0
#include "util/digest.h"

#include <gtest/gtest.h>

#include <set>

namespace awd {
namespace {

template <class... Items>
uint64_t digestOf(Items... items) {
  Digest digest;
  (digest.add(items), ...);
  return digest.value();
}

TEST(Digest, IsTheSameOfTheSame) {
  EXPECT_EQ(digestOf(1.5f, uint64_t{3}), digestOf(1.5f, uint64_t{3}));
  EXPECT_EQ(digestOf(std::string_view("abc")), digestOf(std::string_view("abc")));
}

TEST(Digest, TellsEveryBitAndTheOrder) {
  std::set<uint64_t> seen = {digestOf(), digestOf(uint64_t{0}), digestOf(uint64_t{0}, uint64_t{0})};
  size_t kinds = 3;
  for (int bit = 0; bit < 64; ++bit) {
    seen.insert(digestOf(uint64_t{1} << bit, uint64_t{0}));
    seen.insert(digestOf(uint64_t{0}, uint64_t{1} << bit));
    kinds += 2;
  }
  EXPECT_EQ(seen.size(), kinds);
  EXPECT_NE(digestOf(std::string_view("ab"), std::string_view("c")),
            digestOf(std::string_view("a"), std::string_view("bc")));
  EXPECT_NE(digestOf(Vec3f{1, 2, 3}), digestOf(Vec3f{1, 3, 2}));
}

}  // namespace
}  // namespace awd
