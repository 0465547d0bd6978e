// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <algorithm>

namespace awd {

void Film::merge(const PassFilm& pass, uint64_t samples, double weight) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    pixels_[i].weighted += pass.pixels[i].sum * weight;
    pixels_[i].sum += pass.pixels[i].sum * (weight * weight);
    pixels_[i].squares += pass.pixels[i].squares * (weight * weight);
  }
  samples_ += samples;
  weights_ += weight * static_cast<double>(samples);
  squaredWeights_ += weight * weight * static_cast<double>(samples);
}

Rgb Film::mean(std::size_t pixel) const {
  if (samples_ == 0) return {};
  return convert<float>(pixels_[pixel].weighted * (1.0 / weights_));
}

Rgb Film::variance(std::size_t pixel) const {
  // Of the squared deviations from the true mean, those from the estimated one leave out its own
  // variance: (sum w)^2 - sum w^2 remain of (sum w)^2.
  const double divisor = weights_ * weights_ - squaredWeights_;
  if (samples_ < 2 || !(divisor > 0.0)) return {};
  const Pixel& p = pixels_[pixel];
  const auto ofMean = [&](double weighted, double sum, double squares) {
    const double mean = weighted / weights_;
    const double deviations = squares - 2.0 * mean * sum + mean * mean * squaredWeights_;
    return static_cast<float>(std::max(deviations, 0.0) / divisor);
  };
  return {ofMean(p.weighted.x, p.sum.x, p.squares.x), ofMean(p.weighted.y, p.sum.y, p.squares.y),
          ofMean(p.weighted.z, p.sum.z, p.squares.z)};
}

}  // namespace awd
