// SPDX-License-Identifier: Apache-2.0
// What a case of an extreme has found wrong, as a text.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

#include "support/extreme.h"

namespace awdtest {

/// Keeps the first complaint.
class Findings {
 public:
  [[gnu::format(printf, 3, 4)]] void expect(bool good, const char* format, ...) {
    if (good || !ok_) return;
    ok_ = false;
    std::va_list arguments;
    va_start(arguments, format);
    keep(format, arguments);
    va_end(arguments);
  }
  /// What to say if there is no complaint.
  [[gnu::format(printf, 2, 3)]] Outcome outcome(const char* format, ...) {
    if (ok_) {
      std::va_list arguments;
      va_start(arguments, format);
      keep(format, arguments);
      va_end(arguments);
    }
    return {ok_, text_};
  }

 private:
  void keep(const char* format, std::va_list arguments) {
    char text[400];
    std::vsnprintf(text, sizeof text, format, arguments);
    text_ = text;
  }
  bool ok_ = true;
  std::string text_;
};

}  // namespace awdtest
