// SPDX-License-Identifier: Apache-2.0
// Which light the shadow rays of a patch go to. Chances proportional to the root mean square of
// what each light brings have the least variance: with p_l for light l the second moment of the
// estimate is sum_l E[x_l^2] / p_l, least at p_l ~ sqrt(E[x_l^2]), where it is the square of
// sum_l sqrt(E[x_l^2]). Immutable.
#pragma once

#include <cstdint>
#include <memory_resource>
#include <vector>

#include "guide/light_sums.h"
#include "util/context.h"

namespace awd {

class LightChoice final : public RefCounted {
 public:
  struct Chosen {
    uint32_t light;
    float chance;
    double rest;  ///< of the uniform that chose: uniform again, in [0,1)
  };

  LightChoice(std::pmr::memory_resource* memory, std::size_t lights);
  /// Before anything is known: by these powers, finite and not negative, of a positive sum.
  static Ref<LightChoice> make(std::pmr::memory_resource* memory, const float* powers,
                               std::size_t lights);
  /// What a pass adds to it. Never chooses a light less than a twentieth as often as `prior`, so
  /// that one which has not been met yet is. keep: how much of what was known counts, in [0,1].
  Ref<LightChoice> learn(const LightChoice& prior, const LightSums& sums, double keep) const;

  uint32_t lights() const { return static_cast<uint32_t>(known_.size()); }
  /// u in [0,1).
  Chosen choose(double u) const;
  float chance(uint32_t light) const {
    return static_cast<float>(ends_[light] - (light > 0 ? ends_[light - 1] : 0.0));
  }
  /// sum_l sqrt(E[x_l^2]): the root mean square of an estimate of all lights by one shadow ray.
  double magnitude() const;
  bool operator==(const LightChoice& other) const { return ends_ == other.ends_; }

  void put(ByteWriter& writer) const;
  static Ref<LightChoice> get(ByteReader& reader, std::pmr::memory_resource* memory,
                              std::size_t lights);
  std::size_t bytes() const { return sizeof *this + lights() * (sizeof(Known) + sizeof(double)); }

 private:
  struct Known {
    double square;  ///< mean of what it brought, squared
    double weight;  ///< of how many shadow rays
  };
  void destroy() noexcept override;
  /// Chances proportional to these.
  void settle(const std::pmr::vector<double>& shares);
  /// A chance that is no float above 0 is none: else u = 0 could choose a light of chance 0.
  void closeSlits();

  std::pmr::memory_resource* memory_;
  std::pmr::vector<Known> known_;
  std::pmr::vector<double> ends_;  ///< chances up to and with each light; exactly 1 at the last
};

}  // namespace awd
