// SPDX-License-Identifier: Apache-2.0
#include "density/tensor.h"

#include "basis/bernstein.h"
#include "density/axis.h"

namespace awd {

namespace {

/// Walks all elements with the product of their weights.
template <class Visit>
void forEachWeight(const BasisLevel* const* levels, const Shape& shape, Visit&& visit) {
  const uint32_t last = shape.dimensions - 1;
  const std::size_t rows = shape.product(0, last);
  std::size_t i = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    double outer = 1.0;
    std::size_t rest = row;
    for (uint32_t a = last; a-- > 0; rest /= shape.count[a]) {
      outer *= levels[a]->weights[rest % shape.count[a]];
    }
    for (uint32_t j = 0; j < shape.count[last]; ++j) visit(i++, outer * levels[last]->weights[j]);
  }
}

/// int_0^x N_j for every function of a level.
Coefficients antiderivatives(std::pmr::memory_resource* memory, const BasisLevel& level, double x) {
  Coefficients values(level.count, 0.0, memory);
  const uint32_t last = cellOf(level, x);
  for (uint32_t cell = 0; cell <= last; ++cell) {
    const double t = cell < last ? 1.0 : x * level.cells - last;
    for (uint32_t k = 0; k < level.alive; ++k) {
      const std::size_t row = std::size_t{cell} * level.alive + k;
      values[level.functions[row]] +=
          bernsteinIntegral(&level.pieces[row * level.order], level.order, t) / level.cells;
    }
  }
  return values;
}

}  // namespace

void dropNegligible(Coefficients& coefficients) {
  for (double& c : coefficients) {
    if (c < 1e-100) c = 0.0;
  }
}

Coefficients refineAlong(const BasisLevel& coarse, const BasisLevel& fine, uint32_t axis,
                         Shape& shape, const Coefficients& coefficients) {
  const std::size_t n = shape.count[axis];
  const std::size_t m = fine.count;
  const std::size_t stride = shape.stride(axis);
  Coefficients out(coefficients.size() / n * m, 0.0, coefficients.get_allocator());
  shape.forEachFibre(axis, [&](std::size_t outer, std::size_t inner) {
    const double* from = &coefficients[outer * n * stride + inner];
    double* to = &out[outer * m * stride + inner];
    for (std::size_t j = 0; j < n; ++j) {
      for (uint32_t i = coarse.twoScaleBegin[j]; i < coarse.twoScaleBegin[j + 1]; ++i) {
        to[coarse.twoScale[i].fine * stride] += coarse.twoScale[i].value * from[j * stride];
      }
    }
  });
  shape.count[axis] = fine.count;
  return out;
}

Coefficients restrictAlong(const BasisLevel& coarse, uint32_t axis, Shape& shape,
                           const Coefficients& sums) {
  const std::size_t m = shape.count[axis];
  const std::size_t n = coarse.count;
  const std::size_t stride = shape.stride(axis);
  Coefficients out(sums.size() / m * n, 0.0, sums.get_allocator());
  shape.forEachFibre(axis, [&](std::size_t outer, std::size_t inner) {
    const double* from = &sums[outer * m * stride + inner];
    double* to = &out[outer * n * stride + inner];
    for (std::size_t j = 0; j < n; ++j) {
      double sum = 0.0;
      for (uint32_t i = coarse.twoScaleBegin[j]; i < coarse.twoScaleBegin[j + 1]; ++i) {
        sum += coarse.twoScale[i].value * from[coarse.twoScale[i].fine * stride];
      }
      to[j * stride] = sum;
    }
  });
  shape.count[axis] = coarse.count;
  return out;
}

void solveAlong(const GramSolver& gram, uint32_t axis, const Shape& shape, Coefficients& b) {
  const std::size_t stride = shape.stride(axis);
  const std::size_t outers = shape.product(0, axis);
  for (std::size_t outer = 0; outer < outers; ++outer) {
    gram.solve(&b[outer * shape.count[axis] * stride], stride, 1, stride);
  }
}

void timesWeights(const BasisLevel* const* levels, const Shape& shape, Coefficients& values) {
  forEachWeight(levels, shape, [&](std::size_t i, double weight) { values[i] *= weight; });
}

void overWeights(const BasisLevel* const* levels, const Shape& shape, Coefficients& values) {
  forEachWeight(levels, shape, [&](std::size_t i, double weight) { values[i] /= weight; });
}

double integral(const BasisLevel* const* levels, const Shape& shape, const double* coefficients) {
  // Wider than the terms: a sum of a million of them is to be right to their last bits.
  long double sum = 0.0L;
  forEachWeight(levels, shape, [&](std::size_t i, double weight) {
    sum += static_cast<long double>(coefficients[i]) * weight;
  });
  return static_cast<double>(sum);
}

double boxIntegral(std::pmr::memory_resource* memory, const BasisLevel* const* levels,
                   const Shape& shape, const double* coefficients, const double* lower,
                   const double* upper) {
  // One axis after the other, the last first.
  Coefficients rest(coefficients, coefficients + shape.size(), memory);
  for (uint32_t a = shape.dimensions; a-- > 0;) {
    const Coefficients below = antiderivatives(memory, *levels[a], lower[a]);
    const Coefficients above = antiderivatives(memory, *levels[a], upper[a]);
    const std::size_t n = shape.count[a];
    for (std::size_t row = 0; row < rest.size() / n; ++row) {
      long double sum = 0.0L;
      for (std::size_t j = 0; j < n; ++j) {
        sum += static_cast<long double>(rest[row * n + j]) * (above[j] - below[j]);
      }
      rest[row] = static_cast<double>(sum);
    }
    rest.resize(rest.size() / n);
  }
  return rest[0];
}

Shape shapeOf(const BasisLevel* const* levels, uint32_t dimensions) {
  Shape shape;
  shape.dimensions = dimensions;
  for (uint32_t a = 0; a < dimensions; ++a) shape.count[a] = levels[a]->count;
  return shape;
}

}  // namespace awd
