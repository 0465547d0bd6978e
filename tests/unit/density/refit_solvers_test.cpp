// SPDX-License-Identifier: Apache-2.0
#include "density/refit_solvers.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cfenv>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "util/error.h"

namespace awd {
namespace {

namespace fs = std::filesystem;

class RefitSolvers : public testing::Test {
 protected:
  RefitSolvers() {
    std::string name = testing::TempDir() + "awd-refit-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~RefitSolvers() override { fs::remove_all(folder_); }

  /// The message with which nothing is found.
  std::string refusal(const std::vector<std::string>& folders, const char* name = nullptr) {
    try {
      findRefitSolver(folders, name);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), AWD_ERROR_UNSUPPORTED);
      return error.what();
    }
    return "found";
  }

  std::string folder_;
};

TEST_F(RefitSolvers, TellsThePathsItTried) {
  const std::string missing = folder_ + "/missing";
  const std::string text = refusal({missing, folder_, "relative"});
  EXPECT_NE(text.find("\"" + missing + "/" AWD_REFIT_FILE "\" (does not exist)"), std::string::npos)
      << text;
  EXPECT_NE(text.find("\"" + folder_ + "/" AWD_REFIT_FILE "\""), std::string::npos) << text;
  EXPECT_NE(text.find("not absolute"), std::string::npos) << text;
  EXPECT_NE(refusal({}).find("no folder"), std::string::npos);
}

TEST_F(RefitSolvers, RefusesFilesThatAreNoModule) {
  const std::string file = folder_ + "/" AWD_REFIT_FILE;
  std::ofstream(file) << "no library";
  EXPECT_NE(refusal({folder_}).find(file), std::string::npos);
  ASSERT_EQ(chmod(file.c_str(), 0666), 0);
  EXPECT_NE(refusal({folder_}).find("anybody may write"), std::string::npos);
  ASSERT_EQ(chmod(file.c_str(), 0644), 0);
  ASSERT_EQ(chmod(folder_.c_str(), 01777), 0);
  EXPECT_NE(refusal({folder_}).find("to which anybody may write"), std::string::npos);
  ASSERT_EQ(chmod(folder_.c_str(), 0700), 0);
  // A library, but of another kind.
  fs::remove(file);
  Dl_info info = {};
  ASSERT_NE(dladdr(reinterpret_cast<void*>(&std::feholdexcept), &info), 0);
  fs::create_symlink(fs::canonical(info.dli_fname), file);
  EXPECT_NE(refusal({folder_}).find("has no entry point"), std::string::npos);
}

TEST_F(RefitSolvers, LooksBesideTheLibraryAndWhereTheEnvironmentSays) {
  ASSERT_EQ(setenv("AWD_REFIT_PATH", "/one:/two", 1), 0);
  const std::vector<std::string> folders = refitFolders(false);
  ASSERT_EQ(folders.size(), 3u);
  EXPECT_EQ(folders[0], "/one");
  EXPECT_EQ(folders[1], "/two");
  EXPECT_EQ(folders[2].substr(folders[2].size() - 4), "/awd");
  EXPECT_EQ(refitFolders(true), std::vector<std::string>{folders[2]});
  ASSERT_EQ(unsetenv("AWD_REFIT_PATH"), 0);
}

}  // namespace
}  // namespace awd
