// SPDX-License-Identifier: Apache-2.0
// The module as libawd meets it: a file.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstring>

#include "refit/refit_module.h"
#include "refit/solving.h"

namespace awd {
namespace {

#define AWD_TEXT_OF(name) #name
#define AWD_TEXT(name) AWD_TEXT_OF(name)

const AWDRefitModule* moduleTable() {
  static void* const handle = dlopen(AWD_REFIT_MODULE, RTLD_NOW | RTLD_LOCAL);
  if (!handle) return nullptr;
  const auto entry = reinterpret_cast<AWDRefitModuleFn>(dlsym(handle, AWD_TEXT(AWD_REFIT_ENTRY)));
  return entry ? entry() : nullptr;
}

TEST(RefitModule, HasBothSolvers) {
  const AWDRefitModule* module = nullptr;
  EXPECT_EQ(printedBy([&] { module = moduleTable(); }), "");
  ASSERT_NE(module, nullptr);
  EXPECT_EQ(module->structSize, sizeof(AWDRefitModule));
  EXPECT_EQ(module->abi, AWD_REFIT_ABI);
  ASSERT_EQ(module->solverCount, 2u);
  EXPECT_STREQ(module->solvers[0]->name, "descent");
  EXPECT_STREQ(module->solvers[1]->name, "ceres");
}

TEST(RefitModule, SolvesAndRefusesInSilence) {
  const AWDRefitModule* module = moduleTable();
  ASSERT_NE(module, nullptr);
  for (uint32_t i = 0; i < module->solverCount; ++i) {
    const AWDRefitSolver& solver = *module->solvers[i];
    EXPECT_EQ(solver.structSize, sizeof(AWDRefitSolver));
    EXPECT_STRNE(solver.summary, "");
    TestProblem p = gramProblem({});
    std::vector<double> c(p.size());
    AWDRefitOutcome outcome = {sizeof(AWDRefitOutcome), 0, 0, 0, ""};
    const std::string printed = printedBy([&] {
      AWDRefitProblem view = p.view();
      EXPECT_EQ(solver.solve(&view, c.data(), &outcome), AWD_SUCCESS);
      EXPECT_EQ(outcome.status, AWD_REFIT_CONVERGED) << outcome.message;
      EXPECT_LT(optimalityOf(p, c).violation, 1e-13);
      p.rhs[2] = std::nan("");
      EXPECT_EQ(solver.solve(&view, c.data(), &outcome), AWD_SUCCESS);
    });
    EXPECT_EQ(printed, "");
    EXPECT_EQ(outcome.status, AWD_REFIT_FAILED);
    EXPECT_EQ(std::strncmp(outcome.message, "rhs[2] is nan", 13), 0) << outcome.message;
    EXPECT_EQ(c, p.start);
  }
}

}  // namespace
}  // namespace awd
