// SPDX-License-Identifier: Apache-2.0
// Where modules are looked for, in which order, and what a host is told when one is not there.
#include <sys/stat.h>

#include <cstdlib>

#include "honest.h"
#include "support.h"

namespace {

namespace fs = std::filesystem;

/// A device that looks in `folders` first.
class Searching {
 public:
  explicit Searching(std::vector<std::string> folders, uint32_t flags = 0)
      : folders_(std::move(folders)) {
    for (const std::string& folder : folders_) paths_.push_back(folder.c_str());
    AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
    desc.flags = flags;
    desc.basisPaths = paths_.data();
    desc.basisPathCount = paths_.size();
    device_ = std::make_unique<test::Device>(&desc);
  }
  operator AWDDevice() const { return *device_; }

 private:
  std::vector<std::string> folders_;
  std::vector<const char*> paths_;
  std::unique_ptr<test::Device> device_;
};

/// $AWD_BASIS_PATH for a while.
class Environment {
 public:
  explicit Environment(const std::string& value) { setenv("AWD_BASIS_PATH", value.c_str(), 1); }
  ~Environment() { unsetenv("AWD_BASIS_PATH"); }
};

std::string missing(AWDDevice device, const char* name) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = name;
  AWDField field = nullptr;
  EXPECT_EQ(awdNewField(device, &desc, &field), AWD_ERROR_UNSUPPORTED);
  EXPECT_EQ(field, nullptr);
  return awdGetLastErrorMessage();
}

TEST(Search, BesideTheLibrary) {
  const test::Device device;
  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].name, "haar");
  EXPECT_EQ(lines[0].file, AWD_HAAR_FILE);
}

TEST(Search, AMissingFamilyNamesWhatThereIsAndWhereItLooked) {
  const test::Folder empty;
  const Searching device({empty.path(), empty / "nothing"});
  const std::string message = missing(device, "no-such-basis");
  const std::string own = fs::path(AWD_HAAR_FILE).parent_path();
  EXPECT_EQ(message,
            "awdNewField: there is no basis \"no-such-basis\"; there are f2, haar, "
            "linear-bspline, linear-bspline-periodic, m2, m3, quadratic-bspline, "
            "quadratic-bspline-periodic; "
            "looked in \"" +
                empty.path() + "\" (has no .so file), \"" + (empty / "nothing") +
                "\" (does not exist), \"" + own + "\"");
}

TEST(Search, AMissingFamilyNamesRefusedCandidates) {
  const test::Folder folder;
  fs::copy(AWD_LYING_FOLDER "/weight.so", folder / "weight.so");
  const Searching device({folder.path()});
  const std::string message = missing(device, "liar");
  EXPECT_TRUE(test::contains(
      message, "refused \"" + (folder / "weight.so") + "\": weight is not the integral: level 1"))
      << message;
}

TEST(Search, DeviceThenEnvironmentThenLibrary) {
  const test::Folder first, second;
  fs::copy(AWD_LYING_FOLDER "/none.so", first / "b.so");
  fs::copy(AWD_LYING_FOLDER "/none.so", second / "a.so");
  fs::copy(AWD_HAAR_FILE, second / "haar.so");
  const Environment environment(second.path());
  const Searching device({first.path()});
  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].name, "haar");
  EXPECT_EQ(lines[0].file, second / "haar.so");
  EXPECT_EQ(lines[1].name, "truthful");
  EXPECT_EQ(lines[1].file, first / "b.so");
  for (std::size_t i = 2; i < 4; ++i) {
    EXPECT_EQ(lines[i].status, AWD_ERROR_PLUGIN_NAME_TAKEN);
    EXPECT_TRUE(test::contains(lines[i].message, "the name is taken by \"")) << lines[i].message;
  }
}

TEST(Search, TheEnvironmentCanBeForbidden) {
  const test::Folder folder;
  fs::copy(AWD_LYING_FOLDER "/none.so", folder / "liar.so");
  const Environment environment(folder.path());
  EXPECT_EQ(test::names(Searching({})), "haar truthful");
  EXPECT_EQ(test::names(Searching({}, AWD_DEVICE_IGNORE_ENVIRONMENT)), "haar");
}

