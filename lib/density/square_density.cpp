// SPDX-License-Identifier: Apache-2.0
#include "density/square_density.h"

#include <algorithm>

#include "density/axis.h"

namespace awd {

namespace {

/// Components of less than this share are not drawn: their pdf as a float might be 0.
constexpr double kLeastDrawn = 1e-20;
bool isDrawn(double coefficient) { return coefficient >= kLeastDrawn; }

}  // namespace

SquareDensity::SquareDensity(std::pmr::memory_resource* memory, const BasisLevel& level,
                             AWDSampler sampler)
    // The functions sum to 1, so that coefficients 1 are the constant 1.
    : SquareDensity(level, sampler,
                    std::pmr::vector<double>(std::size_t{level.count} * level.count, 1.0, memory)) {
}

SquareDensity::SquareDensity(const BasisLevel& level, AWDSampler sampler,
                             std::pmr::vector<double> coefficients, Scale scale)
    : level_(&level),
      coefficients_(std::move(coefficients)),
      nodal_(coefficients_.get_allocator()),
      cumulative_(coefficients_.get_allocator()) {
  if (scale == Scale::toIntegral) normalise();
  if (sampler == AWD_SAMPLER_COMPONENT) {
    accumulate();
    return;
  }
  // The integral is 1: coefficients that are all the same are 1, but for rounding.
  constant_ = std::all_of(coefficients_.begin(), coefficients_.end(),
                          [&](double coefficient) { return coefficient == coefficients_[0]; });
  if (constant_) return;
  if (NodalSquare::fits(level)) {
    nodal_ = NodalSquare::tables(level, coefficients_);
  } else {
    inverse_.emplace(*level_, coefficients_);
  }
}

Ref<SquareDensity> SquareDensity::make(const BasisLevel& level, AWDSampler sampler,
                                       std::pmr::vector<double> coefficients, Scale scale) {
  std::pmr::memory_resource* memory = coefficients.get_allocator().resource();
  return Ref<SquareDensity>::adopt(
      awd::make<SquareDensity>(memory, level, sampler, std::move(coefficients), scale));
}

void SquareDensity::destroy() noexcept {
  std::pmr::memory_resource* memory = coefficients_.get_allocator().resource();
  unmake(memory, this);
}

void SquareDensity::normalise() {
  const uint32_t n = level_->count;
  // Scaled by the largest first, so that neither sum nor quotient leaves the range of a double.
  const double largest = *std::max_element(coefficients_.begin(), coefficients_.end());
  double sum = 0.0;
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    coefficients_[i] /= largest;
    sum += coefficients_[i] * level_->weights[i / n] * level_->weights[i % n];
  }
  for (double& c : coefficients_) c /= sum;
}

void SquareDensity::accumulate() {
  const uint32_t n = level_->count;
  cumulative_.resize(coefficients_.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    if (isDrawn(coefficients_[i])) {
      sum += coefficients_[i] * level_->weights[i / n] * level_->weights[i % n];
    }
    cumulative_[i] = sum;
  }
  for (double& upTo : cumulative_) upTo /= sum;
  // No uniform may fall beyond the last component that can be drawn.
  for (std::size_t i = cumulative_.size(); i-- > 0;) {
    cumulative_[i] = 1.0;
    if (isDrawn(coefficients_[i])) break;
  }
}

double SquareDensity::pdf(float u, float v) const {
  if (constant_) return 1.0;
  if (!nodal_.empty()) return static_cast<double>(nodal().pdf(u, v));
  if (inverse_) return inverse_->pdf(u, v);
  const uint32_t n = level_->count;
  if (level_->order == 1 && level_->alive == 1) {
    const uint32_t* functions = level_->functions.data();
    return coefficients_[std::size_t{functions[cellOf(*level_, u)]} * n +
                         functions[cellOf(*level_, v)]];
  }
  AxisValues alongU, alongV;
  evaluateAxis(*level_, u, alongU);
  evaluateAxis(*level_, v, alongV);
  double sum = 0.0;
  for (uint32_t a = 0; a < alongU.count; ++a) {
    const double* row = &coefficients_[std::size_t{alongU.function[a]} * n];
    double rowSum = 0.0;
    for (uint32_t b = 0; b < alongV.count; ++b) rowSum += row[alongV.function[b]] * alongV.value[b];
    sum += alongU.value[a] * rowSum;
  }
  return sum;
}

SquareSample SquareDensity::sample(const double uniforms[3]) const {
  if (constant_) {
    constexpr float kMost = 1.0f - 0x1p-24f;
    return {std::min(static_cast<float>(uniforms[0]), kMost),
            std::min(static_cast<float>(uniforms[1]), kMost), AWD_INVALID_ID, 1.0};
  }
  if (!nodal_.empty()) {
    const NodalSquare::Sample drawn = nodal().sample(uniforms[0], uniforms[1]);
    return {drawn.u, drawn.v, AWD_INVALID_ID, static_cast<double>(drawn.pdf)};
  }
  if (!inverse_) return sampleByComponent(uniforms);
  const SquareSampler::Sample drawn = inverse_->sample(uniforms[0], uniforms[1]);
  return {drawn.u, drawn.v, AWD_INVALID_ID, drawn.pdf};
}

SquareSample SquareDensity::sampleByComponent(const double uniforms[3]) const {
  const auto chosen = std::upper_bound(cumulative_.begin(), cumulative_.end(), uniforms[0]);
  const auto component = static_cast<uint32_t>(
      std::min<std::size_t>(chosen - cumulative_.begin(), cumulative_.size() - 1));
  SquareSample sample;
  sample.component = component;
  sample.u = sampleComponent<float>(*level_, component / level_->count, uniforms[1]);
  sample.v = sampleComponent<float>(*level_, component % level_->count, uniforms[2]);
  sample.pdf = pdf(sample.u, sample.v);
  return sample;
}

std::size_t SquareDensity::bytes() const {
  return sizeof *this + (coefficients_.size() + cumulative_.size()) * sizeof(double) +
         nodal_.size() * sizeof(float) + (inverse_ ? inverse_->bytes() : 0);
}

}  // namespace awd
