// SPDX-License-Identifier: Apache-2.0
// What a host has of its own before libawd comes: vertices, pixels, and random numbers.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace host {

constexpr double kPi = 3.14159265358979323846;

using Vec = std::array<float, 3>;

struct Vertex {
  Vec position;
  Vec normal;
};

struct Pixel {
  float r = 0, g = 0, b = 0, alpha = 1;
};

struct Picture {
  Picture(uint32_t w, uint32_t h) : width(w), height(h), pixels(std::size_t{w} * h) {}
  uint32_t width, height;
  std::vector<Pixel> pixels;
};

/// Uniform in [0,1), a stream for each seed: splitmix64 (Steele, Lea and Flood 2014).
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed * 0xd1342543de82ef95u) {}
  double operator()() {
    uint64_t z = state_ += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return std::ldexp(static_cast<double>((z ^ (z >> 31)) >> 11), -53);
  }

 private:
  uint64_t state_;
};

}  // namespace host
