// SPDX-License-Identifier: Apache-2.0
#include "basis/module.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <exception>

#include "util/error.h"

namespace awd {

namespace {

#define AWD_TEXT_OF(name) #name
#define AWD_TEXT(name) AWD_TEXT_OF(name)
constexpr const char* kEntry = AWD_TEXT(AWD_BASIS_ENTRY);

constexpr std::size_t kLongestStruct = 4096;
constexpr uint32_t kMostFamilies = 256;

/// How long a family was in the first version of this ABI.
constexpr std::size_t kFirstFamily = offsetof(AWDBasisFamily, wavelet);

/// A table must have all that the ABI began with. It may be longer than ours, but must not use
/// what we don't know.
void checkSize(const char* what, const void* table, std::size_t size, std::size_t least,
               std::size_t ours) {
  if (size < least || size > kLongestStruct || size % alignof(void*) != 0) {
    fail(AWD_ERROR_PLUGIN_ABI, "%s has structSize %zu, but basis ABI %u has %zu or more", what,
         size, AWD_BASIS_ABI, least);
  }
  const char* bytes = static_cast<const char*>(table);
  for (std::size_t i = ours; i < size; ++i) {
    if (bytes[i] != 0) {
      fail(AWD_ERROR_PLUGIN_ABI,
           "%s uses a field at byte %zu that this version of the library does not know", what, i);
    }
  }
}

/// What the module's entry returns. An exception of its own must not outlive the module's code.
const AWDBasisModule* askForTable(AWDBasisModuleFn entry) {
  const AWDBasisHost host = {sizeof(AWDBasisHost), AWD_BASIS_ABI, AWD_VERSION};
  std::string what;
  try {
    return entry(&host);
  } catch (const std::exception& error) {
    what = std::string(": ") + error.what();
  } catch (...) {
  }
  fail(AWD_ERROR_PLUGIN_LOAD, "its entry point throws an exception%s",
       printable(what.c_str(), kLongestSummary).c_str());
}

[[noreturn]] void refuseAbi(uint32_t abi) {
  fail(AWD_ERROR_PLUGIN_ABI,
       "the module is of basis ABI %u, the library of %u: compile the module with the library's "
       "awd/basis.h",
       abi, AWD_BASIS_ABI);
}

/// A file without our entry point: of another ABI, or no module at all?
[[noreturn]] void refuseStranger(void* handle) {
  constexpr uint32_t kLikely = 100;
  const std::string stem(kEntry, std::strcspn(kEntry, "0123456789"));
  for (uint32_t abi = 1; abi <= kLikely; ++abi) {
    if (dlsym(handle, (stem + std::to_string(abi)).c_str())) refuseAbi(abi);
  }
  fail(AWD_ERROR_PLUGIN_LOAD, "has no entry point %s", kEntry);
}

}  // namespace

void checkModule(const AWDBasisModule* module) {
  if (!module) fail(AWD_ERROR_PLUGIN_ABI, "the module refuses this version of the library");
  if (module->abi != AWD_BASIS_ABI) refuseAbi(module->abi);
  checkSize("AWDBasisModule", module, module->structSize, sizeof(AWDBasisModule),
            sizeof(AWDBasisModule));
  if (module->familyCount < 1 || module->familyCount > kMostFamilies || !module->families) {
    fail(AWD_ERROR_PLUGIN_ABI, "the module has %u families at %s: it must have 1 to %u",
         module->familyCount, module->families ? "an address" : "NULL", kMostFamilies);
  }
  for (uint32_t i = 0; i < module->familyCount; ++i) {
    const AWDBasisFamily* family = module->families[i];
    if (!family) fail(AWD_ERROR_PLUGIN_ABI, "families[%u] is NULL", i);
    checkSize("AWDBasisFamily", family, family->structSize, kFirstFamily, sizeof(AWDBasisFamily));
  }
}

AWDBasisFamily knownPart(const AWDBasisFamily& family) {
  AWDBasisFamily known = {};
  std::memcpy(&known, &family, std::min(family.structSize, sizeof known));
  known.structSize = sizeof known;
  return known;
}

std::string printable(const char* text, std::size_t longest) {
  std::string out(text ? text : "", text ? strnlen(text, longest) : 0);
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return out;
}

Module::Module(const char* absolutePath) {
  if (absolutePath[0] != '/') {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "absolutePath \"%s\" is not absolute: give the whole path, from '/' on", absolutePath);
  }
  const FloatingPointKept floatingPointKept;
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
    if (!entry) refuseStranger(handle_);
    table_ = askForTable(entry);
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
