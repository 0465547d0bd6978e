// SPDX-License-Identifier: Apache-2.0
// The one kind of exception that our code throws. lib/api turns it into a result and a message.
#pragma once

#include <exception>
#include <string>

#include "awd/types.h"

namespace awd {

class Error : public std::exception {
 public:
  Error(AWDResult code, std::string text) : code_(code), text_(std::move(text)) {}
  AWDResult code() const { return code_; }
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  AWDResult code_;
  std::string text_;
};

/// Throws an Error with a printf-formatted text: what was wrong, where, and what would be right.
[[noreturn, gnu::format(printf, 2, 3)]] void fail(AWDResult code, const char* format, ...);

/// What a host's text must not do to a message: begin a new line, or steer a terminal.
void makeOneLine(char* text) noexcept;

}  // namespace awd
