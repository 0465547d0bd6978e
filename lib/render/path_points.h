// SPDX-License-Identifier: Apache-2.0
// The numbers that one camera path is made of: independent ones, and for its first vertices pairs
// that are stratified over all samples of the pixel.
#pragma once

#include "util/random.h"
#include "util/sobol.h"

namespace awd {

class PathPoints {
 public:
  /// Pairs are stratified if `sobol`; index: of the sample among all of its pixel, in every pass.
  /// Those of even and those of odd index are independent sequences.
  PathPoints(uint64_t seed, uint64_t pass, uint64_t pixel, uint64_t sample, bool sobol,
             uint32_t index)
      : independent_(seed, pass, pixel, sample),
        key_(mixBits(mixBits(seed + kPixel) ^ mixBits(2 * pixel + index % 2 + 2 * kPixel))),
        index_(index / 2),
        sobol_(sobol) {}

  double next() { return independent_.next(); }
  SobolPoint pixel() { return pair(0); }
  /// For a vertex of the path, from 1 on: which light, and whether to go on; where on the light;
  /// where to.
  SobolPoint choices(std::size_t vertex) { return vertex == 1 ? pair(1) : independentPair(); }
  SobolPoint light(std::size_t vertex) { return ofVertex(vertex, 2); }
  SobolPoint direction(std::size_t vertex) { return ofVertex(vertex, 3); }

 private:
  static constexpr uint64_t kPixel = 0xd1342543de82ef95u;
  static constexpr uint64_t kPair = 0x9e3779b97f4a7c15u;
  /// Later ones vary too much with what came before for strata to help.
  static constexpr std::size_t kVertices = 2;

  SobolPoint independentPair() {
    const double x = next();
    return {x, next()};
  }
  SobolPoint ofVertex(std::size_t vertex, uint32_t which) {
    if (vertex > kVertices) return independentPair();
    return pair(which + 2 * static_cast<uint32_t>(vertex - 1));
  }
  SobolPoint pair(uint32_t which) {
    if (!sobol_) return independentPair();
    const uint64_t seeds = mixBits(key_ + which * kPair);
    return sobolPoint(index_, static_cast<uint32_t>(mixBits(seeds)), static_cast<uint32_t>(seeds),
                      static_cast<uint32_t>(seeds >> 32));
  }

  RandomStream independent_;
  uint64_t key_;
  uint32_t index_;
  bool sobol_;
};

}  // namespace awd
