// SPDX-License-Identifier: Apache-2.0
#include "util/error.h"

#include <cstdarg>
#include <cstdio>

namespace awd {

void fail(AWDResult code, const char* format, ...) {
  char text[1024];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text, sizeof text, format, arguments);
  va_end(arguments);
  throw Error(code, text);
}

void makeOneLine(char* text) noexcept {
  for (; *text; ++text) {
    const auto c = static_cast<unsigned char>(*text);
    if (c < 0x20 || c == 0x7f) *text = '?';
  }
}

}  // namespace awd
