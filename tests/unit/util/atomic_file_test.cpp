// SPDX-License-Identifier: Apache-2.0
#include "util/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "util/error.h"

namespace {
int umaskCalls = 0;
}

/// Stands before that of the C library.
extern "C" mode_t umask(mode_t mask) noexcept {
  ++umaskCalls;
  return static_cast<mode_t>(syscall(SYS_umask, mask));
}

namespace {

namespace fs = std::filesystem;
using awd::AtomicFile;

class AtomicFileTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string path = (fs::temp_directory_path() / "awd-XXXXXX").string();
    ASSERT_NE(mkdtemp(path.data()), nullptr);
    folder_ = path;
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string file(const char* name) const { return (folder_ / name).string(); }
  std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }
  static std::string content(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// The message of the AWD_ERROR_IO that body() must throw.
  template <class Body>
  static std::string ioError(Body&& body) {
    try {
      body();
    } catch (const awd::Error& error) {
      EXPECT_EQ(error.code(), AWD_ERROR_IO);
      return error.what();
    }
    ADD_FAILURE() << "no error";
    return "";
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, ReplacesNoDeviceAndNoFolder) {
  for (const std::string& path : {std::string("/dev/null"), folder_.string()}) {
    const std::string text = ioError([&] { AtomicFile out(path.c_str()); });
    EXPECT_NE(text.find("not a file"), std::string::npos) << text;
  }
}

TEST_F(AtomicFileTest, WritesThroughALink) {
  std::ofstream(file("real")) << "old";
  fs::create_symlink(file("real"), file("link"));
  AtomicFile out(file("link").c_str());
  out.write("new", 3);
  out.commit();
  EXPECT_TRUE(fs::is_symlink(file("link")));
  EXPECT_EQ(content(file("real")), "new");
}

TEST_F(AtomicFileTest, AppearsWithCommit) {
  const std::string path = file("a.exr");
  AtomicFile out(path.c_str());
  EXPECT_EQ(out.path(), path);
  out.write("hello", 5);
  EXPECT_EQ(out.position(), 5u);
  EXPECT_FALSE(fs::exists(path));
  out.commit();
  EXPECT_EQ(content(path), "hello");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, SeeksBack) {
  AtomicFile out(file("a").c_str());
  out.write("0123456789", 10);
  out.seek(3);
  EXPECT_EQ(out.position(), 3u);
  out.write("xy", 2);
  EXPECT_EQ(out.position(), 5u);
  out.commit();
  EXPECT_EQ(content(file("a")), "012xy56789");
}

TEST_F(AtomicFileTest, WithoutCommitTheOldOneStays) {
  std::ofstream(file("a")) << "old";
  {
    AtomicFile out(file("a").c_str());
    out.write("new and longer", 14);
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(content(file("a")), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(AtomicFileTest, CommitReplaces) {
  std::ofstream(file("a")) << "old and longer";
  AtomicFile out(file("a").c_str());
  out.write("new", 3);
  out.commit();
  EXPECT_EQ(content(file("a")), "new");
}

TEST_F(AtomicFileTest, IsAsReadableAsTheUmaskSays) {
  const mode_t before = umask(027);
  AtomicFile out(file("a").c_str());
  out.commit();
  umask(before);
  struct stat status = {};
  ASSERT_EQ(stat(file("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(AtomicFileTest, IsNotMorePublicThanTheOneItReplaces) {
  std::ofstream(file("a")) << "old";
  ASSERT_EQ(chmod(file("a").c_str(), 0600), 0);
  AtomicFile out(file("a").c_str());
  out.write("new", 3);
  out.commit();
  struct stat status = {};
  ASSERT_EQ(stat(file("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0600u);
}

/// The umask is the process's: while it is asked for, which sets it, files of other threads have
/// none.
TEST_F(AtomicFileTest, LeavesTheUmaskAlone) {
  const int before = umaskCalls;
  AtomicFile(file("a").c_str()).commit();
  EXPECT_EQ(umaskCalls, before);
}

TEST_F(AtomicFileTest, AFolderThatIsNotThere) {
  const std::string path = file("no/such/a.exr");
  EXPECT_EQ(ioError([&] { AtomicFile out(path.c_str()); }),
            "can't create a file beside \"" + path + "\": No such file or directory");
}

TEST_F(AtomicFileTest, AFolderThatCannotBeWritten) {
  // Root may write anywhere but there.
  const char* path = geteuid() == 0 ? "/proc/self/a.exr" : "/a.exr";
  const std::string text = ioError([&] { AtomicFile out(path); });
  EXPECT_EQ(text.rfind("can't create a file beside \"" + std::string(path) + "\": ", 0), 0u)
      << text;
}

TEST_F(AtomicFileTest, APlaceThatBecomesAFolder) {
  const std::string text = ioError([&] {
    AtomicFile out(file("a").c_str());
    out.write("x", 1);
    fs::create_directory(file("a"));
    out.commit();
  });
  EXPECT_EQ(text, "can't replace \"" + file("a") + "\": Is a directory");
  EXPECT_EQ(files(), 1u) << "nothing is left behind";
}

TEST_F(AtomicFileTest, AFullDiskLeavesNothing) {
  // A limit on the size of files stands in for a full disk.
  std::ofstream(file("a")) << "old";
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 64 * 1024;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string block(10000, 'x');
  std::string text;
  {
    AtomicFile out(file("a").c_str());
    text = ioError([&] {
      for (int i = 0; i < 10; ++i) out.write(block.data(), block.size());
    });
    EXPECT_EQ(out.position(), 64u * 1024u) << "what there was room for";
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(text, "can't write \"" + file("a") + "\": File too large");
  EXPECT_EQ(content(file("a")), "old");
  EXPECT_EQ(files(), 1u);
}

}  // namespace
