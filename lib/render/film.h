// SPDX-License-Identifier: Apache-2.0
// The film: what all passes have found, each with a weight per sample. With equal weights its mean
// is the paper's sum of pass images weighted by their samples.
#pragma once

#include <cstdint>
#include <limits>
#include <memory_resource>
#include <vector>

#include "util/bytes.h"
#include "util/vec.h"

namespace awd {

/// The samples of a pixel in one pass.
struct PixelSums {
  Vec3d sum, squares;
  Vec3d evens;  ///< sum over the samples of even number

  void add(Rgb radiance, bool even) {
    const Vec3d value = convert<double>(radiance);
    sum += value;
    squares += value * value;
    if (even) evens += value;
  }

  /// What the sums of so many floats and of their squares may be, roundings included.
  static double most(uint64_t samples) { return 1.001 * kFloat * static_cast<double>(samples); }
  static double mostSquared(uint64_t samples) { return kFloat * most(samples); }

 private:
  static constexpr double kFloat = std::numeric_limits<float>::max();
};

/// How far an image is from the truth: sqrt(mean (x - truth)^2) / mean x, over all pixels and
/// channels, and an interval that holds it 95 times of 100.
struct FilmError {
  double error, lower, upper;
};

/// The image of one pass.
struct PassFilm {
  PassFilm(std::pmr::memory_resource* memory, uint32_t columns, uint32_t rows)
      : width(columns), height(rows), pixels(std::size_t{columns} * rows, memory) {}
  PixelSums& pixel(uint32_t x, uint32_t y) { return pixels[std::size_t{y} * width + x]; }

  static std::size_t bytesFor(std::size_t pixels) { return pixels * sizeof(PixelSums); }

  uint32_t width, height;
  std::pmr::vector<PixelSums> pixels;
};

class Film {
 public:
  /// Of a sample; it is at most 1.
  static constexpr double kLeastWeight = 0.25;

  Film(std::pmr::memory_resource* memory, uint32_t width, uint32_t height)
      : width_(width), height_(height), pixels_(std::size_t{width} * height, memory) {}

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  uint64_t samples() const { return samples_; }  ///< per pixel

  /// Adds a pass of that many samples per pixel, each of which counts for
  /// kLeastWeight <= weight <= 1. Samples are numbered on from those before: the first has the
  /// number samples().
  void merge(const PassFilm& pass, uint64_t samples, double weight);

  /// Mean radiance sum w x / sum w, and the estimated variance of that mean,
  /// sum w^2 (x - mean)^2 / (sum w)^2 made unbiased for equal variances; 0 below 2 samples.
  Rgb mean(std::size_t pixel) const;
  Rgb variance(std::size_t pixel) const;
  /// From at least 2 samples per pixel; those of even and of odd number must be independent.
  FilmError error() const;
  std::size_t bytes() const { return pixels_.capacity() * sizeof(Pixel); }

  void put(ByteWriter& writer) const;
  /// Of the same size.
  void get(ByteReader& reader);
  /// That put() writes.
  static std::size_t bytesToPut(std::size_t pixels) { return kTotals + pixels * sizeof(Pixel); }

 private:
  struct Pixel {
    Vec3d weighted;      ///< sum w x
    Vec3d sum, squares;  ///< sum w^2 x, sum w^2 x^2
    Vec3d evens;         ///< sum w x over the samples of even number
  };
  static constexpr std::size_t kTotals = sizeof(uint64_t) + 3 * sizeof(double);

  uint32_t width_, height_;
  uint64_t samples_ = 0;
  double weights_ = 0.0;         ///< sum w
  double squaredWeights_ = 0.0;  ///< sum w^2
  double evenWeights_ = 0.0;     ///< sum w over the samples of even number
  std::pmr::vector<Pixel> pixels_;
};

}  // namespace awd
