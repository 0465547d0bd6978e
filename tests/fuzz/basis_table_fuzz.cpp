// SPDX-License-Identifier: Apache-2.0
#include "basis_use.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);
extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  fuzz::tryTable(data, size);
  return 0;
}
