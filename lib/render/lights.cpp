// SPDX-License-Identifier: Apache-2.0
#include "render/lights.h"

#include <algorithm>

namespace awd {

Lights::Lights(std::pmr::memory_resource* memory)
    : lights_(memory), triangles_(memory), cumulative_(memory), groupEnds_(memory) {}

void Lights::add(Vec3f normal, Rgb emission, const std::pmr::vector<Vec3f>& corners) {
  const auto first = static_cast<uint32_t>(triangles_.size());
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Vec3f edge1 = corners[i + 1] - corners[i];
    const Vec3f edge2 = corners[i + 2] - corners[i];
    area += 0.5 * length(cross(convert<double>(edge1), convert<double>(edge2)));
    triangles_.push_back({corners[i], edge1, edge2, area});
  }
  const auto end = static_cast<uint32_t>(triangles_.size());
  for (uint32_t i = first; i < end; ++i) triangles_[i].cumulative /= area;
  triangles_.back().cumulative = 1.0;
  lights_.push_back({normal, emission, static_cast<float>(area), 0.0f, first, end});
}

void Lights::finish() {
  double total = 0.0;
  for (const Light& light : lights_) {
    // Radiance from 1e-45 to 1e38 times a tiny area: in double.
    total += static_cast<double>(light.area) * luminance(convert<double>(light.emission));
    cumulative_.push_back(total);
  }
  const auto count = static_cast<double>(lights_.size());
  for (std::size_t i = 0; i < lights_.size(); ++i) {
    // Areas below any float leave them alike.
    const double upTo = total > 0.0 ? cumulative_[i] / total : static_cast<double>(i + 1) / count;
    cumulative_[i] = i + 1 < lights_.size() ? upTo : 1.0;
    lights_[i].choice = static_cast<float>(cumulative_[i] - (i ? cumulative_[i - 1] : 0.0));
  }
  group();
}

void Lights::group() {
  double begin = 0.0;
  for (uint32_t i = 0; i < size(); ++i) {
    const bool alone = size() <= kMostGroups;
    const bool last = i + 1 == size();
    if (alone || last || cumulative_[i] - begin >= 1.0 / kMostGroups) {
      groupEnds_.push_back(i + 1);
      begin = cumulative_[i];
    }
  }
}

uint32_t Lights::chooseIn(uint32_t group, double uniform) const {
  const uint32_t first = group > 0 ? groupEnds_[group - 1] : 0;
  const uint32_t end = groupEnds_[group];
  if (end - first == 1) return first;
  const double at = beginOf(group) + uniform * (endOf(group) - beginOf(group));
  return std::clamp(choose(at), first, end - 1);
}

uint32_t Lights::choose(double uniform) const {
  const auto chosen = std::upper_bound(cumulative_.begin(), cumulative_.end(), uniform);
  return std::min(static_cast<uint32_t>(chosen - cumulative_.begin()), size() - 1);
}

Vec3f Lights::sample(const Light& light, double u, double v) const {
  // The first uniform chooses the triangle and what is left of it a place in it.
  uint32_t chosen = light.firstTriangle;
  if (light.endTriangle - light.firstTriangle > 1) {
    const auto begin = triangles_.begin() + light.firstTriangle;
    const auto found =
        std::upper_bound(begin, triangles_.begin() + light.endTriangle, u,
                         [](double value, const Corners& t) { return value < t.cumulative; });
    chosen = std::min(static_cast<uint32_t>(found - triangles_.begin()), light.endTriangle - 1);
    const double before = found == begin ? 0.0 : triangles_[chosen - 1].cumulative;
    u = std::clamp((u - before) / (triangles_[chosen].cumulative - before), 0.0, 1.0);
  }
  const Corners& t = triangles_[chosen];
  const auto root = static_cast<float>(std::sqrt(u));
  return t.origin + t.edge1 * (root * static_cast<float>(1.0 - v)) +
         t.edge2 * (root * static_cast<float>(v));
}

float Lights::brightest() const {
  float most = 0.0f;
  for (const Light& light : lights_) most = std::max(most, luminance(light.emission));
  return most;
}

}  // namespace awd
