// SPDX-License-Identifier: Apache-2.0
// Finding the refit module, a file of its own, when the estimator `refit` is asked for.
#pragma once

#include <string>
#include <vector>

#include "refit/refit_module.h"

namespace awd {

/// The folders that it is looked for in: those of $AWD_REFIT_PATH, unless they are to be ignored or
/// the process is privileged, and awd/ beside libawd.
std::vector<std::string> refitFolders(bool ignoreEnvironment);

/// The solver of that name, or with NULL the module's first, from the first of the folders that has
/// the module; it stays loaded. AWD_ERROR_UNSUPPORTED with the paths tried if there is none.
const AWDRefitSolver& findRefitSolver(const std::vector<std::string>& folders, const char* name);

}  // namespace awd
