// SPDX-License-Identifier: Apache-2.0
#include "refit/problem_check.h"

#include <gtest/gtest.h>

#include "refit/solving.h"

namespace awd {
namespace {

/// tridiagonal, 1.5 and -0.5
TestProblem small() {
  std::map<std::pair<uint32_t, uint32_t>, double> a;
  for (uint32_t j = 0; j < 4; ++j) {
    a[{j, j}] = 1.5;
    if (j > 0) a[{j, j - 1}] = a[{j - 1, j}] = -0.5;
  }
  return testProblem(4, a, {1, 2, 3, 4}, {0, 0, 0, 0});
}

void expectFault(const AWDRefitProblem& problem, const std::string& part) {
  const std::string fault = problemFault(problem);
  EXPECT_NE(fault.find(part), std::string::npos) << "got: " << fault;
}

TEST(ProblemCheck, HasNothingAgainstGoodOnes) {
  EXPECT_EQ(problemFault(small().view()), "");
  EXPECT_EQ(problemFault(gramProblem({}).view()), "");
  Recipe wide;
  wide.decades = 60.0;
  EXPECT_EQ(problemFault(gramProblem(wide).view()), "");
}

TEST(ProblemCheck, NamesWhatIsMissing) {
  const TestProblem p = small();
  AWDRefitProblem view = p.view();
  view.structSize = 8;
  expectFault(view, "structSize is 8");
  for (const uint64_t n : {uint64_t{0}, uint64_t{1} << 31}) {
    view = p.view();
    view.unknowns = n;
    expectFault(view, "unknowns is");
    EXPECT_FALSE(hasStart(view));
  }
  view = p.view();
  view.rowBegin = nullptr;
  expectFault(view, "rowBegin is NULL");
  view = p.view();
  view.columns = nullptr;
  expectFault(view, "columns is NULL");
  view = p.view();
  view.values = nullptr;
  expectFault(view, "values is NULL");
  view = p.view();
  view.rhs = nullptr;
  expectFault(view, "rhs is NULL");
  view = p.view();
  view.lower = nullptr;
  expectFault(view, "lower is NULL");
  view = p.view();
  view.start = nullptr;
  expectFault(view, "start is NULL");
  EXPECT_FALSE(hasStart(view));
}

TEST(ProblemCheck, NamesBadRows) {
  TestProblem p = small();
  p.rowBegin[0] = 1;
  expectFault(p.view(), "rowBegin[0] is 1");
  p = small();
  p.rowBegin[2] = 1;
  expectFault(p.view(), "rowBegin[2] is 1 after 2");
  p = small();
  p.rowBegin[2] = uint64_t{1} << 60;
  expectFault(p.view(), "rowBegin[2]");
  p = small();
  p.columns[1] = 0;
  expectFault(p.view(), "columns[1] is 0 in row 0: must ascend");
  p = small();
  p.columns[1] = 4;
  expectFault(p.view(), "columns[1] is 4 in row 0");
  p = small();
  p.columns[1] = 2;  // row 0 has column 2, row 2 lacks column 0
  expectFault(p.view(), "row 0 has column 2, but row 2 lacks column 0");
}

TEST(ProblemCheck, NamesBadNumbers) {
  TestProblem p = small();
  p.at(1, 2) = std::nan("");
  expectFault(p.view(), "is nan in row 1: must be finite");
  for (const double diagonal : {0.0, -1.0, 1e-310}) {
    p = small();
    p.at(2, 2) = diagonal;
    expectFault(p.view(), "the diagonal of row 2 is");
  }
  p = small();
  p.at(1, 2) = -0.25;
  expectFault(p.view(), "row 1, column 2 is -0.25 but its mirror -0.5");
  p = small();
  p.at(1, 2) = p.at(2, 1) = 1.6;
  expectFault(p.view(), "not positive definite");
  p = small();
  p.rhs[1] = HUGE_VAL;
  expectFault(p.view(), "rhs[1] is inf");
  p = small();
  p.rhs[1] = 1e200;
  expectFault(p.view(), "scale the problem");
  p = small();
  p.lower[3] = -HUGE_VAL;
  expectFault(p.view(), "lower[3] is -inf");
  p = small();
  p.start[3] = std::nan("");
  expectFault(p.view(), "start[3] is nan");
  p = small();
  p.start[3] = -0.125;
  expectFault(p.view(), "start[3] is -0.125: must not be below its bound 0");
}

}  // namespace
}  // namespace awd