TEST(Search, NeverInTheCurrentFolder) {
  const test::Folder folder;
  fs::create_directories(folder / "awd/bases-1");
  for (const char* place : {"liar.so", "awd/bases-1/liar.so"}) {
    fs::copy(AWD_LYING_FOLDER "/none.so", folder / place);
  }
  const fs::path before = fs::current_path();
  fs::current_path(folder.path());
  {
    const Environment environment(":.:awd/bases-1::");
    const Searching device({});
    EXPECT_EQ(test::names(device), "haar");
    const std::string message = missing(device, "truthful");
    EXPECT_TRUE(test::contains(message, "\"awd/bases-1\" (not absolute, left out)")) << message;
  }
  fs::current_path(before);
}

TEST(Search, FoldersAreReadAtTheFirstQuestion) {
  const test::Folder folder;
  const Searching device({folder.path()});
  fs::copy(AWD_LYING_FOLDER "/none.so", folder / "liar.so");
  EXPECT_EQ(test::names(device), "haar truthful");
  fs::copy(AWD_HAAR_FILE, folder / "haar.so");
  EXPECT_EQ(test::listing(device).size(), 2u);
}

TEST(Search, AFileThatAnybodyMayWriteIsRefused) {
  const test::Folder folder;
  const std::string file = folder / "liar.so";
  fs::copy(AWD_LYING_FOLDER "/none.so", file);
  ASSERT_EQ(chmod(file.c_str(), 0777), 0);
  const Searching device({folder.path()});
  EXPECT_EQ(test::names(device), "haar");
  ASSERT_EQ(test::listing(device).size(), 2u);
  EXPECT_EQ(test::listing(device)[1].status, AWD_ERROR_PLUGIN_LOAD);
  EXPECT_TRUE(test::contains(test::listing(device)[1].message, "anybody may write to it"));
  // Whoever names the file has chosen it.
  EXPECT_EQ(awdLoadBasisModule(device, file.c_str()), AWD_SUCCESS);
}

TEST(Search, AFolderThatAnybodyMayWriteIsLeftOut) {
  const test::Folder folder;
  fs::copy(AWD_LYING_FOLDER "/none.so", folder / "liar.so");
  ASSERT_EQ(chmod(folder.path().c_str(), 01777), 0);
  const Searching device({folder.path()});
  EXPECT_EQ(test::names(device), "haar");
  const std::string message = missing(device, "truthful");
  EXPECT_TRUE(
      test::contains(message, "\"" + folder.path() + "\" (anybody may write to it, left out)"))
      << message;
}

TEST(Search, AFileThatReallyLiesWhereAnybodyMayWriteIsRefused) {
  const test::Folder folder, open;
  fs::copy(AWD_LYING_FOLDER "/none.so", open / "liar.so");
  fs::create_symlink(open / "liar.so", folder / "liar.so");
  ASSERT_EQ(chmod(open.path().c_str(), 01777), 0);
  const Searching device({folder.path()});
  EXPECT_EQ(test::names(device), "haar");
  ASSERT_EQ(test::listing(device).size(), 2u);
  EXPECT_EQ(test::listing(device)[1].status, AWD_ERROR_PLUGIN_LOAD);
  EXPECT_TRUE(test::contains(test::listing(device)[1].message, "to which anybody may write"));
}

TEST(Search, FamiliesThatNobodyAsksForAreNotTested) {
  const test::Folder folder;
  fs::copy(AWD_LYING_FOLDER "/weight.so", folder / "weight.so");
  const std::string path = folder.path();
  const char* const paths[] = {path.c_str()};
  std::vector<std::string> log;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.basisPaths = paths;
  desc.basisPathCount = 1;
  desc.logUser = &log;
  desc.log = [](void* user, int32_t, const char* text) {
    static_cast<std::vector<std::string>*>(user)->push_back(text);
  };
  const test::Device device(&desc);
  AWDFieldDesc field = AWD_FIELD_DESC_INIT;
  AWDField made = nullptr;
  EXPECT_EQ(awdNewField(device, &field, &made), AWD_SUCCESS) << awdGetLastErrorMessage();
  awdReleaseField(made);
  EXPECT_TRUE(log.empty()) << log[0];
  EXPECT_EQ(test::names(device), "haar");
  EXPECT_EQ(log.size(), 1u);
}

