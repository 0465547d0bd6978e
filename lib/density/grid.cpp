// SPDX-License-Identifier: Apache-2.0
#include "density/grid.h"

#include <algorithm>
#include <cmath>

#include "density/point.h"

namespace awd {

Ref<GridDensity> GridDensity::make(std::pmr::memory_resource* memory,
                                   const BasisLevel* const* levels, uint32_t dimensions,
                                   AWDSampler sampler, Coefficients coefficients, Scale scale) {
  return Ref<GridDensity>::adopt(awd::make<GridDensity>(memory, memory, levels, dimensions, sampler,
                                                        std::move(coefficients), scale));
}

GridDensity::GridDensity(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                         uint32_t dimensions, AWDSampler sampler, Coefficients coefficients,
                         Scale scale)
    : shape_(shapeOf(levels, dimensions)),
      order_(commonOrder(levels, dimensions)),
      coefficients_(std::move(coefficients)) {
  std::copy(levels, levels + dimensions, levels_);
  for (uint32_t a = 0; a < dimensions; ++a) strides_[a] = shape_.stride(a);
  if (scale == Scale::toIntegral) normalise();
  dropNegligible(coefficients_);
  if (sampler == AWD_SAMPLER_COMPONENT) {
    component_.emplace(levels_, shape_, coefficients_);
  } else {
    inverse_.emplace(memory, levels_, shape_, coefficients_);
  }
}

void GridDensity::destroy() noexcept {
  std::pmr::memory_resource* memory = coefficients_.get_allocator().resource();
  unmake(memory, this);
}

void GridDensity::normalise() {
  // By the largest first, so that neither sum nor quotient leaves the range of a double.
  const double largest = *std::max_element(coefficients_.begin(), coefficients_.end());
  for (double& c : coefficients_) c /= largest;
  const double whole = integral(levels_, shape_, coefficients_.data());
  for (double& c : coefficients_) c /= whole;
}

void GridDensity::pdf(std::size_t count, const double* points, double* pdfs) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    withOrder(order_, [&](auto order) {
      constexpr uint32_t d = dimensions;
      AxisValues at[d];
      for (std::size_t i = 0; i < count; ++i, points += d) {
        evaluatePoint<d, order>(levels_, points, at);
        pdfs[i] = contract<d, order>(coefficients_.data(), strides_, at);
      }
    });
  });
}

void GridDensity::sample(std::size_t count, const double* uniforms, double* points, double* pdfs,
                         uint32_t* components) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    if (inverse_) {
      inverse_->sample<d>(coefficients_, count, uniforms, points, pdfs);
      if (components) std::fill(components, components + count, AWD_INVALID_ID);
      return;
    }
    double* point = points;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t component = component_->choose(*uniforms++);
      for (uint32_t a = 0; a < d; ++a) {
        const std::size_t j = component / strides_[a] % shape_.count[a];
        *point++ = sampleComponent<double>(*levels_[a], static_cast<uint32_t>(j), *uniforms++);
      }
      if (components) components[i] = static_cast<uint32_t>(component);
    }
    if (pdfs) pdf(count, points, pdfs);
  });
}

void GridDensity::record(std::size_t count, const double* points, const double* pdfs,
                         const uint32_t* components, const double* values, AWDTarget target,
                         DensityStatistics& statistics) const {
  withDimensions(shape_.dimensions, [&](auto dimensions) {
    constexpr uint32_t d = dimensions;
    AxisValues at[d];
    Tally* tallies = statistics.tallies.data();
    for (std::size_t i = 0; i < count; ++i, points += d) {
      if (!components || !pdfs) evaluatePoint<d>(levels_, points, at);
      const double p = pdfs ? pdfs[i] : contract<d>(coefficients_.data(), strides_, at);
      const bool usable = p > 0.0 && std::isfinite(values[i]);
      statistics.sums.rejected += !usable;
      if (!(p > 0.0)) {  // never drawn from this density: f/p has no value
        ++statistics.sums.samples;
        continue;
      }
      const WeighedSample sample(usable ? values[i] : 0.0, p, target);
      statistics.sums.add(sample);
      if (statistics.normal.pattern) statistics.normal.add<d>(0, points, at, sample);
      if (components) {
        Tally& tally = tallies[components[i]];
        tally.value.add(sample.target.value, sample.target.exponent);
        tally.alive += static_cast<int64_t>(1.0 / Tally::kAliveUnit);
        continue;
      }
      const Scaled value = {sample.target.value * sample.inverse.value,
                            sample.target.exponent + sample.inverse.exponent};
      forEachAlive<d>(strides_, at,
                      [&](std::size_t j, double n) { tallies[j].add(value, sample.inverse, n); });
    }
  });
}

double GridDensity::mass(const double* lower, const double* upper) const {
  return boxIntegral(coefficients_.get_allocator().resource(), levels_, shape_,
                     coefficients_.data(), lower, upper);
}

std::size_t GridDensity::bytes() const {
  return sizeof *this + coefficients_.capacity() * sizeof(double) +
         (inverse_ ? inverse_->bytes() : 0) + (component_ ? component_->bytes() : 0);
}

}  // namespace awd
