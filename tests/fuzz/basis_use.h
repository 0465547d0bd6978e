// SPDX-License-Identifier: Apache-2.0
// One table through the C interface: the self-test, and whatever was accepted in use.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fuzz {

struct Outcome {
  bool honest;    ///< the table had no lie in it
  bool accepted;  ///< by the self-test
  bool used;      ///< a field could be made with it
};

/// Aborts if anything accepted is then of no use.
Outcome tryTable(const uint8_t* data, std::size_t size);

}  // namespace fuzz
