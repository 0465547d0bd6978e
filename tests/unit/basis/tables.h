// SPDX-License-Identifier: Apache-2.0
// The families that the tests of this folder look at.
#pragma once

#include "awd/basis.h"
#include "basis/module.h"
#include "honest.h"

namespace awd::test {

/// Haar, from its module.
inline const AWDBasisFamily& haar() {
  static const Module module(AWD_HAAR_FILE);
  return *module.table().families[0];
}
inline const AWDBasisFamily& linear() { return *honestModule()->families[0]; }
inline const AWDBasisFamily& linearPeriodic() { return *honestModule()->families[1]; }
inline const AWDBasisFamily& quadratic() { return *honestModule()->families[2]; }

}  // namespace awd::test
