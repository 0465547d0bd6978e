// SPDX-License-Identifier: Apache-2.0
// One file of basis families, opened and asked for its table.
#pragma once

#include <cfenv>
#include <string>

#include "awd/basis.h"

namespace awd {

/// Checks what can be checked of a module without calling its families: AWD_ERROR_PLUGIN_ABI
/// unless the table is one of the interface that this library has.
void checkModule(const AWDBasisModule* module);

/// A family's table as this library knows it: fields that an older plugin lacks are 0, and those
/// of a newer one, which checkModule found to be 0, are left out.
AWDBasisFamily knownPart(const AWDBasisFamily& family);

constexpr std::size_t kLongestName = 64, kLongestSummary = 200;

/// A plugin's text as it can be shown: cut where no valid one goes on, and on one line. "" for
/// NULL.
std::string printable(const char* text, std::size_t longest);

/// Keeps rounding and the treatment of denormals as they are: what is compiled with -ffast-math
/// changes them for the thread that loads it.
class FloatingPointKept {
 public:
  FloatingPointKept() { std::fegetenv(&environment_); }
  ~FloatingPointKept() { std::fesetenv(&environment_); }
  FloatingPointKept(const FloatingPointKept&) = delete;
  FloatingPointKept& operator=(const FloatingPointKept&) = delete;

 private:
  std::fenv_t environment_{};
};

class Module {
 public:
  /// Opens the file and checks its table; the floating-point environment stays as it was.
  /// AWD_ERROR_INVALID_ARGUMENT unless the path is absolute, AWD_ERROR_PLUGIN_LOAD or
  /// AWD_ERROR_PLUGIN_ABI if the module is of no use.
  explicit Module(const char* absolutePath);
  /// Closes the file unless it is to stay.
  ~Module();
  Module(const Module&) = delete;
  Module& operator=(const Module&) = delete;

  const AWDBasisModule& table() const { return *table_; }
  /// The file stays in memory for as long as the process lives: tables may point into it.
  void keep() { handle_ = nullptr; }

 private:
  void* handle_ = nullptr;
  const AWDBasisModule* table_ = nullptr;
};

}  // namespace awd
