// SPDX-License-Identifier: Apache-2.0
// One file of basis families, opened and asked for its table.
#pragma once

#include "awd/basis.h"

namespace awd {

/// Checks what can be checked of a module without calling its families: AWD_ERROR_PLUGIN_ABI
/// unless the table is one of the interface that this library has.
void checkModule(const AWDBasisModule* module);

class Module {
 public:
  /// Opens the file and checks its table. AWD_ERROR_INVALID_ARGUMENT unless the path is absolute,
  /// AWD_ERROR_PLUGIN_LOAD or AWD_ERROR_PLUGIN_ABI if the module is of no use.
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
