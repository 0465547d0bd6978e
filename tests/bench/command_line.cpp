// SPDX-License-Identifier: Apache-2.0
#include "command_line.h"

#include <cctype>

namespace bench {
namespace {

std::string line = "awd-bench";

std::string quoted(const std::string& word) {
  bool plain = !word.empty();
  for (const char c : word) {
    const bool safe = std::isalnum(static_cast<unsigned char>(c)) != 0;
    plain = plain && (safe || std::string("-_./,:=+@%").find(c) != std::string::npos);
  }
  if (plain) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

}  // namespace

void setCommandLine(int argumentCount, const char* const* arguments) {
  line = "awd-bench";
  for (int i = 1; i < argumentCount; ++i) line += " " + quoted(arguments[i]);
}

const std::string& commandLine() { return line; }

}  // namespace bench
