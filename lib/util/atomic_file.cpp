// SPDX-License-Identifier: Apache-2.0
#include "util/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>

#include "util/error.h"
#include "util/random.h"

namespace awd {

namespace {

/// Of a temporary file's name: one that no other thread or process has at this time, or nearly so.
std::string otherEnding() {
  static std::atomic<uint64_t> calls{0};
  timespec now = {};
  clock_gettime(CLOCK_REALTIME, &now);
  uint64_t bits =
      mixBits(mixBits(static_cast<uint64_t>(getpid()) + ++calls) +
              static_cast<uint64_t>(now.tv_nsec) + (static_cast<uint64_t>(now.tv_sec) << 32));
  std::string ending = ".";
  for (int i = 0; i < 6; ++i, bits /= 26) ending += static_cast<char>('a' + bits % 26);
  return ending;
}

/// Whether it is on the disk. What can't be synced, such as a file in memory, is so as well.
bool synced(int descriptor) {
  while (fsync(descriptor) != 0) {
    if (errno == EINVAL) return true;
    if (errno != EINTR) return false;
  }
  return true;
}

}  // namespace

AtomicFile::AtomicFile(const char* path) : path_(path) {
  // A link stays one: what it leads to is replaced. A device or folder must not be replaced.
  if (const std::unique_ptr<char, void (*)(void*)> real{realpath(path, nullptr), std::free}) {
    path_ = real.get();
  }
  struct stat present = {};
  if (stat(path_.c_str(), &present) == 0 && !S_ISREG(present.st_mode)) {
    fail(AWD_ERROR_IO, "can't write \"%s\": it is not a file", path);
  }
  // mkstemp's files are private, and what the umask says can't be asked for without a moment in
  // which it says nothing to other threads. So this is as open() makes it; or as the old one was.
  do {
    temporary_ = path_ + otherEnding();
    descriptor_ = open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && (errno == EEXIST || errno == EINTR));
  if (descriptor_ < 0) failed("create a file beside");
  if (S_ISREG(present.st_mode)) fchmod(descriptor_, present.st_mode & 0777);
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
    if (written < 0 && errno == EINTR) continue;
    if (written == 0) errno = EIO;  // for ever, that is
    if (written <= 0) failed("write");
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
  if (!synced(descriptor_)) failed("write");
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) failed("replace");
  close(descriptor_);
  descriptor_ = -1;
  // What is in the file is on the disk; that it has this name now is in the folder.
  const int folder = open(path_.substr(0, path_.rfind('/') + 1).append(".").c_str(),
                          O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;  // one that may be written and not read can't be synced
  const bool kept = synced(folder);
  const int reason = errno;
  close(folder);
  if (kept) return;
  fail(AWD_ERROR_IO, "\"%s\" is written, but can't be made to last: %s", path_.c_str(),
       std::strerror(reason));
}

void AtomicFile::failed(const char* action) const {
  fail(AWD_ERROR_IO, "can't %s \"%s\": %s", action, path_.c_str(), std::strerror(errno));
}

}  // namespace awd
