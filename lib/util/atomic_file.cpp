// SPDX-License-Identifier: Apache-2.0
#include "util/atomic_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "util/error.h"

namespace awd {

namespace {

/// Opens a new file with a name that nothing has yet, as public as the process makes its files:
/// mkstemp makes private ones, and to ask for the umask is to set it, for all threads.
int createBeside(const std::string& path, std::string& made) {
  constexpr int kAttempts = 100;
  constexpr char kDigits[] = "0123456789abcdefghijklmnopqrstuv";
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    unsigned char random[8] = {};
    if (getrandom(random, sizeof random, 0) < 0) return -1;
    made = path + '.';
    for (const unsigned char byte : random) made += kDigits[byte % (sizeof kDigits - 1)];
    const int descriptor = open(made.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0 || errno != EEXIST) return descriptor;
  }
  return -1;
}

/// That a file has another name now is known to the disk only when its folder is. If it can't be
/// synced, what was written is there all the same.
void syncFolderOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(const char* path) : path_(path) {
  // A link stays one: what it leads to is replaced. A device or folder must not be replaced.
  if (const std::unique_ptr<char, void (*)(void*)> real{realpath(path, nullptr), std::free}) {
    path_ = real.get();
  }
  struct stat present = {};
  const bool replaces = stat(path_.c_str(), &present) == 0;
  if (replaces && !S_ISREG(present.st_mode)) {
    fail(AWD_ERROR_IO, "can't write \"%s\": it is not a file", path);
  }
  descriptor_ = createBeside(path_, temporary_);
  if (descriptor_ < 0) failed("create a file beside");
  // Whoever might not read the old one might not read the new one either.
  if (replaces) fchmod(descriptor_, present.st_mode & 0777);
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
  syncFolderOf(path_);
}

void AtomicFile::failed(const char* action) const {
  fail(AWD_ERROR_IO, "can't %s \"%s\": %s", action, path_.c_str(), std::strerror(errno));
}

}  // namespace awd
