// SPDX-License-Identifier: Apache-2.0
#include "basis/check.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <utility>

namespace awd {

bool Check::fails(double figure) {
  if (std::isnan(figure)) figure = std::numeric_limits<double>::infinity();
  if (figure > worst_) worst_ = figure;
  if (figure <= limit_) return false;
  return std::exchange(ok_, false);
}

void Check::say(const char* format, ...) {
  char text[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  sentence_ = text;
}

void Check::broken(std::string sentence) {
  if (!std::exchange(ok_, false)) return;
  worst_ = std::numeric_limits<double>::infinity();
  sentence_ = std::move(sentence);
}

}  // namespace awd
