// SPDX-License-Identifier: Apache-2.0
// What the tests of images share: a context that counts its memory, a folder that goes away again,
// a full disk, and pictures with every kind of number.
#pragma once

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <vector>

#include "image/image.h"
#include "util/error.h"

namespace awd::test {

/// Counts what a context has allocated.
struct Counter {
  std::size_t now = 0, peak = 0;

  AWDDeviceDesc desc() {
    AWDDeviceDesc result = AWD_DEVICE_DESC_INIT;
    result.threads = 1;
    result.alloc = [](void* user, size_t size, size_t alignment) -> void* {
      auto& counter = *static_cast<Counter*>(user);
      void* place = ::operator new(size, std::align_val_t(alignment), std::nothrow);
      if (place) counter.now += size;
      counter.peak = std::max(counter.peak, counter.now);
      return place;
    };
    result.free = [](void* user, void* place, size_t size, size_t alignment) {
      static_cast<Counter*>(user)->now -= size;
      ::operator delete(place, std::align_val_t(alignment));
    };
    result.allocUser = this;
    return result;
  }
};

/// A context, and a folder for files. Fails if anything of the context is left over.
class ImageTest : public testing::Test {
 protected:
  ImageTest() {
    std::string pattern = testing::TempDir() + "awd-image-XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~ImageTest() override {
    std::filesystem::remove_all(folder_);
    context_ = {};
    EXPECT_EQ(counter_.now, 0u) << "memory was not given back";
  }

  Context& context() { return *context_; }
  std::string path(const char* name = "image.exr") const { return folder_ + "/" + name; }
  std::size_t fileCount() const {
    const std::filesystem::directory_iterator files(folder_);
    return static_cast<std::size_t>(std::distance(begin(files), end(files)));
  }

  Counter counter_;

 private:
  Ref<Context> context_ = Context::make(counter_.desc());
  std::string folder_;
};

inline std::string readBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void writeBytes(const std::string& path, const std::string& bytes) {
  // Some file systems wait for the disk when a file is truncated and written anew.
  std::filesystem::remove(path);
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<long>(bytes.size()));
}

/// The text of the error that `action` must end with.
template <class Action>
std::string errorOf(AWDResult code, Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

#define EXPECT_CONTAINS(text, part)                                                                \
  EXPECT_NE(std::string(text).find(part), std::string::npos) << (text)

/// No file can grow beyond `bytes`, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small = {bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  void (*handler_)(int);
  rlimit before_;
};

/// Numbers from every corner of float, in no pattern that compresses well.
inline std::vector<float> awkward(std::size_t count, uint32_t seed = 1) {
  using Limits = std::numeric_limits<float>;
  const float corners[] = {0.0f,
                           -0.0f,
                           Limits::infinity(),
                           -Limits::infinity(),
                           Limits::max(),
                           Limits::min(),
                           Limits::quiet_NaN(),
                           -1.5f,
                           Limits::denorm_min(),
                           -Limits::denorm_min(),
                           1e-40f,
                           65504.0f,
                           1e5f};
  std::vector<float> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    seed = seed * 1664525u + 1013904223u;
    numbers[i] = seed >> 30 ? static_cast<float>(seed) * 1e-7f
                            : corners[(seed >> 8) % (sizeof corners / sizeof corners[0])];
  }
  return numbers;
}

/// NaN equals NaN, and 0 is not -0.
inline bool sameBits(const Image::Pixels* a, const std::vector<float>& b) {
  return a && a->size() == b.size() && std::memcmp(a->data(), b.data(), 4 * b.size()) == 0;
}

}  // namespace awd::test
