// SPDX-License-Identifier: Apache-2.0
#include "host_roulette.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bench::host {
namespace {

/// Cells along the longest side of the scene: with 32 or 64 both guides do worse.
constexpr int kCells = 16;
constexpr uint32_t kLeastCount = 16;  ///< for a cell's mean to be believed
/// The constants of our renderer's rule.
constexpr double kFactor = 3.0;
constexpr double kLeastChance = 0.1;
constexpr double kLeastShare = 0.2;
constexpr std::size_t kBlur = 2;  ///< pixels on each side

int cellAt(double offset) { return std::clamp(static_cast<int>(offset), 0, kCells - 1); }

std::size_t sideOf(Vec n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  if (x >= y && x >= z) return n.x > 0.0 ? 0 : 1;
  if (y >= z) return n.y > 0.0 ? 2 : 3;
  return n.z > 0.0 ? 4 : 5;
}

}  // namespace

PathLength::PathLength(const Scene& scene, Roulette roulette, uint32_t width)
    : roulette_(roulette), width_(width), lower_(toVec(scene.info().lower)) {
  const Vec size = toVec(scene.info().upper) - lower_;
  cellsPerLength_ = kCells / std::max({size.x, size.y, size.z});
  if (learns()) cells_.resize(std::size_t{6} * kCells * kCells * kCells);
}

std::size_t PathLength::cellOf(const Place& place) const {
  const Vec offset = cellsPerLength_ * (place.position - lower_);
  const int cell = (cellAt(offset.x) * kCells + cellAt(offset.y)) * kCells + cellAt(offset.z);
  return 6 * static_cast<std::size_t>(cell) + sideOf(place.normal);
}

double PathLength::chance(const Place& place, Vec throughput, std::size_t pixel) const {
  const double albedo = std::max({place.albedo.x, place.albedo.y, place.albedo.z});
  // A black surface reflects nothing, whatever its neighbours do.
  if (expected_.empty() || !(albedo > 0.0)) return albedo;
  const Cell& cell = cells_[cellOf(place)];
  if (cell.count < kLeastCount || !(expected_[pixel] > 0.0)) return albedo;
  return std::clamp(kFactor * luminance(throughput) * cell.mean / expected_[pixel], kLeastChance,
                    1.0);
}

void PathLength::learn(const Place& place, double reflected) {
  Cell& cell = cells_[cellOf(place)];
  cell.sum += reflected;
  ++cell.count;
}

void PathLength::adapt(const std::vector<Vec>& image) {
  for (Cell& cell : cells_) {
    if (cell.count > 0) cell.mean = cell.sum / cell.count;
  }
  std::vector<double> luminances(image.size());
  std::transform(image.begin(), image.end(), luminances.begin(), luminance);
  // What is rare and bright would raise the floor for all.
  std::vector<double> sorted = luminances;
  std::sort(sorted.begin(), sorted.end());
  const std::size_t kept = sorted.size() - sorted.size() / 100;
  const double mean =
      std::accumulate(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(kept), 0.0) /
      static_cast<double>(kept);
  expected_.resize(image.size());
  const std::size_t width = width_, height = image.size() / width;
  for (std::size_t y = 0; y < height; ++y) {
    const std::size_t top = y - std::min(y, kBlur), bottom = std::min(y + kBlur, height - 1);
    for (std::size_t x = 0; x < width; ++x) {
      const std::size_t left = x - std::min(x, kBlur), right = std::min(x + kBlur, width - 1);
      double sum = 0.0;
      for (std::size_t j = top; j <= bottom; ++j) {
        for (std::size_t i = left; i <= right; ++i) sum += luminances[j * width + i];
      }
      const auto count = static_cast<double>((bottom - top + 1) * (right - left + 1));
      expected_[y * width + x] = std::max(sum / count, kLeastShare * mean);
    }
  }
}

}  // namespace bench::host
