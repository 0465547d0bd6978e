// SPDX-License-Identifier: Apache-2.0
// A folder for one test's files, and what a failure says.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "failure.h"

class TemporaryFolder : public testing::Test {
 protected:
  TemporaryFolder() {
    std::string name = testing::TempDir() + "awd-cli-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() override { std::filesystem::remove_all(folder_); }

  /// Writes a file and returns its path.
  std::string file(const std::string& name, const std::string& content) const {
    const std::string path = folder_ + "/" + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }
  const std::string& folder() const { return folder_; }

 private:
  std::string folder_;
};

/// The message of the Failure that body() throws; "" if it throws none.
template <class Body>
std::string failureOf(Body&& body) {
  try {
    body();
  } catch (const command::Failure& failure) {
    return failure.what();
  }
  return "";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}
#define EXPECT_CONTAINS(text, part)                                                                \
  EXPECT_PRED2(contains, static_cast<std::string>(text), static_cast<std::string>(part))
