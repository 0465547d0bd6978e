// SPDX-License-Identifier: Apache-2.0
// Solves test problems, and looks whether anything was printed.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "refit/problems.h"
#include "refit/quadratic.h"
#include "refit/solver.h"

namespace awd {

struct Solved {
  AWDResult result = AWD_SUCCESS;
  AWDRefitOutcome outcome = {sizeof(AWDRefitOutcome), 0, 0, 0, ""};
  std::vector<double> c;
};

inline Solved solved(Minimise minimise, const AWDRefitProblem& problem) {
  Solved s;
  s.c.assign(problem.unknowns, -1.0);
  s.result = solveBy(minimise, &problem, s.c.data(), &s.outcome);
  return s;
}

inline Solved solved(Minimise minimise, const TestProblem& problem) {
  return solved(minimise, problem.view());
}

inline Optimality optimalityOf(const TestProblem& problem, const std::vector<double>& c) {
  const AWDRefitProblem view = problem.view();
  return Quadratic(view).optimality(c);
}

/// What a piece of code wrote to the file descriptors 1 and 2.
template <class Code>
std::string printedBy(Code&& code) {
  std::fflush(stdout);
  std::fflush(stderr);
  std::FILE* file = std::tmpfile();
  const int saved[2] = {dup(1), dup(2)};
  for (const int descriptor : {1, 2}) dup2(fileno(file), descriptor);
  code();
  std::fflush(stdout);
  std::fflush(stderr);
  for (const int descriptor : {1, 2}) {
    dup2(saved[descriptor - 1], descriptor);
    close(saved[descriptor - 1]);
  }
  std::rewind(file);
  std::string text(4096, '\0');
  text.resize(std::fread(text.data(), 1, text.size(), file));
  std::fclose(file);
  return text;
}

/// A problem with a number replaced by each that is none, in A, b, lower and start.
inline std::vector<TestProblem> poisonedProblems() {
  std::vector<TestProblem> problems;
  for (const double poison : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    for (int where = 0; where < 5; ++where) {
      TestProblem p = gramProblem({});
      double* numbers[] = {&p.at(3, 3), &p.at(3, 4), &p.rhs[3], &p.lower[3], &p.start[3]};
      *numbers[where] = poison;
      problems.push_back(p);
    }
  }
  return problems;
}

/// A host that wants no more after so many calls.
struct Patience {
  int calls;
  static int32_t progress(void* user, double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    return --static_cast<Patience*>(user)->calls > 0;
  }
};

}  // namespace awd
