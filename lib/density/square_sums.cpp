// SPDX-License-Identifier: Apache-2.0
#include "density/square_sums.h"

#include <algorithm>
#include <limits>
#include <new>

#include "density/point.h"

namespace awd {

namespace {

/// Of S0 and A: room for 2^31 samples of weight 1.
constexpr int kWeightExponent = -32;
constexpr double kWeightUnits = 0x1p32;
/// f^2/p is summed in units of 2^kEnergyShift times the square of those of f/p, in two limbs: as
/// wide a range as a sum of squares needs, with room for as many samples.
constexpr int kEnergyShift = 30;
constexpr double kEnergyScale = 0x1p-30;
constexpr double kLimb = 0x1p32;
/// 2^21 of the largest fit: all samples go into this one sum.
constexpr double kLargestEnergy = 0x1p42 * kLimb;
constexpr int64_t kAliveUnits = int64_t{1} << 30;
static_assert(kAliveUnits * Tally::kAliveUnit == 1.0);

/// Not negative; to the nearest. std::llrint is a call.
int64_t rounded(double units) {
  const double above = units + 0.5;
  return static_cast<int64_t>(above);
}

}  // namespace

SquareSums::SquareSums(std::pmr::memory_resource* memory, const BasisLevel& level,
                       Ref<NormalPattern> pattern, int unitExponent)
    : FixedSums(unitExponent),
      memory_(memory),
      levels_{&level, &level},
      pattern_(std::move(pattern)),
      components_(std::size_t{level.count} * level.count),
      order_(commonOrder(levels_, 2)),
      sums_(static_cast<Sum*>(memory->allocate(size() * sizeof(Sum), alignof(Sum)))) {
  for (std::size_t i = 0; i < size(); ++i) new (&sums_[i]) Sum(0);
}

SquareSums::~SquareSums() { memory_->deallocate(sums_, size() * sizeof(Sum), alignof(Sum)); }

void SquareSums::record(float u, float v, double p, double f) noexcept {
  const double inverse = 1.0 / p;
  const double weight = std::min(inverse, kLargestWeight);
  bool clamped = inverse > kLargestWeight;
  double value = 0.0;
  if (accept(f) && f > 0.0) {
    value = measure(std::min(f * weight, std::numeric_limits<double>::max()));
    clamped |= value > kLargestUnits;
    value = std::min(value, kLargestUnits);
  }
  if (pattern_ && value > 0.0) {
    const double energy = value * value / weight * kEnergyScale;
    clamped |= energy > kLargestEnergy;
    recordEnergy(std::min(energy, kLargestEnergy));
  }
  if (clamped) saturate();
  const double x[2] = {u, v};
  withOrder(order_, [&](auto order) { recordAlive<order>(x, value, weight * kWeightUnits); });
}

void SquareSums::recordEnergy(double units) noexcept {
  const double high = std::floor(units / kLimb);
  energy()[kLow].fetch_add(rounded(units - high * kLimb), kOrder);
  if (high > 0.0) accumulate(energy()[kHigh], rounded(high));
}

template <uint32_t order>
void SquareSums::recordAlive(const double x[2], double value, double weight) noexcept {
  AxisValues at[2];
  evaluatePoint<2, order>(levels_, x, at);
  const std::size_t strides[2] = {levels_[0]->count, 1};
  // The functions sum to 1: differences of rounded partial sums count the sample as exactly 1.
  double partial = 0.0;
  int64_t counted = 0;
  forEachAlive<2>(strides, at, [&](std::size_t j, double n) {
    partial += n;
    const int64_t alive = rounded(partial * static_cast<double>(kAliveUnits)) - counted;
    counted += alive;
    if (value > 0.0) accumulate(sum(j, kValue), rounded(value * n));
    accumulate(sum(j, kWeight), rounded(weight * n));
    sum(j, kAlive).fetch_add(alive, kOrder);
  });
  if (!pattern_) return;
  // Rounding would take a definite matrix apart where a sample is all that a function has: half a
  // unit for each of its pairs on the diagonal outweighs that, whatever was rounded (Gershgorin).
  const int64_t ridge = (int64_t{at[0].count} * at[1].count + 1) / 2;
  pattern_->forEachAlive<2>(x, at, [&](std::size_t entry, double product, bool diagonal) {
    products()[entry].fetch_add(rounded(weight * product) + (diagonal ? ridge : 0), kOrder);
  });
}

uint64_t SquareSums::samples() const {
  uint64_t alive = 0;
  for (std::size_t j = 0; j < components_; ++j) {
    alive += static_cast<uint64_t>(sum(j, kAlive).load(kOrder));
  }
  return alive / kAliveUnits;
}

double SquareSums::total() const {
  double total = 0.0;
  for (std::size_t j = 0; j < components_; ++j) {
    total += static_cast<double>(sum(j, kValue).load(kOrder));
  }
  return std::ldexp(total, unitExponent());
}

DensityStatistics SquareSums::statistics() const {
  const auto plain = [](const Sum& sum) { return static_cast<double>(sum.load(kOrder)); };
  DensityStatistics all(memory_, components_, 0, 0, pattern_);
  all.sums.samples = samples();
  all.sums.rejected = rejected();
  for (std::size_t j = 0; j < components_; ++j) {
    Tally& tally = all.tallies[j];
    tally.value.add(plain(sum(j, kValue)), unitExponent());
    tally.weight.add(plain(sum(j, kWeight)), kWeightExponent);
    tally.alive = sum(j, kAlive).load(kOrder);
  }
  if (!pattern_) return all;
  const int unit = 2 * unitExponent() + kEnergyShift;
  all.normal.energy.add(plain(energy()[kLow]), unit);
  all.normal.energy.add(plain(energy()[kHigh]) * kLimb, unit);
  for (std::size_t i = 0; i < all.normal.products.size(); ++i) {
    all.normal.products[i].add(plain(products()[i]), kWeightExponent);
  }
  return all;
}

void SquareSums::add(const SquareSums& other) noexcept {
  for (std::size_t i = 0; i < size(); ++i) accumulate(sums_[i], other.sums_[i].load(kOrder));
  addFlaws(other);
}

void SquareSums::clear() noexcept {
  for (std::size_t i = 0; i < size(); ++i) sums_[i].store(0, kOrder);
  clearFlaws();
}

}  // namespace awd
