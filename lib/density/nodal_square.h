// SPDX-License-Identifier: Apache-2.0
// The fast form of SquareSampler for hat functions on equal cells: the linear B-splines, that a
// field learns by default. Each coefficient is the density at a node of the grid, so that cells and
// functions need no tables; fixed numbers of cells let the compiler work on whole rows at once.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory_resource>
#include <vector>

#include "density/cell_search.h"

namespace awd {

struct BasisLevel;

/// A view of tables that it doesn't own.
class NodalSquare {
 public:
  struct Sample {
    float u, v;  ///< in (0,1)
    float pdf;   ///< bit-equal to what pdf() says
  };

  /// Whether the functions of a level are hats at the nodes i / cells, and the cells 2 to 32.
  static bool fits(const BasisLevel& level);
  /// The tables for coefficients, not negative, of a function of integral 1.
  static std::pmr::vector<float> tables(const BasisLevel& level,
                                        const std::pmr::vector<double>& coefficients);

  /// A cell, and the place in it, of a coordinate: both exact, as the cells are a power of two.
  struct Place {
    uint32_t cell;
    float t;
  };
  static Place placeOf(float x, uint32_t cells) {
    const float scaled = x * static_cast<float>(cells);
    const auto cell = std::min(static_cast<uint32_t>(scaled), cells - 1);
    return {cell, scaled - static_cast<float>(cell)};
  }

  NodalSquare() = default;
  NodalSquare(const float* tables, uint32_t cells) : tables_(tables), cells_(cells) {}
  const float* data() const { return tables_; }

  /// u from the marginal, then v given u, each from a uniform in [0,1) by the inverse CDF, which is
  /// monotone.
  Sample sample(double first, double second) const;
  float pdf(float u, float v) const;

  /// Brings the tables nearer, for a sample soon.
  void prefetch() const {
    const uint32_t size = cells_ + (cells_ + 1) * (cells_ + 2);
    constexpr uint32_t kLine = 16;
    constexpr uint32_t kMost = 16 * kLine;
    for (uint32_t i = 0; i < std::min(size, kMost); i += kLine) __builtin_prefetch(tables_ + i);
  }

 private:
  static float blend(float a, float b, float t) { return (1.0f - t) * a + t * b; }

  template <uint32_t kCells>
  static float draw(float uniform, const float* upTo, const float* nodes);
  template <uint32_t kCells>
  Sample sampleCells(float first, float second) const;

  /// kCells sums of the marginal over cells, as draw() wants them; its values at the nodes; then
  /// for each node along u those at the nodes along v.
  const float* tables_ = nullptr;
  uint32_t cells_ = 0;
};

/// The coordinate up to which the share `uniform` of the mass lies. upTo[i]: twice the integral of
/// the nodes' interpolant over the cells up to i, in cells.
template <uint32_t kCells>
float NodalSquare::draw(float uniform, const float* upTo, const float* nodes) {
  float target = uniform * upTo[kCells - 1];
  const uint32_t cell = countCells(kCells, target, [=](uint32_t i) { return upTo[i]; });
  const float before = cell > 0 ? upTo[cell - 1] : 0.0f;
  const float b0 = nodes[cell];
  const float b1 = nodes[cell + 1];
  // 2 int_0^t b0 + (b1 - b0) s ds = mass, solved without cancellation. t stays off the ends of the
  // cell by what is sure to survive the sum below: at a node the density may be 0.
  constexpr float kOffEnd = 0x1p-18f;
  const float mass = std::min(target - before, b0 + b1);
  const float root = std::sqrt(std::max(b0 * b0 + mass * (b1 - b0), 0.0f));
  const float t = mass / (b0 + root);
  const float inside = t > kOffEnd ? std::min(t, 1.0f - kOffEnd) : kOffEnd;  // nor NaN, of 0/0
  return (static_cast<float>(cell) + inside) * (1.0f / kCells);
}

template <uint32_t kCells>
NodalSquare::Sample NodalSquare::sampleCells(float first, float second) const {
  constexpr uint32_t kNodes = kCells + 1;
  const float* marginal = tables_ + kCells;
  Sample sample;
  sample.u = draw<kCells>(first, tables_, marginal);
  const Place u = placeOf(sample.u, kCells);
  const float* below = marginal + std::size_t{kNodes} * (u.cell + 1);
  const float* above = below + kNodes;
  float nodes[kNodes], upTo[kCells];
  for (uint32_t k = 0; k < kNodes; ++k) nodes[k] = blend(below[k], above[k], u.t);
  float sum = 0.0f;
  for (uint32_t i = 0; i < kCells; i += 2) {  // in twos: half as long a chain of sums
    const float one = nodes[i] + nodes[i + 1];
    const float other = nodes[i + 1] + nodes[i + 2];
    upTo[i] = sum + one;
    upTo[i + 1] = sum += one + other;
  }
  sample.v = draw<kCells>(second, upTo, nodes);
  const Place v = placeOf(sample.v, kCells);
  sample.pdf = blend(nodes[v.cell], nodes[v.cell + 1], v.t);
  return sample;
}

inline NodalSquare::Sample NodalSquare::sample(double first, double second) const {
  const auto a = static_cast<float>(first);
  const auto b = static_cast<float>(second);
  switch (cells_) {
    case 2:
      return sampleCells<2>(a, b);
    case 4:
      return sampleCells<4>(a, b);
    case 8:
      return sampleCells<8>(a, b);
    case 16:
      return sampleCells<16>(a, b);
    default:
      return sampleCells<32>(a, b);
  }
}

inline float NodalSquare::pdf(float u, float v) const {
  const Place x = placeOf(u, cells_);
  const Place y = placeOf(v, cells_);
  const std::size_t nodes = std::size_t{cells_} + 1;
  const float* below = tables_ + cells_ + nodes * (x.cell + 1) + y.cell;
  const float* above = below + nodes;
  return blend(blend(below[0], above[0], x.t), blend(below[1], above[1], x.t), y.t);
}

}  // namespace awd
