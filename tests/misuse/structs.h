// SPDX-License-Identifier: Apache-2.0
// Every struct of the interface, and what can be seen of what the library makes of it: by this its
// growth is tested from both sides.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "misuse/world.h"

namespace awdmisuse {

/// What a call gave: its code and message, or bits of all that came of it.
using Seen = std::vector<char>;

/// One that the host fills.
struct Input {
  const char* name;
  std::vector<char> good;  ///< with as few zeros as can be
  /// What a new world makes of it.
  std::function<Seen(World&, const void* desc)> see;
};

/// One that the library fills; a state that does not change gives the same every time.
struct Output {
  const char* name;
  size_t size;
  std::function<AWDResult(World&, void* out)> fill;
  bool changes = false;  ///< each call gives another one
};

/// One that has no structSize and never grows.
struct Fixed {
  const char* name;
  size_t size, wanted;
};

const std::vector<Input>& allInputs();
const std::vector<Output>& allOutputs();
const std::vector<Fixed>& allFixed();

/// Of the result of a call that makes or changes something, and then, if it worked, of that.
template <class More>
Seen seen(AWDResult result, More&& more) {
  Seen bytes(1, static_cast<char>(result));
  if (result != AWD_SUCCESS) {
    const std::string message = awdGetLastErrorMessage();
    bytes.insert(bytes.end(), message.begin(), message.end());
    return bytes;
  }
  const auto add = [&](const void* from, size_t size) {
    bytes.insert(bytes.end(), static_cast<const char*>(from),
                 static_cast<const char*>(from) + size);
  };
  more(add);
  return bytes;
}

}  // namespace awdmisuse
