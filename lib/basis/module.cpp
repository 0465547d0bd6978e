// SPDX-License-Identifier: Apache-2.0
#include "basis/module.h"

#include <dlfcn.h>

#include <cstring>

#include "util/error.h"

namespace awd {

namespace {

#define AWD_TEXT_OF(name) #name
#define AWD_TEXT(name) AWD_TEXT_OF(name)
constexpr const char* kEntry = AWD_TEXT(AWD_BASIS_ENTRY);

constexpr std::size_t kLongestStruct = 4096;
constexpr uint32_t kMostFamilies = 256;

/// A table may be longer than ours, but must not use what we don't know.
void checkSize(const char* what, const void* table, std::size_t size, std::size_t ours) {
  if (size < ours || size > kLongestStruct) {
    fail(AWD_ERROR_PLUGIN_ABI, "%s has structSize %zu, but %zu is the size in basis ABI %u", what,
         size, ours, AWD_BASIS_ABI);
  }
  const char* bytes = static_cast<const char*>(table);
  for (std::size_t i = ours; i < size; ++i) {
    if (bytes[i] != 0) {
      fail(AWD_ERROR_PLUGIN_ABI,
           "%s uses a field at byte %zu that this version of the library does not know", what, i);
    }
  }
}

}  // namespace

void checkModule(const AWDBasisModule* module) {
  if (!module) fail(AWD_ERROR_PLUGIN_ABI, "the module refuses this version of the library");
  if (module->abi != AWD_BASIS_ABI) {
    fail(AWD_ERROR_PLUGIN_ABI,
         "the module is of basis ABI %u, the library of %u: compile the module with the library's "
         "awd/basis.h",
         module->abi, AWD_BASIS_ABI);
  }
  checkSize("AWDBasisModule", module, module->structSize, sizeof(AWDBasisModule));
  if (module->familyCount < 1 || module->familyCount > kMostFamilies || !module->families) {
    fail(AWD_ERROR_PLUGIN_ABI, "the module has %u families at %s: it must have 1 to %u",
         module->familyCount, module->families ? "an address" : "NULL", kMostFamilies);
  }
  for (uint32_t i = 0; i < module->familyCount; ++i) {
    const AWDBasisFamily* family = module->families[i];
    if (!family) fail(AWD_ERROR_PLUGIN_ABI, "families[%u] is NULL", i);
    checkSize("AWDBasisFamily", family, family->structSize, sizeof(AWDBasisFamily));
  }
}

Module::Module(const char* absolutePath) {
  if (absolutePath[0] != '/') {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "absolutePath \"%s\" is not absolute: give the whole path, from '/' on", absolutePath);
  }
  handle_ = dlopen(absolutePath, RTLD_NOW | RTLD_LOCAL);
  if (!handle_) {
    const char* reason = dlerror();
    const std::size_t length = std::strlen(absolutePath);
    if (std::strncmp(reason, absolutePath, length) == 0 && reason[length] == ':') {
      reason += length + 2;  // whoever reports this knows the path
    }
    fail(AWD_ERROR_PLUGIN_LOAD, "can't be opened: %s", reason);
  }
  try {
    const auto entry = reinterpret_cast<AWDBasisModuleFn>(dlsym(handle_, kEntry));
    if (!entry) fail(AWD_ERROR_PLUGIN_LOAD, "has no entry point %s", kEntry);
    const AWDBasisHost host = {sizeof(AWDBasisHost), AWD_BASIS_ABI, AWD_VERSION};
    table_ = entry(&host);
    checkModule(table_);
  } catch (...) {
    dlclose(handle_);
    throw;
  }
}

Module::~Module() {
  if (handle_) dlclose(handle_);
}

}  // namespace awd
