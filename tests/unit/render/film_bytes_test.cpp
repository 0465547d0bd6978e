// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "render/film.h"
#include "util/error.h"

namespace awd {
namespace {

constexpr char kMagic[] = "FILMTEST";

Film someFilm() {
  Film film(std::pmr::get_default_resource(), 3, 2);
  PassFilm pass(std::pmr::get_default_resource(), 3, 2);
  for (uint32_t i = 0; i < 18; ++i) {
    const auto x = static_cast<float>(i);
    pass.pixel(i % 3, i / 3 % 2).add({x, x * x, 1.0f / (x + 1.0f)}, i % 2 == 0);
  }
  film.merge(pass, 3, 0.75);
  return film;
}

std::pmr::vector<char> bytesOf(const Film& film) {
  ByteWriter writer(std::pmr::get_default_resource(), kMagic, 1);
  film.put(writer);
  return writer.finish();
}

ByteReader readerOf(const std::pmr::vector<char>& bytes) {
  return {bytes.data(), bytes.size(), kMagic, 1, "a film"};
}

TEST(FilmBytes, ComeBackBitByBit) {
  const Film film = someFilm();
  const auto bytes = bytesOf(film);
  Film copy(std::pmr::get_default_resource(), 3, 2);
  ByteReader reader = readerOf(bytes);
  EXPECT_EQ(reader.remaining(), Film::bytesToPut(6));
  copy.get(reader);
  reader.finish();
  EXPECT_TRUE(bytesOf(copy) == bytes);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(copy.mean(i), film.mean(i));
    EXPECT_EQ(copy.variance(i), film.variance(i));
  }
  EXPECT_EQ(copy.error().upper, film.error().upper);
  PassFilm pass(std::pmr::get_default_resource(), 3, 2);
  pass.pixel(1, 1).add({2, 2, 2}, false);
  Film ours = film;
  ours.merge(pass, 1, 1.0);
  copy.merge(pass, 1, 1.0);
  EXPECT_TRUE(bytesOf(ours) == bytesOf(copy));
}

TEST(FilmBytes, OfWhatNoSamplesCanMakeAreDamaged) {
  const auto expectDamaged = [](uint64_t samples, double weights, double evens, double sum) {
    ByteWriter writer(std::pmr::get_default_resource(), kMagic, 1);
    writer.put(samples);
    writer.put(weights);
    writer.put(weights);
    writer.put(evens);
    for (int i = 0; i < 12; ++i) writer.put(sum);
    const auto bytes = writer.finish();
    Film film(std::pmr::get_default_resource(), 1, 1);
    ByteReader reader = readerOf(bytes);
    EXPECT_THROW(film.get(reader), Error);
  };
  expectDamaged(2, 0.0, 0.0, 1.0);
  expectDamaged(0, 1.0, 0.0, 1.0);
  expectDamaged(2, 1.0, 1.5, 1.0);
  expectDamaged(2, 1.0, 0.0, 1.0);  // errors would be NaN
  expectDamaged(2, 1.0, 1.0, 1.0);
  expectDamaged(2, 2.5, 1.25, 1.0);
  expectDamaged(2, 0.25, 0.125, 1.0);
  expectDamaged(2, 1.0, 0.5, 1e39);  // no two floats
  expectDamaged(2, 1.0, 0.5, -1.0);
  expectDamaged(2, 1.0, 0.5, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace awd