TEST(Search, WhoeverBringsItsBasesNeedsNoFolder) {
  const test::Folder folder;
  std::ofstream(folder / "text.so") << "no module, and a warning to whoever looks";
  const Environment environment(folder.path());
  int warnings = 0;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.logUser = &warnings;
  desc.log = [](void* user, int32_t, const char*) { ++*static_cast<int*>(user); };
  const test::Device device(&desc);
  ASSERT_EQ(awdRegisterBasisModule(device, honestModule()), AWD_SUCCESS);
  AWDFieldDesc field = AWD_FIELD_DESC_INIT;
  field.basis = "test-linear";
  AWDField made = nullptr;
  EXPECT_EQ(awdNewField(device, &field, &made), AWD_SUCCESS) << awdGetLastErrorMessage();
  awdReleaseField(made);
  EXPECT_EQ(warnings, 0);
  test::listing(device);
  EXPECT_EQ(warnings, 1);
}

TEST(Search, AFoundFamilyHoldsItsNameBeforeItIsAskedFor) {
  const test::Folder folder;
  for (const char* name : {"a.so", "b.so"}) fs::copy(AWD_LYING_FOLDER "/none.so", folder / name);
  const Searching device({folder.path()});
  AWDField made = nullptr;
  EXPECT_EQ(awdNewField(device, nullptr, &made), AWD_SUCCESS);  // has looked, for haar
  awdReleaseField(made);
  EXPECT_EQ(awdLoadBasisModule(device, (folder / "b.so").c_str()), AWD_ERROR_PLUGIN_NAME_TAKEN);
  EXPECT_TRUE(test::contains(awdGetLastErrorMessage(), "is taken by \"" + (folder / "a.so")));
  EXPECT_EQ(awdLoadBasisModule(device, (folder / "a.so").c_str()), AWD_SUCCESS);
}

TEST(Search, OnlyFilesThatEndInSo) {
  const test::Folder folder;
  fs::copy(AWD_LYING_FOLDER "/none.so", folder / "liar.so.bak");
  fs::copy(AWD_LYING_FOLDER "/none.so", folder / ".so");
  fs::create_directory(folder / "folder.so");
  std::ofstream(folder / "README");
  fs::create_symlink("nowhere", folder / "dangling.so");
  const Searching device({folder.path()});
  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[1].file, folder / "dangling.so");
  EXPECT_EQ(lines[1].message, "does not exist");
  EXPECT_EQ(lines[2].file, folder / "folder.so");
  EXPECT_EQ(lines[2].message, "is not a file");
}

TEST(Search, AFolderGivenTwiceIsNoConflict) {
  const std::string own = fs::path(AWD_HAAR_FILE).parent_path();
  EXPECT_EQ(test::listing(Searching({own, own})).size(), 1u);
}

TEST(Search, TheHostMayAskFromItsLog) {
  const test::Folder folder;
  std::ofstream(folder / "text.so") << "no module";
  const std::string path = folder.path();
  const char* const paths[] = {path.c_str()};
  struct Host {
    AWDDevice device = nullptr;
    int calls = 0;
  } host;
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.basisPaths = paths;
  desc.basisPathCount = 1;
  desc.logUser = &host;
  desc.log = [](void* user, int32_t, const char*) {
    auto& h = *static_cast<Host*>(user);
    ++h.calls;
    EXPECT_EQ(test::listing(h.device).size(), 2u);  // would deadlock if a lock were held
  };
  const test::Device device(&desc);
  host.device = device;
  EXPECT_EQ(test::names(device), "haar");
  EXPECT_EQ(host.calls, 1);
}

}  // namespace
