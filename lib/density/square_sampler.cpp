// SPDX-License-Identifier: Apache-2.0
#include "density/square_sampler.h"

#include "density/cell_search.h"
#include "density/point.h"

namespace awd {

namespace {

/// What floats can't square is as good as nothing: no cell has a mass whose density is 0.
constexpr double kLeastSquarable = 1e-30;

/// int of a function over a cell, times their number: the mean of its Bernstein coefficients.
template <uint32_t O>
float pieceMean(const BasisLevel& level, std::size_t row) {
  const uint32_t order = O > 0 ? O : level.order;
  double sum = 0.0;
  for (uint32_t k = 0; k < order; ++k) sum += level.pieces[row * order + k];
  return static_cast<float>(sum / order);
}

/// Sums of masses up to the end of each cell, of the density with these coefficients along an axis.
template <uint32_t O, class Coefficient>
void accumulate(const BasisLevel& level, bool bernstein, const Coefficient& coefficient,
                float* upTo) {
  const uint32_t alive = O > 0 ? O : level.alive;
  const float size = 1.0f / static_cast<float>(level.cells);
  const uint32_t* functions = level.functions.data();
  float sum = 0.0f;
  std::size_t row = 0;
  for (uint32_t cell = 0; cell < level.cells; ++cell) {
    float mass = 0.0f;
    for (uint32_t k = 0; k < alive; ++k, ++row) {
      const float mean = bernstein ? 1.0f / static_cast<float>(alive) : pieceMean<O>(level, row);
      mass += coefficient(functions[row]) * mean;
    }
    upTo[cell] = sum += mass * size;
  }
}

}  // namespace

SquareSampler::SquareSampler(const BasisLevel& level, const std::pmr::vector<double>& coefficients)
    : level_(&level), bernstein_(hasBernsteinPieces(level)), tables_(coefficients.get_allocator()) {
  const BasisLevel* const levels[] = {&level, &level};
  order_ = commonOrder(levels, 2);
  const std::size_t n = level.count;
  const std::size_t cells = level.cells;
  tables_.resize(cells + n + n * n + (summed() ? 0 : n * cells));
  float* marginals = tables_.data() + cells;
  float* rows = marginals + n;
  for (std::size_t i = 0; i < n * n; ++i) {
    rows[i] = coefficients[i] < kLeastSquarable ? 0.0f : static_cast<float>(coefficients[i]);
  }
  for (std::size_t j = 0; j < n; ++j) {
    double mass = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      mass += static_cast<double>(rows[j * n + k]) * level.weights[k];
    }
    marginals[j] = static_cast<float>(mass);
    if (summed()) continue;
    accumulate<0>(
        level, bernstein_, [&](uint32_t k) { return rows[j * n + k]; }, rows + n * n + j * cells);
  }
  accumulate<0>(
      level, bernstein_, [&](uint32_t k) { return marginals[k]; }, tables_.data());
}

void SquareSampler::prefetch() const {
  constexpr std::size_t kLine = 64;
  constexpr std::size_t kMost = 16 * kLine;
  const auto* at = reinterpret_cast<const char*>(tables_.data());
  const std::size_t size = std::min(tables_.size() * sizeof(float), kMost);
  for (std::size_t i = 0; i < size; i += kLine) __builtin_prefetch(at + i);
}

template <uint32_t O>
void SquareSampler::evaluate(float x, AxisValues& at) const {
  const uint32_t cell = cellOf(*level_, static_cast<double>(x));
  const double t = static_cast<double>(x) * level_->cells - cell;
  if constexpr (O > 0) {
    if (!bernstein_) return evaluateCell<O, O>(*level_, cell, t, at);
    at.count = O;
    for (uint32_t k = 0; k < O; ++k) at.function[k] = level_->functions[std::size_t{cell} * O + k];
    bernsteinPolynomials<O>(t, at.value);
  } else {
    evaluateAxis(*level_, static_cast<double>(x), at);
  }
}

