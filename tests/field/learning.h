// SPDX-License-Identifier: Apache-2.0
// A field that a test feeds with a function on the square.
#pragma once

#include <gtest/gtest.h>

#include "field/trained.h"

namespace awdtest {

constexpr uint32_t kPatch = 3;
constexpr double kNoFloor = -1.0;

/// A value of its own in each of 4 x 4 cells, of mean 1.
inline double steps(double u, double v) {
  const int cell = 4 * static_cast<int>(u * 4.0) + static_cast<int>(v * 4.0);
  return (1.0 + (7 * cell) % 16) / 8.5;
}

template <class Param>
class FedField : public testing::TestWithParam<Param> {
 protected:
  void begin(const AWDFieldDesc& desc) { field_ = newField(device_, &desc); }
  void record(size_t samples, Random& random,
              const std::function<double(double, double)>& function) {
    recordPass(field_, kPatch, samples, random, function);
  }
  Device device_ = newDevice(1u);
  Field field_;
};

class Learning : public FedField<AWDHemisphereMap> {
 protected:
  void begin(uint32_t startLevel, uint32_t maxLevel, double tau) {
    FedField::begin(fieldDesc(GetParam(), startLevel, maxLevel, tau));
  }
};

}  // namespace awdtest
