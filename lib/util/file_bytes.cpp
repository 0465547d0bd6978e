// SPDX-License-Identifier: Apache-2.0
#include "util/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "util/error.h"
#include "util/uncancelled.h"

namespace awd {

namespace {

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return value_; }

 private:
  int value_;
};

[[noreturn]] void cantRead(const char* path, const char* reason) {
  fail(AWD_ERROR_IO, "can't read \"%s\": %s", path, reason);
}

}  // namespace

std::pmr::vector<char> readFile(std::pmr::memory_resource* memory, const char* path) {
  const Uncancelled uncancelled;
  const Descriptor file(open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status;
  if (file.get() < 0 || fstat(file.get(), &status) != 0) cantRead(path, std::strerror(errno));
  if (S_ISDIR(status.st_mode)) cantRead(path, std::strerror(EISDIR));
  if (!S_ISREG(status.st_mode)) cantRead(path, "it is not a regular file");

  std::pmr::vector<char> bytes(static_cast<std::size_t>(status.st_size), memory);
  std::size_t filled = 0;
  while (filled < bytes.size()) {
    const ssize_t got = read(file.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) cantRead(path, std::strerror(errno));
    if (got == 0) cantRead(path, "it became shorter meanwhile");
    filled += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace awd
