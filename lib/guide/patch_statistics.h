// SPDX-License-Identifier: Apache-2.0
// What a patch learns during a pass: the sums that the field's estimator goes by, and where in the
// patch the samples lay.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <optional>
#include <variant>

#include "awd/field.h"
#include "density/square_statistics.h"
#include "density/square_sums.h"
#include "density/square_values.h"
#include "guide/light_sums.h"
#include "guide/spatial_tree.h"

namespace awd {

/// std::visit, but for a variant that always holds something.
template <class Variant, class Visit>
decltype(auto) visitSums(Variant& either, Visit&& visit) {
  if (auto* sums = std::get_if<SquareValues>(&either)) return visit(*sums);
  if (auto* sums = std::get_if<SquareStatistics>(&either)) return visit(*sums);
  return visit(*std::get_if<SquareSums>(&either));
}

/// The units that a patch's sums are made in, as exponents of two.
struct PatchUnits {
  int values;
  int lights;

  /// For values and light of this magnitude.
  static PatchUnits of(double magnitude) {
    return {FixedSums::unitExponentFor(magnitude), LightSums::unitExponentFor(magnitude)};
  }
  bool operator==(const PatchUnits& b) const { return values == b.values && lights == b.lights; }
};

class PatchStatistics {
 public:
  using Eighths = std::array<uint64_t, SpatialTree::kEighths>;

  /// pattern: null unless the estimator is `refit`.
  PatchStatistics(std::pmr::memory_resource* memory, const BasisLevel& level,
                  AWDEstimator estimator, AWDTarget target, Ref<NormalPattern> pattern,
                  uint32_t lights, PatchUnits units)
      : lights_(memory, lights, units.lights) {
    if (target == AWD_TARGET_RMS) means_.emplace(memory, 1, units.values);
    if (estimator == AWD_ESTIMATOR_LUMPED) {
      sums_.emplace<SquareValues>(memory, level, units.values);
    } else if (estimator == AWD_ESTIMATOR_PAPER) {
      sums_.emplace<SquareStatistics>(memory, std::size_t{level.count} * level.count, units.values);
    } else {
      sums_.emplace<SquareSums>(memory, level, std::move(pattern), units.values);
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
    if (means_) f = squareOf(sample, f);
    if (auto* sums = std::get_if<SquareStatistics>(&sums_)) {
      sums->record(sample.component, f);
      return;
    }
    const double p = pdfOnSquare(sample);
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

  /// What a shadow ray to that light brought.
  void recordLight(uint32_t light, double value) noexcept { lights_.record(light, value); }

  /// Null under another estimator than `lumped`, `paper`, or one of the others.
  const SquareValues* values() const { return std::get_if<SquareValues>(&sums_); }
  const SquareStatistics* byComponent() const { return std::get_if<SquareStatistics>(&sums_); }
  const SquareSums* byFunction() const { return std::get_if<SquareSums>(&sums_); }

  /// What wrong values there were, and in which unit they were summed.
  const FixedSums& common() const {
    return visitSums(sums_, [](const auto& sums) -> const FixedSums& { return sums; });
  }
  const LightSums& lights() const { return lights_; }
  PatchUnits units() const { return {common().unitExponent(), lights_.unitExponent()}; }
  /// For the next pass: that of the mean, unless single values tower above it.
  PatchUnits nextUnits() const {
    PatchUnits next = units();
    if (common().largest() > 0.0) next.values = FixedSums::unitExponentFor(magnitude());
    if (lights_.largest() > 0.0) next.lights = LightSums::unitExponentFor(lights_.magnitude());
    return next;
  }
  std::size_t components() const {
    return visitSums(sums_, [](const auto& sums) { return sums.components(); });
  }
  bool isEmpty() const { return samples() == 0 && lights_.samples() == 0; }
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
    const double total =
        means_ ? means_->total() : visitSums(sums_, [](const auto& sums) { return sums.total(); });
    return total / static_cast<double>(std::max<uint64_t>(1, samples()));
  }
  /// Whether something came, but less on average than the unit that it was summed in.
  bool isBelowUnit() const {
    return common().largest() > 0.0 && mean() < std::ldexp(1.0, common().unitExponent());
  }
  /// What the sums are of, if they are of squares: f^2 over this.
  double squaresUnit() const { return FixedSums::magnitudeFor(common().unitExponent()); }

  /// Of the same kind, level and units.
  void add(const PatchStatistics& other) noexcept {
    for (std::size_t i = 0; i < eighths_.size(); ++i) {
      eighths_[i].fetch_add(other.eighths_[i].load(std::memory_order_relaxed),
                            std::memory_order_relaxed);
    }
    visitSums(sums_, [&](auto& sums) {
      sums.add(*std::get_if<std::decay_t<decltype(sums)>>(&other.sums_));
    });
    if (means_) means_->add(*other.means_);
    lights_.add(other.lights_);
  }
  /// Shows all numbers to one who knows sums, counts, flaws and maxima apart.
  template <class Visitor>
  void visit(Visitor& visitor) {
    for (std::atomic<uint64_t>& count : eighths_) visitor.count(count);
    visitSums(sums_, [&](auto& sums) { sums.visit(visitor); });
    if (means_) means_->visit(visitor);
    lights_.visit(visitor);
  }
  void clear() noexcept {
    for (std::atomic<uint64_t>& count : eighths_) count.store(0, std::memory_order_relaxed);
    visitSums(sums_, [](auto& sums) { sums.clear(); });
    if (means_) means_->clear();
    lights_.clear();
  }
  void put(ByteWriter& writer) const {
    for (const uint64_t count : eighths()) writer.putPacked(count);
    visitSums(sums_, [&](const auto& sums) { sums.put(writer); });
    if (means_) means_->put(writer);
    lights_.put(writer);
  }
  /// Of the same kind, level and units.
  void get(ByteReader& reader) {
    for (std::atomic<uint64_t>& count : eighths_) count.store(reader.getPacked());
    visitSums(sums_, [&](auto& sums) { sums.get(reader); });
    if (means_) means_->get(reader);
    lights_.get(reader);
  }
  std::size_t bytes() const {
    return sizeof *this + lights_.bytes() + (means_ ? means_->bytes() - sizeof *means_ : 0) +
           visitSums(sums_, [](const auto& sums) { return sums.bytes() - sizeof sums; });
  }

 private:
  static double pdfOnSquare(const AWDDirectionSample& sample) {
    // Of -0, 0: else its inverse would be below all numbers.
    return static_cast<double>(sample.pdf) * static_cast<double>(sample.solidAngle) + 0.0;
  }
  double magnitude() const {
    const double largest = common().largest() * 0x1p-19;
    // Of squares in another unit it is the root.
    return std::max(mean(), means_ ? std::sqrt(largest * squaresUnit()) : largest);
  }
  /// f^2 in the magnitude of f; f itself counts to the mean.
  double squareOf(const AWDDirectionSample& sample, double f) noexcept {
    if (!(f >= 0.0 && std::isfinite(f))) return f;
    const double p = pdfOnSquare(sample);
    const bool paper = std::holds_alternative<SquareStatistics>(sums_);
    constexpr double kLargest = std::numeric_limits<double>::max();
    means_->record(0, std::min(paper ? f : f / p, kLargest));
    return std::min(f * (f / squaresUnit()), kLargest);
  }

  std::array<std::atomic<uint64_t>, SpatialTree::kEighths> eighths_{};
  std::variant<std::monostate, SquareValues, SquareStatistics, SquareSums> sums_;
  std::optional<SquareStatistics> means_;  ///< of f/p; none if the other sums are of f itself
  LightSums lights_;
};

}  // namespace awd
