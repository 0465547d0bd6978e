// SPDX-License-Identifier: Apache-2.0
#include "render/expected_luminance.h"

#include <algorithm>
#include <numeric>

namespace awd {

namespace {

constexpr uint32_t kRadius = 2;
/// Of the image's mean: what a pixel is at least expected to have.
constexpr double kLeastExpected = 0.2;

/// Means over (2 kRadius + 1)^2 pixels, fewer at the border.
std::pmr::vector<float> blurred(const std::pmr::vector<float>& image, uint32_t width,
                                uint32_t height) {
  std::pmr::vector<float> result(image.size(), image.get_allocator());
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      const uint32_t x0 = x - std::min(x, kRadius), x1 = std::min(x + kRadius, width - 1);
      const uint32_t y0 = y - std::min(y, kRadius), y1 = std::min(y + kRadius, height - 1);
      float sum = 0.0f;
      for (uint32_t v = y0; v <= y1; ++v) {
        for (uint32_t u = x0; u <= x1; ++u) sum += image[std::size_t{v} * width + u];
      }
      result[std::size_t{y} * width + x] = sum / static_cast<float>((x1 - x0 + 1) * (y1 - y0 + 1));
    }
  }
  return result;
}

/// The mean over the pixels without the brightest hundredth.
double usualMean(const std::pmr::vector<float>& image) {
  const auto most = static_cast<std::ptrdiff_t>(image.size() - image.size() / 100);
  std::pmr::vector<float> usual(image, image.get_allocator());
  std::nth_element(usual.begin(), usual.begin() + (most - 1), usual.end());
  return std::accumulate(usual.begin(), usual.begin() + most, 0.0) / static_cast<double>(most);
}

}  // namespace

std::pmr::vector<float> expectedLuminance(std::pmr::memory_resource* memory, const Film& film) {
  std::pmr::vector<float> image(memory);
  if (film.samples() == 0) return image;
  image.resize(std::size_t{film.width()} * film.height());
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = luminance(film.mean(i));
  image = blurred(image, film.width(), film.height());
  const auto least = static_cast<float>(kLeastExpected * usualMean(image));
  for (float& luminance : image) luminance = std::max(luminance, least);
  return image;
}

}  // namespace awd
