// SPDX-License-Identifier: Apache-2.0
#include "util/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "util/error.h"

namespace awd {

AtomicFile::AtomicFile(const char* path) : path_(path) {
  // A link stays one: what it leads to is replaced. A device or folder must not be replaced.
  if (const std::unique_ptr<char, void (*)(void*)> real{realpath(path, nullptr), std::free}) {
    path_ = real.get();
  }
  struct stat present = {};
  if (stat(path_.c_str(), &present) == 0 && !S_ISREG(present.st_mode)) {
    fail(AWD_ERROR_IO, "can't write \"%s\": it is not a file", path);
  }
  temporary_ = path_ + ".XXXXXX";
  descriptor_ = mkostemp(temporary_.data(), O_CLOEXEC);
  if (descriptor_ < 0) failed("create a file beside");
  // mkstemp makes private files; ours are as public as the umask says.
  const mode_t mask = umask(0);
  umask(mask);
  fchmod(descriptor_, 0666 & ~mask);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  unlink(temporary_.c_str());
}

void AtomicFile::write(const void* data, std::size_t bytes) {
  const char* next = static_cast<const char*>(data);
  while (bytes > 0) {
    const ssize_t written = ::write(descriptor_, next, bytes);
    if (written < 0) {
      if (errno == EINTR) continue;
      failed("write");
    }
    next += written;
    bytes -= static_cast<std::size_t>(written);
    position_ += static_cast<uint64_t>(written);
  }
}

void AtomicFile::seek(uint64_t position) {
  if (lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) failed("seek in");
  position_ = position;
}

void AtomicFile::commit() {
  if (fsync(descriptor_) != 0 && errno != EINVAL) failed("write");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) failed("replace");
  close(descriptor_);
  descriptor_ = -1;
}

void AtomicFile::failed(const char* action) const {
  fail(AWD_ERROR_IO, "can't %s \"%s\": %s", action, path_.c_str(), std::strerror(errno));
}

}  // namespace awd
