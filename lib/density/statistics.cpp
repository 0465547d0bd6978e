// SPDX-License-Identifier: Apache-2.0
#include "density/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "util/error.h"

namespace awd {

namespace {

template <class Sum>
void addEach(std::pmr::vector<Sum>& to, const std::pmr::vector<Sum>& from) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i].add(from[i]);
}

}  // namespace

void BoxTally::add(const WeighedSample& sample) {
  weight.add(sample.inverse.value, sample.inverse.exponent);
  value.add(sample.target.value * sample.inverse.value,
            sample.target.exponent + sample.inverse.exponent);
  square.add(sample.target.value * sample.target.value * sample.inverse.value,
             2 * sample.target.exponent + sample.inverse.exponent);
}

void BoxTally::add(const BoxTally& other) {
  weight.add(other.weight);
  value.add(other.value);
  square.add(other.square);
}

void PassSums::addCross(std::size_t k, std::size_t count, const double* f, const double* p,
                        const double* theirs) {
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(f[i]) || !(p[i] > 0.0)) continue;
    // Where the earlier pass would never have looked its variance is as good as infinite.
    const double seen = std::max(theirs[i], std::numeric_limits<double>::min());
    const Scaled value = splitExponent(f[i]), own = splitExponent(p[i]),
                 other = splitExponent(seen);
    cross[k].add(value.value * value.value / (own.value * other.value),
                 2 * value.exponent - own.exponent - other.exponent);
  }
}

void PassSums::add(const PassSums& other) {
  samples += other.samples;
  rejected += other.rejected;
  mean.add(other.mean);
  square.add(other.square);
  addEach(cross, other.cross);
}

DensityStatistics::DensityStatistics(std::pmr::memory_resource* memory, std::size_t coefficients,
                                     std::size_t boxTallies, std::size_t earlierPasses,
                                     Ref<NormalPattern> pattern, std::size_t blocks)
    : sums(memory),
      tallies(coefficients, memory),
      boxes(boxTallies, memory),
      normal(memory, std::move(pattern), blocks) {
  sums.cross.resize(earlierPasses);
}

void DensityStatistics::needRoomFor(uint64_t samples) const {
  // Two values a sample go into one of the sums.
  constexpr uint64_t kMost = BinnedSum::kMostValues / 2;
  if (samples > kMost || sums.samples > kMost - samples) {
    fail(AWD_ERROR_INVALID_OPERATION,
         "%llu samples on top of %llu: at most %llu can be recorded in a pass; adapt first",
         static_cast<unsigned long long>(samples), static_cast<unsigned long long>(sums.samples),
         static_cast<unsigned long long>(kMost));
  }
}

void DensityStatistics::add(const DensityStatistics& other) {
  sums.add(other.sums);
  addEach(tallies, other.tallies);
  addEach(boxes, other.boxes);
  addEach(normal.products, other.normal.products);
  normal.energy.add(other.normal.energy);
}

bool DensityStatistics::sameSizes(const DensityStatistics& other) const {
  return tallies.size() == other.tallies.size() && boxes.size() == other.boxes.size() &&
         sums.cross.size() == other.sums.cross.size() &&
         normal.products.size() == other.normal.products.size();
}

std::size_t DensityStatistics::bytes() const {
  return sizeof *this + tallies.capacity() * sizeof(Tally) + boxes.capacity() * sizeof(BoxTally) +
         (sums.cross.capacity() + normal.products.capacity()) * sizeof(BinnedSum) +
         (normal.pattern ? normal.pattern->bytes() : 0);
}

}  // namespace awd
