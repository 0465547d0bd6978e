// SPDX-License-Identifier: Apache-2.0
// Compiled families for the tests of densities and fields: our plugins, linked in, and the honest
// test plugin's B-splines.
#pragma once

#include <cstdlib>
#include <cstring>
#include <memory_resource>
#include <random>

#include "awd/basis.h"
#include "basis/family.h"
#include "honest.h"

/// The entry points of the plugins, renamed for these tests so that they can be linked in.
extern "C" {
const AWDBasisModule* haarModule(const AWDBasisHost* host);
const AWDBasisModule* flatletModule(const AWDBasisHost* host);
const AWDBasisModule* linearModule(const AWDBasisHost* host);
const AWDBasisModule* multiwaveletModule(const AWDBasisHost* host);
const AWDBasisModule* quadraticModule(const AWDBasisHost* host);
}

namespace awd {

inline std::pmr::memory_resource* memory() { return std::pmr::get_default_resource(); }

/// A table of a plugin or of tests/plugins/honest.c by name.
inline const AWDBasisFamily& table(const char* name) {
  static const AWDBasisHost host = {sizeof(AWDBasisHost), AWD_BASIS_ABI, AWD_VERSION};
  for (const AWDBasisModule* module :
       {haarModule(&host), flatletModule(&host), linearModule(&host), multiwaveletModule(&host),
        quadraticModule(&host), honestModule()}) {
    for (uint32_t i = 0; i < module->familyCount; ++i) {
      if (std::strcmp(module->families[i]->name, name) == 0) return *module->families[i];
    }
  }
  std::abort();
}

inline const AWDBasisFamily& haarTable() { return table("haar"); }

inline Family family(const char* name, uint32_t maxLevel = 6) {
  return Family(std::pmr::get_default_resource(), table(name), maxLevel);
}

constexpr const char* kFamilies[] = {"haar", "test-linear", "test-linear-periodic",
                                     "test-quadratic"};

/// Those we ship; the nested ones, with wavelets, first.
constexpr const char* kShipped[] = {"haar",
                                    "f2",
                                    "m2",
                                    "m3",
                                    "linear-bspline",
                                    "linear-bspline-periodic",
                                    "quadratic-bspline",
                                    "quadratic-bspline-periodic"};
constexpr const char* kNested[] = {"haar", "f2", "m2", "m3"};

/// Uniforms in [0,1) with 53 bits, from a fixed seed.
class Uniforms {
 public:
  explicit Uniforms(uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace awd
