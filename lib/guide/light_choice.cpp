// SPDX-License-Identifier: Apache-2.0
#include "guide/light_choice.h"

#include <algorithm>
#include <limits>

namespace awd {

namespace {

/// Share of the prior, and how many shadow rays it counts for beside those of the patch.
constexpr double kPriorShare = 0.05;
constexpr double kPriorRays = 32.0;

constexpr double kBelowOne = 1.0 - std::numeric_limits<double>::epsilon() / 2;

}  // namespace

LightChoice::LightChoice(std::pmr::memory_resource* memory, std::size_t lights)
    : memory_(memory), known_(lights, memory), ends_(lights, memory) {}

void LightChoice::destroy() noexcept { unmake(memory_, this); }

Ref<LightChoice> LightChoice::make(std::pmr::memory_resource* memory, const float* powers,
                                   std::size_t lights) {
  auto choice = Ref<LightChoice>::adopt(awd::make<LightChoice>(memory, memory, lights));
  choice->settle(std::pmr::vector<double>(powers, powers + lights, memory));
  return choice;
}

void LightChoice::settle(const std::pmr::vector<double>& shares) {
  double sum = 0.0;
  for (std::size_t i = 0; i < shares.size(); ++i) ends_[i] = sum += shares[i];
  std::size_t last = shares.size();
  for (std::size_t i = 0; i < shares.size(); ++i) {
    ends_[i] /= sum;
    if (shares[i] > 0.0) last = i;
  }
  // No uniform below 1 lies behind the last that can be chosen.
  std::fill(ends_.begin() + static_cast<std::ptrdiff_t>(last), ends_.end(), 1.0);
  closeSlits();
}

void LightChoice::closeSlits() {
  double before = 0.0;
  for (double& end : ends_) {
    if (end - before < static_cast<double>(std::numeric_limits<float>::min())) end = before;
    before = end;
  }
}

Ref<LightChoice> LightChoice::learn(const LightChoice& prior, const LightSums& sums,
                                    double keep) const {
  auto next = Ref<LightChoice>::adopt(awd::make<LightChoice>(memory_, memory_, known_.size()));
  std::pmr::vector<double> shares(known_.size(), memory_);
  double roots = 0.0;
  double weights = 0.0;
  for (uint32_t i = 0; i < lights(); ++i) {
    const double before = known_[i].weight * keep;
    const auto fresh = static_cast<double>(sums.count(i));
    const double weight = before + fresh;
    const double known =
        before > 0.0 ? known_[i].square * before : 0.0;  // the former may be infinite
    const double square = weight > 0.0 ? (known + sums.squares(i)) / weight : 0.0;
    next->known_[i] = {square, weight};
    shares[i] = std::sqrt(square);
    roots += shares[i];
    weights += weight;
  }
  const bool lit = roots > 0.0 && std::isfinite(roots);
  const double trust = (1.0 - kPriorShare) * weights / (weights + kPriorRays);
  for (uint32_t i = 0; i < lights(); ++i) {
    const double before = static_cast<double>(prior.chance(i));
    shares[i] = lit ? trust * (shares[i] / roots) + (1.0 - trust) * before : before;
  }
  next->settle(shares);
  return next;
}

LightChoice::Chosen LightChoice::choose(double u) const {
  u = std::min(u, kBelowOne);  // of a stratified uniform, which rounding takes to 1
  uint32_t light = 0;
  while (u >= ends_[light]) ++light;
  const double begin = light > 0 ? ends_[light - 1] : 0.0;
  const double width = ends_[light] - begin;
  return {light, static_cast<float>(width), std::min((u - begin) / width, kBelowOne)};
}

double LightChoice::magnitude() const {
  double sum = 0.0;
  for (const Known& light : known_) sum += std::sqrt(light.square);
  return sum;
}

void LightChoice::put(ByteWriter& writer) const {
  for (const Known& light : known_) {
    writer.put(light.square);
    writer.put(light.weight);
  }
  for (const double end : ends_) writer.put(end);
}

Ref<LightChoice> LightChoice::get(ByteReader& reader, std::pmr::memory_resource* memory,
                                  std::size_t lights) {
  constexpr double kLargestWeight = 0x1p80;  // no pass has more than 2^64
  constexpr double kInfinity = std::numeric_limits<double>::infinity();  // of sums beyond doubles
  auto choice = Ref<LightChoice>::adopt(awd::make<LightChoice>(memory, memory, lights));
  for (Known& light : choice->known_) {
    light.square = reader.get(0.0, kInfinity);
    light.weight = reader.get(0.0, kLargestWeight);
  }
  double before = 0.0;
  for (double& end : choice->ends_) before = end = reader.get(before, 1.0);
  if (before != 1.0) reader.damaged();
  choice->closeSlits();
  return choice;
}

}  // namespace awd
