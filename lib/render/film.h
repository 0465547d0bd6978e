// SPDX-License-Identifier: Apache-2.0
// The film: sums of radiance and of its square over all samples of each pixel. The mean over all
// passes is the paper's sum of pass images weighted by their samples.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "util/vec.h"

namespace awd {

struct Pixel {
  Vec3d sum;
  Vec3d squares;

  void add(Rgb radiance) {
    const Vec3d value = convert<double>(radiance);
    sum += value;
    squares += value * value;
  }
};

class Film {
 public:
  Film(std::pmr::memory_resource* memory, uint32_t width, uint32_t height)
      : width_(width), height_(height), pixels_(std::size_t{width} * height, memory) {}

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  uint64_t samples() const { return samples_; }  ///< per pixel
  Pixel& pixel(uint32_t x, uint32_t y) { return pixels_[std::size_t{y} * width_ + x]; }

  /// Adds a pass of that many samples per pixel.
  void merge(const Film& pass, uint64_t samples);

  /// Mean radiance, and the estimated variance of that mean: (mean of squares - square of the
  /// mean) / (samples - 1), 0 below 2 samples.
  Rgb mean(std::size_t pixel) const;
  Rgb variance(std::size_t pixel) const;
  std::size_t bytes() const { return pixels_.capacity() * sizeof(Pixel); }

 private:
  uint32_t width_, height_;
  uint64_t samples_ = 0;
  std::pmr::vector<Pixel> pixels_;
};

}  // namespace awd
