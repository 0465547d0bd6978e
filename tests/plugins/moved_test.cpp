// SPDX-License-Identifier: Apache-2.0
// libawd.so copied elsewhere and opened there, as a host does that brings its own copy.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "awd/device.h"
#include "awd/field.h"

namespace {

namespace fs = std::filesystem;

class Moved : public testing::Test {
 protected:
  void SetUp() override {
    std::string path = (fs::temp_directory_path() / "awd-XXXXXX").string();
    ASSERT_NE(mkdtemp(path.data()), nullptr);
    folder_ = path;
    fs::copy(AWD_LIBRARY_FILE, folder_ / "libawd.so.1");
  }
  void TearDown() override {
    if (releaseDevice_) releaseDevice_(device_);
    fs::remove_all(folder_);
  }

  void open(const fs::path& file) {
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    const auto newDevice =
        reinterpret_cast<decltype(&awdNewDevice)>(dlsym(library, "awdNewDevice"));
    newField_ = reinterpret_cast<decltype(&awdNewField)>(dlsym(library, "awdNewField"));
    message_ = reinterpret_cast<decltype(&awdGetLastErrorMessage)>(
        dlsym(library, "awdGetLastErrorMessage"));
    releaseField_ = reinterpret_cast<decltype(&awdReleaseField)>(dlsym(library, "awdReleaseField"));
    releaseDevice_ =
        reinterpret_cast<decltype(&awdReleaseDevice)>(dlsym(library, "awdReleaseDevice"));
    AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
    desc.flags = AWD_DEVICE_IGNORE_ENVIRONMENT;
    ASSERT_EQ(newDevice(&desc, &device_), AWD_SUCCESS) << message_();
  }

  AWDResult newField(AWDFieldDesc desc = AWD_FIELD_DESC_INIT) {
    AWDField field = nullptr;
    desc.basis = "haar";
    const AWDResult result = newField_(device_, &desc, &field);
    releaseField_(field);
    return result;
  }

  fs::path folder_;
  AWDDevice device_ = nullptr;
  decltype(&awdNewField) newField_ = nullptr;
  decltype(&awdGetLastErrorMessage) message_ = nullptr;
  decltype(&awdReleaseField) releaseField_ = nullptr;
  decltype(&awdReleaseDevice) releaseDevice_ = nullptr;
};

TEST_F(Moved, WithoutModulesTheErrorNamesTheFolder) {
  open(folder_ / "libawd.so.1");
  ASSERT_EQ(newField(), AWD_ERROR_UNSUPPORTED);
  EXPECT_EQ(message_(), "awdNewField: there is no basis \"haar\"; there are none; looked in \"" +
                            fs::canonical(folder_).string() + "/awd/bases-1\" (does not exist)");
}

TEST_F(Moved, WithADeletedModuleTheErrorNamesTheFolder) {
  fs::create_directories(folder_ / "awd/bases-1");
  open(folder_ / "libawd.so.1");
  ASSERT_EQ(newField(), AWD_ERROR_UNSUPPORTED);
  EXPECT_NE(std::string(message_()).find("/awd/bases-1\" (has no .so file)"), std::string::npos)
      << message_();
}

TEST_F(Moved, ModulesMoveWithTheLibrary) {
  fs::create_directories(folder_ / "awd/bases-1");
  fs::copy(AWD_HAAR_FILE, folder_ / "awd/bases-1/haar.so");
  open(folder_ / "libawd.so.1");
  EXPECT_EQ(newField(), AWD_SUCCESS) << message_();
}

TEST_F(Moved, WithoutTheRefitModuleAllElseWorks) {
  fs::create_directories(folder_ / "awd/bases-1");
  fs::copy(AWD_HAAR_FILE, folder_ / "awd/bases-1/haar.so");
  open(folder_ / "libawd.so.1");
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.estimator = AWD_ESTIMATOR_REFIT;
  ASSERT_EQ(newField(desc), AWD_ERROR_UNSUPPORTED);
  EXPECT_EQ(message_(), "awdNewField: the estimator refit wants the refit module; tried \"" +
                            fs::canonical(folder_).string() + "/awd/refit-1.so\" (does not exist)");
  desc.estimator = AWD_ESTIMATOR_QUASI;
  EXPECT_EQ(newField(desc), AWD_SUCCESS) << message_();
}

TEST_F(Moved, OpenedByARelativePathItStillFindsItsOwn) {
  fs::create_directories(folder_ / "awd/bases-1");
  fs::copy(AWD_HAAR_FILE, folder_ / "awd/bases-1/haar.so");
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  open("./libawd.so.1");
  fs::current_path(before);
  EXPECT_EQ(newField(), AWD_SUCCESS) << message_();
}

}  // namespace
