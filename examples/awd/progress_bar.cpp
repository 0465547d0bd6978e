// SPDX-License-Identifier: Apache-2.0
#include "progress_bar.h"

#include <cmath>

#include "console.h"
#include "interrupt.h"

namespace command {

std::string ProgressBar::line(const AWDProgress& progress) {
  std::string operation = progress.operation;
  if (operation == "pass") {
    // Within a pass the fraction never falls.
    if (progress.fraction < lastFraction_) ++pass_;
    lastFraction_ = progress.fraction;
    operation += ' ' + std::to_string(pass_);
    if (passes_) operation += '/' + std::to_string(passes_);
  } else {
    lastFraction_ = 1.0;
  }
  constexpr std::size_t kWidth = 40;
  const std::size_t full = static_cast<std::size_t>(progress.fraction * kWidth);
  const int percent = static_cast<int>(std::floor(100.0 * progress.fraction));
  return '[' + std::string(full, '#') + std::string(kWidth - full, ' ') + "] " +
         std::to_string(percent) + " % " + operation;
}

bool ProgressBar::operator()(const AWDProgress& progress) {
  if (hasTerminal()) {
    const std::string text = line(progress);
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ > std::chrono::milliseconds(100)) {
      shown_ = now;
      showStatus(text);
    }
  }
  return finishing_ || !wasInterrupted();
}

}  // namespace command
