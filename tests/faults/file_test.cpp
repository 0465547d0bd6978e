// SPDX-License-Identifier: Apache-2.0
// Disks that are full or broken, at each call of the system in turn: the old file stays, nothing is
// left beside it, and the call fails with a message.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>

#include "faults/disturbed_files.h"
#include "support/expect.h"
#include "support/films.h"
#include "support/scenes.h"
#include "support/soak.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Everything that writes files.
class Files : public testing::Test {
 protected:
  Files() {
    const AWDRenderDesc desc = renderDesc(camera_, AWD_GUIDE_ADAPTIVE, 1);
    render_ = newRender(scene_, desc);
    runPasses(render_, {2, 2});
    must(awdGetRenderField(render_, field_.out()));
    must(awdNewFilmImage(render_, image_.out()));
  }
  struct Writer {
    const char* name;
    std::function<AWDResult(const char* path)> write;
  };
  const std::vector<Writer> writers_ = {
      {"field", [this](const char* path) { return awdWriteField(field_, path); }},
      {"checkpoint", [this](const char* path) { return awdSaveRender(render_, path); }},
      {"exr", [this](const char* path) { return awdWriteImageEXR(image_, path); }},
      {"png", [this](const char* path) { return awdWriteImagePNG(image_, path, nullptr); }}};

  const Device device_ = newDevice(1u);
  const Scene scene_ = lampRoom().commit(device_);
  const AWDCamera camera_ = lampRoomCamera(40);
  Render render_;
  Field field_;
  Image image_;
  const TemporaryFolder folder_;
  const std::string path_ = folder_.path("a.file");
};

TEST_F(Files, AreSyncedThenRenamedThenTheirFolderIsSynced) {
  for (const Writer& writer : writers_) {
    SCOPED_TRACE(writer.name);
    const DisturbedFiles files;
    must(writer.write(path_.c_str()));
    std::vector<std::string> calls = DisturbedFiles::calls();
    calls.erase(std::unique(calls.begin(), calls.end()), calls.end());
    EXPECT_EQ(calls, (std::vector<std::string>{"write", "fsync", "rename", "fsync folder"}));
    EXPECT_EQ(folder_.files(), 1u);
  }
}

TEST_F(Files, AreOldOrNewWhateverFails) {
  const std::string old = "what was here before";
  for (const Writer& writer : writers_) {
    must(writer.write(path_.c_str()));
    const std::string whole = contentOf(path_);
    size_t calls = 0;
    {
      const DisturbedFiles files;
      must(writer.write(path_.c_str()));
      calls = DisturbedFiles::calls().size();
    }
    const size_t step = std::max<size_t>(1, soakSize(calls / 12, 1));
    for (const int error : {ENOSPC, EIO, EDQUOT}) {
      for (size_t n = 1; n <= calls; n += n + 4 < calls ? step : 1) {
        SCOPED_TRACE(std::string(writer.name) + ", call " + std::to_string(n));
        std::ofstream(path_, std::ios::binary) << old;
        const DisturbedFiles files;
        DisturbedFiles::failAt(n, error);
        expectFailure(writer.write(path_.c_str()), AWD_ERROR_IO, {path_, std::strerror(error)});
        EXPECT_EQ(folder_.files(), 1u);
        EXPECT_TRUE(contentOf(path_) == (n < calls ? old : whole)) << "a half file";
      }
    }
  }
}

TEST_F(Files, AreWholeThoughWritesAreShortAndInterrupted) {
  for (const Writer& writer : writers_) {
    SCOPED_TRACE(writer.name);
    must(writer.write(path_.c_str()));
    const std::string whole = contentOf(path_);
    {
      const DisturbedFiles files;
      DisturbedFiles::hamper(97);
      must(writer.write(path_.c_str()));
      EXPECT_GT(DisturbedFiles::calls().size(), whole.size() / 97);
    }
    EXPECT_TRUE(contentOf(path_) == whole);
  }
}

/// The kernel's own short write and error: what fits is written before.
TEST_F(Files, StayOldBeyondTheLargestSizeAllowed) {
  rlimit before = {};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  for (const Writer& writer : writers_) {
    SCOPED_TRACE(writer.name);
    must(writer.write(path_.c_str()));
    const std::string whole = contentOf(path_);
    for (const size_t most : {size_t{0}, size_t{1}, whole.size() / 2, whole.size() - 1}) {
      std::ofstream(path_, std::ios::binary) << "old";
      rlimit small = before;
      small.rlim_cur = most;
      ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
      const AWDResult result = writer.write(path_.c_str());
      setrlimit(RLIMIT_FSIZE, &before);
      expectFailure(result, AWD_ERROR_IO, {path_});
      EXPECT_EQ(contentOf(path_), "old");
      EXPECT_EQ(folder_.files(), 1u);
    }
  }
  std::signal(SIGXFSZ, handler);
}

TEST_F(Files, AreNotWrittenToPlacesThatAreNone) {
  const std::string folder = folder_.path("folder"), none = folder_.path("none/a.file");
  std::filesystem::create_directory(folder);
  for (const Writer& writer : writers_) {
    SCOPED_TRACE(writer.name);
    for (const std::string& path :
         {folder, none, std::string("/dev/full"), std::string("/dev/null"),
          std::string("/proc/self/a.file"), std::string("")}) {
      expectFailure(writer.write(path.c_str()), AWD_ERROR_IO, {path});
    }
    expectFailure(writer.write(nullptr), AWD_ERROR_INVALID_ARGUMENT, {"path"});
    EXPECT_EQ(folder_.files(), 1u);
  }
}

}  // namespace
