// SPDX-License-Identifier: Apache-2.0
// A module whose entry throws what only the module knows of.
#include <exception>

#include "awd/basis.h"

namespace {
struct Unable : std::exception {
  const char* what() const noexcept override { return "no licence today"; }
};
}  // namespace

// awd/basis.h says of the entry that it throws nothing, and a compiler would see to it. Not all
// modules include it.
extern "C" AWD_EXPORT const AWDBasisModule* AWD_CALL
throwUnable(const AWDBasisHost*) __asm__("awdBasisModule_v1");
const AWDBasisModule* AWD_CALL throwUnable(const AWDBasisHost*) { throw Unable(); }
