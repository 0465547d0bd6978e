// SPDX-License-Identifier: Apache-2.0
#include "density/passes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace awd {

namespace {

/// A variance below this share of the squared mean is not believed.
constexpr long double kLeastVariance = 1e-3L;

/// Sum of squared deviations of f/p over (m - 1), times m. Of a single sample its square, which is
/// more than the variance on average.
long double varianceTimesCount(const PassSums& sums) {
  if (sums.samples < 2) return sums.square.value();
  const auto m = static_cast<long double>(sums.samples);
  const long double mean = sums.mean.value() / m;
  const long double squares = sums.square.value() - mean * sums.mean.value();
  return std::max(squares, 0.0L) * m / (m - 1.0L);
}

}  // namespace

Passes::Passes(std::pmr::memory_resource* memory, AWDCombination combination)
    : combination_(combination), kept_(memory), last_(memory) {}

Passes::Passes(const Passes& other)
    : combination_(other.combination_),
      totals_(other.totals_),
      kept_(other.kept_, other.kept_.get_allocator()),
      last_(other.last_) {}

void Passes::finish(const PassSums& sums, const Model& p) {
  if (sums.samples == 0) return;
  if (combination_ == AWD_COMBINE_CROSS_VARIANCE) {
    last_ = lastPass(sums);
    kept_.push_back({p, sums.samples, last_.mean});
    if (kept_.size() > kKept) {
      kept_.erase(kept_.begin());
      last_.secondMoments.erase(last_.secondMoments.begin());
    }
  }
  totals_.samples += sums.samples;
  ++totals_.passes;
  totals_.sum += sums.mean.value();
  totals_.variance += varianceTimesCount(sums);
}

Passes::LastPass Passes::lastPass(const PassSums& present) const {
  LastPass last(kept_.get_allocator().resource());
  const auto m = static_cast<long double>(present.samples);
  last.samples = present.samples;
  last.mean = present.mean.value() / m;
  for (const BinnedSum& cross : present.cross) last.secondMoments.push_back(cross.value() / m);
  last.secondMoments.push_back(present.square.value() / m);
  return last;
}

Estimate Passes::byCrossVariance(const PassSums& present) const {
  const LastPass last = present.samples > 0 ? lastPass(present) : last_;
  // Of a single sample the square stands for the variance, as above.
  const long double squaredMean = last.samples > 1 ? last.mean * last.mean : 0.0L;
  Estimate all;
  long double weights = 0.0L, sum = 0.0L, errors = 0.0L;
  for (std::size_t k = 0; k < last.secondMoments.size(); ++k) {
    const bool isPresent = k == kept_.size();
    const uint64_t samples = isPresent ? present.samples : kept_[k].samples;
    const long double variance = std::max(last.secondMoments[k] - squaredMean, 0.0L);
    const long double believed = std::max(variance, kLeastVariance * squaredMean);
    const long double weight =
        static_cast<long double>(samples) / (believed > 0.0L ? believed : 1.0L);
    weights += weight;
    sum += weight * (isPresent ? last.mean : kept_[k].mean);
    errors += weight * weight * variance / static_cast<long double>(samples);
    all.samples += samples;
    ++all.passes;
  }
  all.integral = static_cast<double>(sum / weights);
  all.standardError = static_cast<double>(std::sqrt(errors) / weights);
  return all;
}

Estimate Passes::estimate(const PassSums& present) const {
  if (totals_.samples + present.samples == 0) return {};
  Estimate all;
  if (combination_ == AWD_COMBINE_CROSS_VARIANCE) {
    all = byCrossVariance(present);
  } else {
    all.samples = totals_.samples + present.samples;
    all.passes = totals_.passes + (present.samples > 0);
    const auto m = static_cast<long double>(all.samples);
    all.integral = static_cast<double>((totals_.sum + present.mean.value()) / m);
    all.standardError =
        static_cast<double>(std::sqrt(totals_.variance + varianceTimesCount(present)) / m);
  }
  if (all.samples < 2) all.standardError = std::numeric_limits<double>::infinity();
  return all;
}

std::size_t Passes::bytes() const {
  std::size_t bytes = kept_.capacity() * sizeof(Pass);
  for (const Pass& pass : kept_) bytes += pass.p.bytes();
  return bytes;
}

void Passes::load(const Totals& totals, std::pmr::vector<Pass> kept, LastPass last) {
  totals_ = totals;
  kept_ = std::move(kept);
  last_ = std::move(last);
}

}  // namespace awd
