// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <algorithm>

namespace awd {

void Film::merge(const Film& pass, uint64_t samples) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    pixels_[i].sum += pass.pixels_[i].sum;
    pixels_[i].squares += pass.pixels_[i].squares;
  }
  samples_ += samples;
}

Rgb Film::mean(std::size_t pixel) const {
  if (samples_ == 0) return {};
  return convert<float>(pixels_[pixel].sum * (1.0 / static_cast<double>(samples_)));
}

Rgb Film::variance(std::size_t pixel) const {
  if (samples_ < 2) return {};
  const auto n = static_cast<double>(samples_);
  const Pixel& p = pixels_[pixel];
  const auto ofMean = [n](double sum, double squares) {
    const double mean = sum / n;
    return static_cast<float>(std::max(squares / n - mean * mean, 0.0) / (n - 1.0));
  };
  return {ofMean(p.sum.x, p.squares.x), ofMean(p.sum.y, p.squares.y), ofMean(p.sum.z, p.squares.z)};
}

}  // namespace awd
