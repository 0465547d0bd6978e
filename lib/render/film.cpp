// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace awd {

void Film::merge(const PassFilm& pass, uint64_t samples, double weight) {
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    pixels_[i].weighted += pass.pixels[i].sum * weight;
    pixels_[i].sum += pass.pixels[i].sum * (weight * weight);
    pixels_[i].squares += pass.pixels[i].squares * (weight * weight);
    pixels_[i].evens += pass.pixels[i].evens * weight;
  }
  const uint64_t evens = (samples + (samples_ % 2 == 0 ? 1 : 0)) / 2;
  evenWeights_ += weight * static_cast<double>(evens);
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
    // Of radiance beyond 1e19 the square leaves the range of floats.
    constexpr double kMost = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(deviations / divisor, 0.0, kMost));
  };
  return {ofMean(p.weighted.x, p.sum.x, p.squares.x), ofMean(p.weighted.y, p.sum.y, p.squares.y),
          ofMean(p.weighted.z, p.sum.z, p.squares.z)};
}

// The film is m = (A a + B b) / (A + B), a and b the means of the even and the odd samples, A and B
// their weights. With t = A B / (A + B)^2 (a - b)^2, E[t] = E[(m - truth)^2] if variances go with
// the inverse of weights, however samples hang together within a half. What t misses of the true
// square is a product of the halves' errors: of mean 0, and of the variance 4 E[t]^2 <= 4/3 E[t^2]
// where errors are normal or have heavier tails.
FilmError Film::error() const {
  const double odds = weights_ - evenWeights_;
  const double scale = evenWeights_ * odds / (weights_ * weights_);
  double mean = 0.0, sum = 0.0, squares = 0.0;
  for (const Pixel& p : pixels_) {
    const Vec3d apart = p.evens * (1.0 / evenWeights_) - (p.weighted - p.evens) * (1.0 / odds);
    const double t = scale * dot(apart, apart) / 3.0;
    sum += t;
    squares += t * t;
    mean += (p.weighted.x + p.weighted.y + p.weighted.z) / (3.0 * weights_);
  }
  if (!(sum > 0.0)) return {0.0, 0.0, 0.0};
  constexpr double kQuantile = 1.959964;
  const double half = kQuantile * std::sqrt(4.0 / 3.0 * squares);
  const auto relative = [&](double squared) {
    const auto count = static_cast<double>(pixels_.size());
    return std::sqrt(std::max(squared, 0.0) * count) / mean;
  };
  return {relative(sum), relative(sum - half), relative(sum + half)};
}

}  // namespace awd
