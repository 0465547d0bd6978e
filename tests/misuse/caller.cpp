// SPDX-License-Identifier: Apache-2.0
#include "misuse/caller.h"

#include <cctype>
#include <cstdio>
#include <cstring>

namespace awdmisuse {

const char* Caller::text(const std::string& good, const std::vector<std::string>& wilder,
                         bool mayBeNull) {
  strings_.push_back(std::make_unique<std::string>(
      wild() && oneOf(2) == 0 ? wilder[random_.bits() % wilder.size()] : good));
  const std::string& chosen = *strings_.back();
  char* place = room(chosen.size() + 1, 0);
  std::memcpy(place, chosen.c_str(), chosen.size() + 1);
  return pointer(static_cast<const char*>(place), mayBeNull, "\"" + chosen.substr(0, 80) + "\"");
}

char* Caller::room(size_t size, int fill) {
  rooms_.push_back(std::make_unique<awdtest::Guarded>(size));
  std::memset(rooms_.back()->data(), fill, size);
  return rooms_.back()->data();
}

std::string Caller::differences(const void* good, const void* spoilt, size_t size) {
  std::string text;
  for (size_t at = 0; at + sizeof(uint32_t) <= size; at += sizeof(uint32_t)) {
    uint32_t was = 0, is = 0;
    std::memcpy(&was, static_cast<const char*>(good) + at, sizeof was);
    std::memcpy(&is, static_cast<const char*>(spoilt) + at, sizeof is);
    if (was == is) continue;
    char word[48];
    std::snprintf(word, sizeof word, " byte %zu: 0x%x", at, is);
    text += word;
  }
  return text;
}

void Caller::finish(AWDResult result) {
  result_ = result;
  for (size_t i = 0; i < outputs_.size(); ++i) outputs_[i](result == AWD_SUCCESS, judged_[i]);
  if (result == AWD_SUCCESS) return;
  if (result > AWD_SUCCESS || result < AWD_ERROR_PLUGIN_SELF_TEST) {
    complain("result " + std::to_string(result) + " is none of those there are");
  }
  const std::string message = awdGetLastErrorMessage();
  if (result == AWD_ERROR_UNKNOWN) complain("an unknown error: " + message);
  // The function, and then something that is a sentence.
  const std::string start = name_ + ": ";
  if (message.compare(0, start.size(), start) != 0 || message.size() < start.size() + 8) {
    complain("message \"" + message + "\"");
  }
  for (const char c : message) {
    if (std::iscntrl(static_cast<unsigned char>(c))) complain("control characters in: " + message);
  }
}

}  // namespace awdmisuse
