// SPDX-License-Identifier: Apache-2.0
// The film as bytes, within the frame of whoever writes them.
#include <limits>

#include "render/film.h"

namespace awd {

namespace {

constexpr double kLargestSum = std::numeric_limits<double>::max();

void put(ByteWriter& writer, const Vec3d& sums) {
  for (const double sum : {sums.x, sums.y, sums.z}) writer.put(sum);
}

/// Radiance is not negative, nor is any sum of it.
Vec3d getSums(ByteReader& reader) {
  Vec3d sums;
  for (double* sum : {&sums.x, &sums.y, &sums.z}) *sum = reader.get(0.0, kLargestSum);
  return sums;
}

}  // namespace

void Film::put(ByteWriter& writer) const {
  writer.put(samples_);
  for (const double sum : {weights_, squaredWeights_, evenWeights_}) writer.put(sum);
  for (const Pixel& pixel : pixels_) {
    for (const Vec3d* sums : {&pixel.weighted, &pixel.sum, &pixel.squares, &pixel.evens}) {
      awd::put(writer, *sums);
    }
  }
}

void Film::get(ByteReader& reader) {
  samples_ = reader.get<uint64_t>();
  for (double* sum : {&weights_, &squaredWeights_, &evenWeights_}) {
    *sum = reader.get(0.0, kLargestSum);
  }
  if ((samples_ == 0) != (weights_ == 0.0) || evenWeights_ > weights_) reader.damaged();
  for (Pixel& pixel : pixels_) {
    for (Vec3d* sums : {&pixel.weighted, &pixel.sum, &pixel.squares, &pixel.evens}) {
      *sums = getSums(reader);
    }
  }
}

}  // namespace awd