template <uint32_t O, class MassUpTo, class Coefficient>
float SquareSampler::draw(double uniform, const MassUpTo& massUpTo,
                          const Coefficient& coefficient) const {
  const uint32_t order = O > 0 ? O : level_->order;
  const uint32_t alive = O > 0 ? O : level_->alive;
  const uint32_t cells = level_->cells;
  float target = static_cast<float>(uniform) * massUpTo(cells - 1);
  const uint32_t cell = summed() ? countCells(cells, target, massUpTo)
                                 : findCell(cells, powerBelow(cells), target, massUpTo);
  const float before = cell > 0 ? massUpTo(cell - 1) : 0.0f;
  double t = static_cast<double>(target - before) / static_cast<double>(massUpTo(cell) - before);
  if (order > 1) {
    double b[O > 0 ? O : AWD_BASIS_MAX_ORDER] = {0.0};
    const uint32_t* functions = &level_->functions[std::size_t{cell} * alive];
    const double* piece = &level_->pieces[std::size_t{cell} * alive * order];
    for (uint32_t k = 0; k < alive; ++k, piece += order) {
      const auto c = static_cast<double>(coefficient(functions[k]));
      if (O > 0 && bernstein_) {
        b[k] = c;
      } else {
        for (uint32_t o = 0; o < order; ++o) b[o] += c * piece[o];
      }
    }
    if constexpr (O == 2) {
      t = invertLinearCdf(b[0], b[1], std::max(t, kLeastUniform));
    } else {
      t = invertPolynomialCdf(b, order, t);
    }
  }
  return clampIntoCell<float>(*level_, cell, (cell + t) / cells);
}

template <uint32_t O>
float SquareSampler::blended(const AxisValues& alongU, uint32_t function) const {
  float sum = 0.0f;
  const uint32_t count = O > 0 ? O : alongU.count;
  for (uint32_t a = 0; a < count; ++a) {
    sum += static_cast<float>(alongU.value[a]) * row(alongU.function[a])[function];
  }
  return sum;
}

template <uint32_t O>
double SquareSampler::value(const AxisValues& alongU, const AxisValues& alongV) const {
  double sum = 0.0;
  const uint32_t count = O > 0 ? O : alongV.count;
  for (uint32_t b = 0; b < count; ++b) {
    sum += alongV.value[b] * static_cast<double>(blended<O>(alongU, alongV.function[b]));
  }
  return sum;
}

template <uint32_t O>
float SquareSampler::drawAlongV(double uniform, const AxisValues& alongU) const {
  const auto coefficient = [&](uint32_t j) { return blended<O>(alongU, j); };
  if (summed()) {
    float upTo[kMostSummed];
    accumulate<O>(*level_, bernstein_, coefficient, upTo);
    return draw<O>(
        uniform, [&](uint32_t i) { return upTo[i]; }, coefficient);
  }
  const auto massUpTo = [&](uint32_t i) {
    float mass = 0.0f;
    for (uint32_t a = 0; a < alongU.count; ++a) {
      mass += static_cast<float>(alongU.value[a]) * rowPrefix(alongU.function[a])[i];
    }
    return mass;
  };
  return draw<O>(uniform, massUpTo, coefficient);
}

SquareSampler::Sample SquareSampler::sample(double first, double second) const {
  return withOrder(order_, [&](auto constant) {
    constexpr uint32_t O = constant;
    const float* upTo = prefix();
    const float* c = marginal();
    Sample sample;
    sample.u = draw<O>(
        first, [=](uint32_t i) { return upTo[i]; }, [=](uint32_t j) { return c[j]; });
    AxisValues alongU, alongV;
    evaluate<O>(sample.u, alongU);
    sample.v = drawAlongV<O>(second, alongU);
    evaluate<O>(sample.v, alongV);
    sample.pdf = value<O>(alongU, alongV);
    return sample;
  });
}

double SquareSampler::pdf(float u, float v) const {
  return withOrder(order_, [&](auto constant) {
    constexpr uint32_t O = constant;
    AxisValues alongU, alongV;
    evaluate<O>(u, alongU);
    evaluate<O>(v, alongV);
    return value<O>(alongU, alongV);
  });
}

}  // namespace awd
