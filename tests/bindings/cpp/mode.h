// SPDX-License-Identifier: Apache-2.0
// One text for both kinds of errors.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "awd/awd.hpp"

#ifdef AWD_NO_EXCEPTIONS

namespace awdtest {

template <class T>
T valueOf(awd::Result<T> result) {
  if (!result) ADD_FAILURE() << result.error().what();
  if constexpr (!std::is_void_v<T>) return std::move(result).value();
}

/// Why a call fails.
template <class Call>
awd::Error errorOf(Call&& call) {
  const auto result = call();
  return result ? awd::Error(AWD_SUCCESS, "no error") : result.error();
}

}  // namespace awdtest

/// The value of a call that is to work.
#define MUST(call) awdtest::valueOf(call)

#else

namespace awdtest {

template <class Call>
awd::Error errorOf(Call&& call) {
  try {
    call();
  } catch (const awd::Error& error) {
    return error;
  }
  return awd::Error(AWD_SUCCESS, "no error");
}

}  // namespace awdtest

#define MUST(call) (call)

#endif

namespace awdtest {

/// The call fails with `code`, and says `part`.
template <class Call>
void expectError(Call&& call, AWDResult code, const std::string& part) {
  const awd::Error error = errorOf(std::forward<Call>(call));
  EXPECT_EQ(error.code(), code) << error.what();
  EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
      << "no \"" << part << "\" in: " << error.what();
}

}  // namespace awdtest
