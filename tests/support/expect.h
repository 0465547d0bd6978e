// SPDX-License-Identifier: Apache-2.0
// Expecting that a call fails, why, and that its message says so.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/handles.h"

namespace awdtest {

/// The call failed with `code`, and the thread's message has each of `parts`.
inline void expectFailure(AWDResult result, AWDResult code,
                          const std::vector<std::string>& parts = {}) {
  const std::string message = awdGetLastErrorMessage();
  EXPECT_EQ(result, code) << (result == AWD_SUCCESS ? "no error" : message);
  if (result == AWD_SUCCESS) return;
  EXPECT_FALSE(message.empty());
  for (const std::string& part : parts) {
    EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
  }
}

}  // namespace awdtest
