// SPDX-License-Identifier: Apache-2.0
// What a patch learns during a pass: the sums that the field's estimator goes by, and where in the
// patch the samples lay.
#pragma once

#include <algorithm>
#include <array>
#include <memory_resource>
#include <variant>

#include "awd/field.h"
#include "density/square_statistics.h"
#include "density/square_sums.h"
#include "density/square_values.h"
#include "guide/spatial_tree.h"

namespace awd {

/// std::visit, but for a variant that always holds something.
template <class Variant, class Visit>
decltype(auto) visitSums(Variant& either, Visit&& visit) {
  if (auto* sums = std::get_if<SquareValues>(&either)) return visit(*sums);
  if (auto* sums = std::get_if<SquareStatistics>(&either)) return visit(*sums);
  return visit(*std::get_if<SquareSums>(&either));
}

class PatchStatistics {
 public:
  using Eighths = std::array<uint64_t, SpatialTree::kEighths>;

  /// pattern: null unless the estimator is `refit`.
  PatchStatistics(std::pmr::memory_resource* memory, const BasisLevel& level,
                  AWDEstimator estimator, Ref<NormalPattern> pattern, int unitExponent) {
    if (estimator == AWD_ESTIMATOR_LUMPED) {
      sums_.emplace<SquareValues>(memory, level, unitExponent);
    } else if (estimator == AWD_ESTIMATOR_PAPER) {
      sums_.emplace<SquareStatistics>(memory, std::size_t{level.count} * level.count, unitExponent);
    } else {
      sums_.emplace<SquareSums>(memory, level, std::move(pattern), unitExponent);
    }
  }

  /// Brings nearer what record() will touch, but for the sums themselves; then those.
  void prefetch() const {
    const auto* first = reinterpret_cast<const char*>(this);
    for (std::size_t i = 0; i < sizeof *this; i += 64) __builtin_prefetch(first + i, 1);
  }
  void prefetch(const AWDDirectionSample& sample) const {
    if (const auto* sums = values()) sums->prefetch(sample.square[0], sample.square[1]);
  }
  /// A sample drawn since the last adapt in that eighth of the patch, and f on the square.
  void record(uint32_t eighth, const AWDDirectionSample& sample, double f) noexcept {
    eighths_[eighth].fetch_add(1, std::memory_order_relaxed);
    if (auto* sums = std::get_if<SquareStatistics>(&sums_)) {
      sums->record(sample.component, f);
      return;
    }
    const double p = static_cast<double>(sample.pdf) * static_cast<double>(sample.solidAngle);
    if (auto* sums = std::get_if<SquareValues>(&sums_)) {
      sums->record(sample.square[0], sample.square[1], p, f);
      return;
    }
    std::get_if<SquareSums>(&sums_)->record(sample.square[0], sample.square[1], p, f);
  }

  /// A sample of that eighth whose pdf no sample can have: it counts, and teaches nothing.
  void reject(uint32_t eighth) noexcept {
    eighths_[eighth].fetch_add(1, std::memory_order_relaxed);
    visitSums(sums_, [](auto& sums) { sums.reject(Rejection::kPdf); });
  }

  /// Null under another estimator than `lumped`, `paper`, or one of the others.
  const SquareValues* values() const { return std::get_if<SquareValues>(&sums_); }
  const SquareStatistics* byComponent() const { return std::get_if<SquareStatistics>(&sums_); }
  const SquareSums* byFunction() const { return std::get_if<SquareSums>(&sums_); }

  /// What wrong values there were, and in which unit they were summed.
  const FixedSums& common() const {
    return visitSums(sums_, [](const auto& sums) -> const FixedSums& { return sums; });
  }
  std::size_t components() const {
    return visitSums(sums_, [](const auto& sums) { return sums.components(); });
  }
  uint64_t samples() const {
    uint64_t sum = 0;
    for (const std::atomic<uint64_t>& count : eighths_) {
      sum += count.load(std::memory_order_relaxed);
    }
    return sum;
  }
  Eighths eighths() const {
    Eighths counts;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      counts[i] = eighths_[i].load(std::memory_order_relaxed);
    }
    return counts;
  }
  /// The mean of f/p; of f under `paper`. 0 of no samples.
  double mean() const {
    const auto count = static_cast<double>(std::max<uint64_t>(1, samples()));
    return visitSums(sums_, [](const auto& sums) { return sums.total(); }) / count;
  }
  /// A magnitude to set the next pass's unit by: the mean, unless single values tower above it.
  double magnitude() const { return std::max(mean(), common().largest() * 0x1p-19); }

  /// Of the same kind, level and unit.
  void add(const PatchStatistics& other) noexcept {
    for (std::size_t i = 0; i < eighths_.size(); ++i) {
      eighths_[i].fetch_add(other.eighths_[i].load(std::memory_order_relaxed),
                            std::memory_order_relaxed);
    }
    visitSums(sums_, [&](auto& sums) {
      sums.add(*std::get_if<std::decay_t<decltype(sums)>>(&other.sums_));
    });
  }
  void clear() noexcept {
    for (std::atomic<uint64_t>& count : eighths_) count.store(0, std::memory_order_relaxed);
    visitSums(sums_, [](auto& sums) { sums.clear(); });
  }
  void put(ByteWriter& writer) const {
    for (const uint64_t count : eighths()) writer.putPacked(count);
    visitSums(sums_, [&](const auto& sums) { sums.put(writer); });
  }
  /// Of the same kind, level and unit.
  void get(ByteReader& reader) {
    for (std::atomic<uint64_t>& count : eighths_) count.store(reader.getPacked());
    visitSums(sums_, [&](auto& sums) { sums.get(reader); });
  }
  std::size_t bytes() const {
    return sizeof *this +
           visitSums(sums_, [](const auto& sums) { return sums.bytes() - sizeof sums; });
  }

 private:
  std::array<std::atomic<uint64_t>, SpatialTree::kEighths> eighths_{};
  std::variant<std::monostate, SquareValues, SquareStatistics, SquareSums> sums_;
};

}  // namespace awd
