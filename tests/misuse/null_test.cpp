// SPDX-License-Identifier: Apache-2.0
// Every function of the interface: its call with good arguments works; NULL for each pointer in
// turn, and for all at once, is refused with a message or, where a header allows it, works.
#include <gtest/gtest.h>

#include "misuse/caller.h"

namespace {

using namespace awdmisuse;

/// One call in a world of its own.
class Calls : public testing::Test {
 protected:
  Calls() : world_(std::make_unique<World>()) {}

  Caller make(int null) { return Caller(*world_, 1, Caller::Mode::kGood, null); }
  AWDResult run(Caller& caller, const Function& function) {
    caller.named(function.name);
    function.call(caller);
    EXPECT_EQ(caller.complaint(), "") << caller.text();
    return caller.result();
  }
  /// What comes of a function that wants the renderer where there is none.
  bool isUnsupported(const Function& function) const {
    return function.renders && !world_->renders && function.hasResult();
  }
  std::unique_ptr<World> world_;
};

TEST_F(Calls, WorkWithGoodArguments) {
  for (const Function& function : allFunctions()) {
    Caller caller = make(Caller::kNone);
    const AWDResult wanted = isUnsupported(function) ? AWD_ERROR_UNSUPPORTED : AWD_SUCCESS;
    EXPECT_EQ(run(caller, function), wanted) << caller.text() << awdGetLastErrorMessage();
  }
}

TEST_F(Calls, NullIsRefusedUnlessAllowed) {
  size_t calls = 0;
  for (const Function& function : allFunctions()) {
    for (int null = 0;; ++null) {
      Caller caller = make(null);
      const AWDResult result = run(caller, function);
      if (null >= static_cast<int>(caller.pointers().size())) break;
      ++calls;
      if (isUnsupported(function)) {
        EXPECT_EQ(result, AWD_ERROR_UNSUPPORTED) << caller.text();
      } else if (caller.pointers()[static_cast<size_t>(null)]) {
        EXPECT_EQ(result, AWD_SUCCESS) << caller.text() << ": " << awdGetLastErrorMessage();
      } else {
        EXPECT_EQ(result, AWD_ERROR_INVALID_ARGUMENT) << caller.text();
        EXPECT_NE(std::string(awdGetLastErrorMessage()).find("NULL"), std::string::npos)
            << caller.text() << ": " << awdGetLastErrorMessage();
      }
    }
  }
  EXPECT_GT(calls, 250u);
}

TEST_F(Calls, NullEverywhereIsRefused) {
  for (const Function& function : allFunctions()) {
    Caller caller = make(Caller::kAll);
    const AWDResult result = run(caller, function);
    const std::vector<bool>& allowed = caller.pointers();
    const bool all = std::find(allowed.begin(), allowed.end(), false) == allowed.end();
    if (isUnsupported(function)) {
      EXPECT_EQ(result, AWD_ERROR_UNSUPPORTED) << caller.text();
      continue;
    }
    EXPECT_EQ(result, all ? AWD_SUCCESS : AWD_ERROR_INVALID_ARGUMENT) << caller.text();
  }
}

}  // namespace
