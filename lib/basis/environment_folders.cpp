// SPDX-License-Identifier: Apache-2.0
#include "basis/environment_folders.h"

#include <sys/auxv.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace awd {

std::vector<std::string> environmentFolders(const char* variable) {
  std::vector<std::string> folders;
  const char* text = getauxval(AT_SECURE) ? nullptr : std::getenv(variable);
  std::string_view rest = text ? text : "";
  while (!rest.empty()) {
    const std::string_view entry = rest.substr(0, rest.find(':'));
    if (!entry.empty()) folders.emplace_back(entry);
    rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
  }
  return folders;
}

}  // namespace awd
