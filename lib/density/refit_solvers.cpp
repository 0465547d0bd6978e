// SPDX-License-Identifier: Apache-2.0
#include "density/refit_solvers.h"

#include <dlfcn.h>

#include <cstring>

#include "basis/environment_folders.h"
#include "basis/library_folder.h"
#include "basis/module.h"
#include "basis/trust.h"
#include "util/error.h"

namespace awd {

namespace {

#define AWD_TEXT_OF(name) #name
#define AWD_TEXT(name) AWD_TEXT_OF(name)
constexpr const char* kEntry = AWD_TEXT(AWD_REFIT_ENTRY);

bool usable(const AWDRefitModule* module) {
  if (!module || module->structSize < sizeof(AWDRefitModule) || module->abi != AWD_REFIT_ABI ||
      module->solverCount == 0 || !module->solvers) {
    return false;
  }
  for (uint32_t i = 0; i < module->solverCount; ++i) {
    const AWDRefitSolver* solver = module->solvers[i];
    if (!solver || solver->structSize < sizeof(AWDRefitSolver) || !solver->name || !solver->solve) {
      return false;
    }
  }
  return true;
}

/// The table of a module file; else null, and why.
const AWDRefitModule* open(const std::string& file, std::string& why) {
  why = distrust(file);
  if (!why.empty()) return nullptr;
  const FloatingPointKept floatingPointKept;
  void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    why = dlerror();
    return nullptr;
  }
  const auto entry = reinterpret_cast<AWDRefitModuleFn>(dlsym(handle, kEntry));
  const AWDRefitModule* module = entry ? entry() : nullptr;
  if (!usable(module)) {
    why = entry ? "its table is of another interface" : std::string("has no entry point ") + kEntry;
    dlclose(handle);
    return nullptr;
  }
  // Opened once more with every density that asks, which the loader counts; never closed.
  return module;
}

}  // namespace

std::vector<std::string> refitFolders(bool ignoreEnvironment) {
  std::vector<std::string> folders;
  if (!ignoreEnvironment) folders = environmentFolders("AWD_REFIT_PATH");
  const std::string own = libraryFolder();
  if (!own.empty()) folders.push_back(own + "/awd");
  return folders;
}

const AWDRefitSolver& findRefitSolver(const std::vector<std::string>& folders, const char* name) {
  std::string tried;
  for (const std::string& folder : folders) {
    const std::string file = folder + "/" AWD_REFIT_FILE;
    std::string why;
    const AWDRefitModule* module = open(file, why);
    if (!module) {
      tried.append(tried.empty() ? " \"" : ", \"").append(file).append("\" (");
      tried.append(why).append(")");
      continue;
    }
    if (!name) return *module->solvers[0];
    std::string names;
    for (uint32_t i = 0; i < module->solverCount; ++i) {
      if (std::strcmp(module->solvers[i]->name, name) == 0) return *module->solvers[i];
      names.append(i > 0 ? ", " : "").append(printable(module->solvers[i]->name, kLongestName));
    }
    fail(AWD_ERROR_UNSUPPORTED, "there is no refit solver \"%s\": \"%s\" has %s",
         printable(name, kLongestName).c_str(), file.c_str(), names.c_str());
  }
  fail(AWD_ERROR_UNSUPPORTED, "the estimator refit wants the refit module; tried%s",
       tried.empty() ? " no folder" : tried.c_str());
}

}  // namespace awd
