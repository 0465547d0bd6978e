// SPDX-License-Identifier: Apache-2.0
// Compiled families for the tests of densities and fields: the Haar plugin, linked in, and the
// honest test plugin's B-splines.
#pragma once

#include <cstdlib>
#include <cstring>
#include <memory_resource>
#include <random>

#include "awd/basis.h"
#include "basis/family.h"
#include "honest.h"

/// The entry point of the Haar plugin, renamed for these tests so that it can be linked in.
extern "C" const AWDBasisModule* haarModule(const AWDBasisHost* host);

namespace awd {

inline const AWDBasisFamily& haarTable() {
  static const AWDBasisHost host = {sizeof(AWDBasisHost), AWD_BASIS_ABI, AWD_VERSION};
  return *haarModule(&host)->families[0];
}

/// A table of tests/plugins/honest.c, or Haar's, by name.
inline const AWDBasisFamily& table(const char* name) {
  if (std::strcmp(name, "haar") == 0) return haarTable();
  const AWDBasisModule* module = honestModule();
  for (uint32_t i = 0; i < module->familyCount; ++i) {
    if (std::strcmp(module->families[i]->name, name) == 0) return *module->families[i];
  }
  std::abort();
}

inline Family family(const char* name, uint32_t maxLevel = 6) {
  return Family(std::pmr::get_default_resource(), table(name), maxLevel);
}

constexpr const char* kFamilies[] = {"haar", "test-linear", "test-linear-periodic",
                                     "test-quadratic"};

/// Uniforms in [0,1) with 53 bits, from a fixed seed.
class Uniforms {
 public:
  explicit Uniforms(uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace awd
