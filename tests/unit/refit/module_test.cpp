// SPDX-License-Identifier: Apache-2.0
// The module as libawd meets it: a file.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstring>

#include "refit/refit_module.h"
#include "refit/solving.h"
#include "support/guarded.h"

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

/// A newer library's structs are longer, one of before the module's time has shorter ones: no byte
/// is touched that the caller does not have, or that the module does not know.
TEST(RefitModule, KeepsToTheSizesOfItsCaller) {
  const AWDRefitModule* module = moduleTable();
  ASSERT_NE(module, nullptr);
  const TestProblem p = gramProblem({});
  const AWDRefitProblem view = p.view();
  for (uint32_t i = 0; i < module->solverCount; ++i) {
    const AWDRefitSolver& solver = *module->solvers[i];
    std::vector<double> c(p.size()), expected(p.size());
    AWDRefitOutcome outcome = {sizeof(AWDRefitOutcome), 0, 0, 0, ""};
    ASSERT_EQ(solver.solve(&view, expected.data(), &outcome), AWD_SUCCESS);

    for (const std::size_t more : {std::size_t{0}, std::size_t{8}, std::size_t{1000}}) {
      const awdtest::Guarded problem(sizeof view + more), result(sizeof outcome + more);
      std::memset(problem.data(), 0xa5, problem.size());
      std::memset(result.data(), 0xa5, result.size());
      AWDRefitProblem grown = view;
      grown.structSize = problem.size();
      std::memcpy(problem.data(), &grown, sizeof grown);
      const std::size_t room = result.size();
      std::memcpy(result.data(), &room, sizeof room);
      ASSERT_EQ(solver.solve(reinterpret_cast<const AWDRefitProblem*>(problem.data()), c.data(),
                             reinterpret_cast<AWDRefitOutcome*>(result.data())),
                AWD_SUCCESS);
      EXPECT_EQ(c, expected);
      for (std::size_t at = sizeof outcome; at < room; ++at) {
        ASSERT_EQ(static_cast<unsigned char>(result.data()[at]), 0xa5u) << at;
      }
    }
    const awdtest::Guarded shorter(sizeof view - 8);
    AWDRefitProblem old = view;
    old.structSize = shorter.size();
    std::memcpy(shorter.data(), &old, shorter.size());
    EXPECT_EQ(
        solver.solve(reinterpret_cast<const AWDRefitProblem*>(shorter.data()), c.data(), &outcome),
        AWD_SUCCESS);
    EXPECT_EQ(outcome.status, AWD_REFIT_FAILED);
    EXPECT_NE(std::strstr(outcome.message, "structSize is"), nullptr) << outcome.message;
  }
}

}  // namespace
}  // namespace awd
