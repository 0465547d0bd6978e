// SPDX-License-Identifier: Apache-2.0
// What is fuzzed: a function that takes any bytes at all and aborts if the library breaks a
// promise, and inputs to begin with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

using Input = std::vector<uint8_t>;

struct Target {
  const char* name;  ///< of the program fuzz-<name> and of the folder regressions/<name>
  void (*run)(const uint8_t* data, std::size_t size);
  std::vector<Input> (*seeds)();
};

// One at each file of that name.
extern const Target kSceneCalls, kSavedDensity, kSavedField, kCheckpoint, kExchange, kSettings,
    kExr, kObj, kGltf, kCameraFile;

inline Input inputOf(const std::string& text) { return {text.begin(), text.end()}; }

}  // namespace fuzz
