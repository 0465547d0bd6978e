// SPDX-License-Identifier: Apache-2.0
#include "write_file.h"

#include <signal.h>
#include <sys/resource.h>

#include <iterator>

#include "temporary_folder.h"

using namespace command;

namespace {

using WriteFileTest = TemporaryFolder;

std::string contentOf(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::ptrdiff_t filesIn(const std::string& folder) {
  return std::distance(std::filesystem::directory_iterator(folder), {});
}

TEST_F(WriteFileTest, WritesAndReplacesLeavingNothingElse) {
  const std::string path = folder() + "/a.json";
  checkWritable(path);
  EXPECT_EQ(filesIn(folder()), 0);
  writeFile(path, "one\n");
  writeFile(path, "two\n");
  EXPECT_EQ(contentOf(path), "two\n");
  EXPECT_EQ(filesIn(folder()), 1);
}

TEST_F(WriteFileTest, NamesThePathThatCantBeWritten) {
  const std::string path = folder() + "/none/a.json";
  EXPECT_CONTAINS(failureOf([&] { checkWritable(path); }), path);
  EXPECT_CONTAINS(failureOf([&] { writeFile(path, "text"); }), path);
}

TEST_F(WriteFileTest, RefusesFoldersAndDevices) {
  EXPECT_CONTAINS(failureOf([&] { checkWritable(folder()); }), "not a regular file");
  EXPECT_CONTAINS(failureOf([&] { checkWritable("/dev/null"); }), "not a regular file");
}

TEST_F(WriteFileTest, AFullDiskIsReportedAndTheOldFileStays) {
  const std::string path = file("a.json", "old");
  const auto before = signal(SIGXFSZ, SIG_IGN);
  rlimit limit = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &limit), 0);
  rlimit small = limit;
  small.rlim_cur = 1000;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = failureOf([&] { writeFile(path, std::string(100000, 'x')); });
  setrlimit(RLIMIT_FSIZE, &limit);
  signal(SIGXFSZ, before);
  EXPECT_CONTAINS(message, path);
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(filesIn(folder()), 1);
}

}  // namespace
