// SPDX-License-Identifier: Apache-2.0
#include "render/pass_weight.h"

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

/// Pixels without the hundredth part where something is largest.
std::ptrdiff_t usualCount(std::size_t pixels) {
  return static_cast<std::ptrdiff_t>(pixels - pixels / 100);
}

/// The mean of those pixels.
double usualMean(const std::pmr::vector<float>& image) {
  const std::ptrdiff_t most = usualCount(image.size());
  std::pmr::vector<float> usual(image, image.get_allocator());
  std::nth_element(usual.begin(), usual.begin() + (most - 1), usual.end());
  return std::accumulate(usual.begin(), usual.begin() + most, 0.0) / static_cast<double>(most);
}

}  // namespace

double passWeight(std::pmr::memory_resource* memory, const PassFilm& pass, uint64_t samples) {
  const auto n = static_cast<double>(samples);
  const std::size_t count = pass.pixels.size();
  std::pmr::vector<float> means(count, memory);
  std::pmr::vector<double> terms(count, memory);
  const auto weighed = [](Vec3d c) { return 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z; };
  for (std::size_t i = 0; i < count; ++i) {
    const PixelSums& pixel = pass.pixels[i];
    means[i] = static_cast<float>(weighed(pixel.sum) / n);
    const Vec3d mean = pixel.sum * (1.0 / n);
    terms[i] = samples > 1 ? weighed(pixel.squares - mean * pixel.sum) / (n - 1.0) : 0.0;
  }
  if (samples == 1) {
    for (std::size_t i = 0; i + 1 < count; ++i) {
      const double difference = static_cast<double>(means[i + 1]) - means[i];
      terms[i] = 0.5 * difference * difference;
    }
  }
  const std::pmr::vector<float> local = blurred(means, pass.width, pass.height);
  const double image = usualMean(local);
  for (std::size_t i = 0; i < count; ++i) {
    terms[i] /= static_cast<double>(local[i]) * local[i] + 0.01 * image * image;
  }
  const auto kept = terms.begin() + usualCount(count);
  std::nth_element(terms.begin(), kept - 1, terms.end());
  const double sum = std::accumulate(terms.begin(), kept, 0.0);
  const double weight = static_cast<double>(kept - terms.begin()) / sum;
  // Nothing but black, or nearly: light is rarer than one of all these samples.
  return weight > 0.0 && std::isfinite(weight) ? weight : 1.0 / (n * static_cast<double>(count));
}

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
