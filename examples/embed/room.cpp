// SPDX-License-Identifier: Apache-2.0
#include "room.h"

namespace host {
namespace {

constexpr float kWalls = 0.05f, kSky = 40.0f;
// The window lies in the wall x = 1.
constexpr float kLeft = 0.4f, kRight = 0.55f, kSill = 0.6f, kTop = 0.8f;

}  // namespace

float incoming(const Vec& position, const Vec& direction) {
  if (direction[0] <= 0.0f) return kWalls;
  const float t = (1.0f - position[0]) / direction[0];
  const float y = position[1] + t * direction[1], z = t * direction[2];
  return y > kLeft && y < kRight && z > kSill && z < kTop ? kSky : kWalls;
}

double exactReflected(const Vec& position) {
  // Over the window: cos(theta) d omega = (z/r) (dx/r) / r^2 dA, dx the distance from the wall.
  constexpr int kCells = 64;
  double window = 0.0;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const double y = kLeft + (i + 0.5) / kCells * (kRight - kLeft) - position[1];
      const double z = kSill + (j + 0.5) / kCells * (kTop - kSill);
      const double x = 1.0 - position[0], square = x * x + y * y + z * z;
      window += x * z / (square * square);
    }
  }
  window *= (kRight - kLeft) * (kTop - kSill) / (kCells * kCells);
  return kAlbedo / kPi * (kWalls * kPi + (kSky - kWalls) * window);
}

}  // namespace host
