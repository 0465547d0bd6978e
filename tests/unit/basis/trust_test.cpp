// SPDX-License-Identifier: Apache-2.0
#include "basis/trust.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include "support/temporary_folder.h"

namespace {

namespace fs = std::filesystem;
using awd::distrust;

class Trust : public testing::Test {
 protected:
  Trust() { std::ofstream(file_) << "anything"; }
  void permit(const std::string& path, mode_t mode) { ASSERT_EQ(chmod(path.c_str(), mode), 0); }
  static bool tells(const std::string& why, const char* part) {
    return why.find(part) != std::string::npos;
  }

  awdtest::TemporaryFolder folder_;
  const std::string file_ = folder_.path("file.so"), link_ = folder_.path("link.so");
};

TEST_F(Trust, InAFileOfItsOwnersAlone) {
  for (const mode_t mode : {0600, 0644, 0755, 0775}) {
    permit(file_, mode);
    EXPECT_EQ(distrust(file_), "");
  }
  fs::create_symlink(file_, link_);
  EXPECT_EQ(distrust(link_), "");
}

TEST_F(Trust, NotInWhatAnybodyMayWrite) {
  for (const mode_t mode : {0666, 0777, 0602}) {
    permit(file_, mode);
    EXPECT_TRUE(tells(distrust(file_), "anybody may write to it")) << distrust(file_);
  }
}

// Whoever may write to a folder may put another file in the place of one that he may not write to.
TEST_F(Trust, NotInAFolderThatAnybodyMayWrite) {
  const awdtest::TemporaryFolder elsewhere;
  fs::create_symlink(file_, elsewhere.path("link.so"));
  for (const mode_t mode : {0777, 01777}) {
    permit(fs::path(file_).parent_path(), mode);
    EXPECT_TRUE(tells(distrust(file_), "to which anybody may write")) << distrust(file_);
    EXPECT_TRUE(tells(distrust(elsewhere.path("link.so")), "to which anybody may write"));
  }
}

TEST_F(Trust, NotInWhatIsNoFile) {
  EXPECT_EQ(distrust(folder_.path("missing.so")), "does not exist");
  EXPECT_EQ(distrust(fs::path(file_).parent_path()), "is not a file");
  EXPECT_EQ(distrust("/dev/null"), "is not a file");
  fs::create_symlink(link_, link_);
  EXPECT_TRUE(tells(distrust(link_), "can't be read")) << distrust(link_);
  for (const char* relative : {"", "file.so", "./file.so"}) {
    EXPECT_EQ(distrust(relative), "not absolute");
  }
}

}  // namespace
