// SPDX-License-Identifier: Apache-2.0
// The library's progress as a line on the terminal, and Ctrl-C as its cancellation.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "awd/awd.h"

namespace command {

class ProgressBar {
 public:
  /// passes: how many there will be; 0: not known.
  void setPassCount(std::size_t passes) { passes_ = passes; }

  /// From now on Ctrl-C cancels nothing more: what was rendered is to be written. (A second one
  /// ends the program.)
  void letFinish() { finishing_ = true; }

  /// For awd::DeviceDesc::setProgress().
  bool operator()(const AWDProgress& progress);

  /// Follows the operation; the line to be shown for it.
  std::string line(const AWDProgress& progress);

 private:
  std::size_t passes_ = 0, pass_ = 0;
  double lastFraction_ = 1.0;
  bool finishing_ = false;
  std::chrono::steady_clock::time_point shown_{};
};

}  // namespace command
