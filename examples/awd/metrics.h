// SPDX-License-Identifier: Apache-2.0
// How far an image is from a reference.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace command {

/// Linear RGB, three floats a pixel, rows from the top.
struct RgbImage {
  uint32_t width = 0, height = 0;
  std::vector<float> values;
};

/// Pixels with a channel that is NaN or infinite.
std::size_t countNonFinite(const RgbImage& image);

/// The whole number by which both sides of `large` are longer than those of `small`, if there is
/// one.
std::optional<uint32_t> sizeRatio(const RgbImage& large, const RgbImage& small);

/// Each pixel the mean of `factor` x `factor` pixels; factor divides both sides.
RgbImage boxFilter(const RgbImage& image, uint32_t factor);

struct Metrics {
  double l1 = 0.0;  // mean over pixels and channels of |x - r|
  /// Mean over pixels of mean_rgb (x-r)^2 / (mean_rgb r^2 + 0.01 (mean of all r)^2); NaN if the
  /// reference is black.
  double relMse = 0.0;
  /// Without the largest 0.1 % of the pixels' terms, rounded down.
  double relMseTrimmed = 0.0;
  std::array<double, 3> mean = {}, meanReference = {};
};

/// Both of one size and with at least one pixel, all finite. `variance`, unless it is empty, is
/// that of the reference's own values: taken off the squares, so that relative errors are those
/// against what the reference estimates, and may be negative.
Metrics compareImages(const RgbImage& image, const RgbImage& reference,
                      const RgbImage& variance = {});

}  // namespace command
