// SPDX-License-Identifier: Apache-2.0
#include "basis/library_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

namespace fs = std::filesystem;

// Here the library is part of a program; tests/plugins looks at libawd.so itself.
TEST(LibraryFolder, IsThatOfTheProgram) {
  EXPECT_EQ(awd::libraryFolder(), fs::canonical("/proc/self/exe").parent_path());
}

TEST(LibraryFolder, DoesNotGoWithTheCurrentFolder) {
  const std::string before = awd::libraryFolder();
  const fs::path current = fs::current_path();
  fs::current_path("/");
  EXPECT_EQ(awd::libraryFolder(), before);
  fs::current_path(current);
}

}  // namespace
