// SPDX-License-Identifier: Apache-2.0
// The film as bytes, within the frame of whoever writes them.
#include <limits>

#include "render/film.h"

namespace awd {

namespace {

/// Of what is added up, pass by pass.
constexpr double kRounding = 1e-9;

void put(ByteWriter& writer, const Vec3d& sums) {
  for (const double sum : {sums.x, sums.y, sums.z}) writer.put(sum);
}

/// Radiance is not negative, nor is any sum of it.
Vec3d getSums(ByteReader& reader, double most) {
  Vec3d sums;
  for (double* sum : {&sums.x, &sums.y, &sums.z}) *sum = reader.get(0.0, most);
  return sums;
}

bool isWeightOf(double weight, double samples) {
  return weight >= Film::kLeastWeight * samples * (1.0 - kRounding) &&
         weight <= samples * (1.0 + kRounding);
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
    *sum = reader.get(0.0, std::numeric_limits<double>::max());
  }
  const uint64_t half = samples_ / 2;
  const auto odds = static_cast<double>(half);
  const auto evens = static_cast<double>(samples_ - half);
  if (!isWeightOf(evenWeights_, evens) || !isWeightOf(weights_ - evenWeights_, odds) ||
      squaredWeights_ > weights_ * (1.0 + kRounding)) {
    reader.damaged();
  }
  const double most = PixelSums::most(samples_), mostSquared = PixelSums::mostSquared(samples_);
  for (Pixel& pixel : pixels_) {
    pixel.weighted = getSums(reader, most);
    pixel.sum = getSums(reader, most);
    pixel.squares = getSums(reader, mostSquared);
    pixel.evens = getSums(reader, most);
  }
}

}  // namespace awd
