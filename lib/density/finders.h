// SPDX-License-Identifier: Apache-2.0
// Who gives the families and solvers whose names are found in bytes.
#pragma once

#include "awd/basis.h"
#include "refit/refit_module.h"

namespace awd {

/// Both fail where there is none of the name.
struct Finders {
  void* user;
  const AWDBasisFamily& (*family)(void* user, const char* name);
  const AWDRefitSolver& (*solver)(void* user, const char* name);
};

}  // namespace awd
