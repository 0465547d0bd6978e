// SPDX-License-Identifier: Apache-2.0
// What a patch learns during a pass: the sums that the field's estimator goes by, and no others.
#pragma once

#include <algorithm>
#include <memory_resource>
#include <variant>

#include "awd/field.h"
#include "density/square_statistics.h"
#include "density/square_sums.h"

namespace awd {

/// std::visit, but for a variant that always holds something.
template <class Variant, class Visit>
decltype(auto) visitSums(Variant& either, Visit&& visit) {
  if (auto* sums = std::get_if<SquareStatistics>(&either)) return visit(*sums);
  return visit(*std::get_if<SquareSums>(&either));
}

class PatchStatistics {
 public:
  /// Under the estimator `paper`.
  PatchStatistics(std::pmr::memory_resource* memory, const BasisLevel& level, int unitExponent)
      : sums_(std::in_place_type<SquareStatistics>, memory, std::size_t{level.count} * level.count,
              unitExponent) {}
  /// Under another one; pattern: null unless it is `refit`.
  PatchStatistics(std::pmr::memory_resource* memory, const BasisLevel& level,
                  Ref<NormalPattern> pattern, int unitExponent)
      : sums_(std::in_place_type<SquareSums>, memory, level, std::move(pattern), unitExponent) {}

  /// A sample drawn since the last adapt, and f on the square.
  void record(const AWDDirectionSample& sample, double f) noexcept {
    if (auto* sums = std::get_if<SquareStatistics>(&sums_)) {
      sums->record(sample.component, f);
      return;
    }
    const double p = static_cast<double>(sample.pdf) * static_cast<double>(sample.solidAngle);
    std::get_if<SquareSums>(&sums_)->record(sample.square[0], sample.square[1], p, f);
  }

  /// Null under another estimator.
  const SquareStatistics* byComponent() const { return std::get_if<SquareStatistics>(&sums_); }
  /// Null under `paper`.
  const SquareSums* byFunction() const { return std::get_if<SquareSums>(&sums_); }

  /// What wrong values there were, and in which unit they were summed.
  const FixedSums& common() const {
    return visitSums(sums_, [](const auto& sums) -> const FixedSums& { return sums; });
  }
  std::size_t components() const {
    return visitSums(sums_, [](const auto& sums) { return sums.components(); });
  }
  uint64_t samples() const {
    return visitSums(sums_, [](const auto& sums) { return sums.samples(); });
  }
  /// A magnitude to set the next pass's unit by: the mean, unless single values tower above it.
  double magnitude() const {
    const auto count = static_cast<double>(std::max<uint64_t>(1, samples()));
    const double total = visitSums(sums_, [](const auto& sums) { return sums.total(); });
    return std::max(total / count, common().largest() * 0x1p-19);
  }

  /// Of the same kind, level and unit.
  void add(const PatchStatistics& other) noexcept {
    visitSums(sums_, [&](auto& sums) {
      sums.add(*std::get_if<std::decay_t<decltype(sums)>>(&other.sums_));
    });
  }
  void clear() noexcept {
    visitSums(sums_, [](auto& sums) { sums.clear(); });
  }
  std::size_t bytes() const {
    return sizeof *this +
           visitSums(sums_, [](const auto& sums) { return sums.bytes() - sizeof sums; });
  }

 private:
  std::variant<SquareStatistics, SquareSums> sums_;
};

}  // namespace awd
