// SPDX-License-Identifier: Apache-2.0
// A device whose memory is bounded and counted, and whose long operations are cancelled: inputs may
// ask for more work than a fuzzer has time for.
#pragma once

#include <cstddef>
#include <limits>

#include "awd/awd.h"

namespace fuzz {

class BoundedDevice {
 public:
  /// One for the whole process: modules are loaded and tested but once.
  static BoundedDevice& shared();

  AWDDevice get() const { return device_; }
  /// From now on no more than so much beyond what is held, and so many calls of progress.
  void allow(std::size_t bytes, long steps);
  void allowAll() { allow(~std::size_t{0}, kAnySteps); }
  std::size_t held() const { return held_; }

  BoundedDevice(const BoundedDevice&) = delete;
  BoundedDevice& operator=(const BoundedDevice&) = delete;

 private:
  static constexpr long kAnySteps = std::numeric_limits<long>::max();

  BoundedDevice();
  ~BoundedDevice() = default;  // of the process

  AWDDevice device_ = nullptr;
  std::size_t held_ = 0, most_ = ~std::size_t{0};
  long steps_ = kAnySteps;
};

/// Within its life the shared device has bounds; at its end everything has been given back.
class Bounds {
 public:
  explicit Bounds(std::size_t bytes = std::size_t{64} << 20, long steps = 1000);
  ~Bounds();
  Bounds(const Bounds&) = delete;
  Bounds& operator=(const Bounds&) = delete;
  AWDDevice device() const { return BoundedDevice::shared().get(); }

 private:
  std::size_t before_;
};

}  // namespace fuzz
