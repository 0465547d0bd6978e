// SPDX-License-Identifier: Apache-2.0
#include "metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace command {
namespace {

std::array<double, 3> meanColor(const RgbImage& image) {
  std::array<double, 3> sum = {};
  for (std::size_t i = 0; i < image.values.size(); ++i) sum[i % 3] += image.values[i];
  const std::size_t pixels = image.values.size() / 3;
  for (double& channel : sum) channel /= static_cast<double>(pixels);
  return sum;
}

}  // namespace

std::size_t countNonFinite(const RgbImage& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    count += !(std::isfinite(image.values[i]) && std::isfinite(image.values[i + 1]) &&
               std::isfinite(image.values[i + 2]));
  }
  return count;
}

std::optional<uint32_t> sizeRatio(const RgbImage& large, const RgbImage& small) {
  const uint32_t ratio = large.width / small.width;
  if (ratio < 1 || large.width != ratio * small.width || large.height != ratio * small.height) {
    return std::nullopt;
  }
  return ratio;
}

RgbImage boxFilter(const RgbImage& image, uint32_t factor) {
  RgbImage result{image.width / factor, image.height / factor, {}};
  result.values.reserve(std::size_t{3} * result.width * result.height);
  for (std::size_t y = 0; y < result.height; ++y) {
    for (std::size_t x = 0; x < result.width; ++x) {
      std::array<double, 3> sum = {};
      for (std::size_t v = y * factor; v < (y + 1) * factor; ++v) {
        for (std::size_t u = x * factor; u < (x + 1) * factor; ++u) {
          const float* pixel = &image.values[3 * (v * image.width + u)];
          for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
        }
      }
      for (const double channel : sum) {
        result.values.push_back(static_cast<float>(channel / (double{1} * factor * factor)));
      }
    }
  }
  return result;
}

Metrics compareImages(const RgbImage& image, const RgbImage& reference, const RgbImage& variance) {
  Metrics metrics;
  metrics.mean = meanColor(image);
  metrics.meanReference = meanColor(reference);
  const std::array<double, 3>& r = metrics.meanReference;
  const double meanOfAll = (r[0] + r[1] + r[2]) / 3.0;
  const double floor = 0.01 * meanOfAll * meanOfAll;

  const std::size_t pixels = reference.values.size() / 3;
  struct Term {
    double seen, noise;  // noise: what the reference's variance contributes
  };
  std::vector<Term> terms(pixels);
  double absolute = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    double squaredError = 0.0, squaredReference = 0.0, noise = 0.0;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
      const double error = static_cast<double>(image.values[c]) - reference.values[c];
      absolute += std::abs(error);
      squaredError += error * error;
      squaredReference += static_cast<double>(reference.values[c]) * reference.values[c];
      if (!variance.values.empty()) noise += variance.values[c];
    }
    const double scale = 1.0 / (squaredReference + 3.0 * floor);
    terms[i] = {squaredError * scale, noise * scale};
  }
  metrics.l1 = absolute / static_cast<double>(3 * pixels);
  if (!(floor > 0.0)) {
    metrics.relMse = metrics.relMseTrimmed = std::numeric_limits<double>::quiet_NaN();
    return metrics;
  }
  const std::size_t dropped = pixels / 1000;
  const auto firstKept = terms.begin() + static_cast<std::ptrdiff_t>(dropped);
  std::nth_element(terms.begin(), firstKept, terms.end(),
                   [](const Term& a, const Term& b) { return a.seen > b.seen; });
  const auto add = [](double sum, const Term& term) { return sum + (term.seen - term.noise); };
  const double kept = std::accumulate(firstKept, terms.end(), 0.0, add);
  metrics.relMseTrimmed = kept / static_cast<double>(pixels - dropped);
  metrics.relMse =
      std::accumulate(terms.begin(), firstKept, kept, add) / static_cast<double>(pixels);
  return metrics;
}

}  // namespace command
