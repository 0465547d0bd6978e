// SPDX-License-Identifier: Apache-2.0
// What the tests of plugins share: a device, a temporary folder, the listing.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "awd/awd.h"

namespace test {

/// A device that goes with the scope.
class Device {
 public:
  explicit Device(const AWDDeviceDesc* desc = nullptr) {
    EXPECT_EQ(awdNewDevice(desc, &handle_), AWD_SUCCESS) << awdGetLastErrorMessage();
  }
  ~Device() { awdReleaseDevice(handle_); }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
  operator AWDDevice() const { return handle_; }

 private:
  AWDDevice handle_ = nullptr;
};

/// A folder that goes with the scope.
class Folder {
 public:
  Folder() {
    std::string path = (std::filesystem::temp_directory_path() / "awd-XXXXXX").string();
    if (!mkdtemp(path.data())) ADD_FAILURE() << "no temporary folder";
    path_ = path;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A line of the listing, copied.
struct Info {
  std::string name, file, message;
  AWDResult status;
  uint32_t flags, order, minLevel, maxLevel;
};

/// Without the families that lie beside Haar's in the build: these tests are about others.
inline std::vector<Info> listing(AWDDevice device) {
  const std::filesystem::path own = std::filesystem::path(AWD_HAAR_FILE).parent_path();
  std::size_t count = 0;
  EXPECT_EQ(awdGetBasisCount(device, &count), AWD_SUCCESS) << awdGetLastErrorMessage();
  std::vector<Info> lines;
  for (std::size_t i = 0; i < count; ++i) {
    AWDBasisInfo info = AWD_BASIS_INFO_INIT;
    EXPECT_EQ(awdGetBasisInfo(device, i, &info), AWD_SUCCESS) << awdGetLastErrorMessage();
    const std::filesystem::path file = info.file;
    if (file.parent_path() == own && file != AWD_HAAR_FILE) continue;
    lines.push_back({info.name, info.file, info.message, info.status, info.flags, info.order,
                     info.minLevel, info.maxLevel});
  }
  return lines;
}

/// The names that can be used, joined.
inline std::string names(AWDDevice device) {
  std::string text;
  for (const Info& line : listing(device)) {
    if (line.status == AWD_SUCCESS) text += (text.empty() ? "" : " ") + line.name;
  }
  return text;
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace test
