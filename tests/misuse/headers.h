// SPDX-License-Identifier: Apache-2.0
// What the public headers of C say.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace awdmisuse {

inline std::string textOfHeaders() {
  std::string text;
  for (const auto& file : std::filesystem::directory_iterator(AWD_TEST_INCLUDE "/awd")) {
    if (file.path().extension() != ".h") continue;
    std::ifstream stream(file.path());
    text.append(std::istreambuf_iterator<char>(stream), {});
  }
  return text;
}

}  // namespace awdmisuse
