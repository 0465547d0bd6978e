// SPDX-License-Identifier: Apache-2.0
#include "util/file_bytes.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "util/error.h"

namespace awd {
namespace {

namespace fs = std::filesystem;

class FileBytes : public testing::Test {
 protected:
  FileBytes() {
    std::string pattern = (fs::temp_directory_path() / "awd-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~FileBytes() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  static std::pmr::vector<char> read(const std::string& path) {
    return readFile(std::pmr::get_default_resource(), path.c_str());
  }
  /// The message of the AWD_ERROR_IO that reading must throw.
  static std::string errorOf(const std::string& path) {
    try {
      read(path);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), AWD_ERROR_IO);
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST_F(FileBytes, ReadsAllOfAFile) {
  std::string bytes(100000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31 >> 3);
  for (const std::size_t length : {std::size_t{0}, std::size_t{1}, bytes.size()}) {
    std::ofstream(path("file"), std::ios::binary) << bytes.substr(0, length);
    const auto all = read(path("file"));
    EXPECT_EQ(std::string(all.begin(), all.end()), bytes.substr(0, length));
  }
}

TEST_F(FileBytes, SaysWhatIsWrong) {
  const auto expectSaid = [](const std::string& of, const char* part) {
    EXPECT_NE(errorOf(of).find(part), std::string::npos) << errorOf(of);
  };
  expectSaid(path("missing"), "missing\": No such file");
  expectSaid(folder_.string(), "Is a directory");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  expectSaid(path("pipe"), "not a regular file");
  expectSaid("/dev/zero", "not a regular file");
}

}  // namespace
}  // namespace awd
