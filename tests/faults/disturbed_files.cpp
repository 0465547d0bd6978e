// SPDX-License-Identifier: Apache-2.0
#include "faults/disturbed_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace {

struct Disturbance {
  size_t failing = 0, most = 0;
  int error = 0;
  bool interrupted = false;
  std::vector<std::string> calls;
};
thread_local Disturbance* disturbance = nullptr;

/// Notes a call; whether it fails, with errno set.
bool fails(const char* name) {
  Disturbance* const now = disturbance;
  if (!now) return false;
  disturbance = nullptr;  // while it is noted
  now->calls.emplace_back(name);
  disturbance = now;
  if (now->calls.size() == now->failing) {
    errno = now->error;
    return true;
  }
  if (now->most == 0 || std::string(name) == "rename") return false;
  now->interrupted = !now->interrupted;
  if (now->interrupted) errno = EINTR;
  return now->interrupted;
}

bool isFolder(int descriptor) {
  struct stat status = {};
  return fstat(descriptor, &status) == 0 && S_ISDIR(status.st_mode);
}

}  // namespace

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  if (fails("write")) return -1;
  const size_t most = disturbance && disturbance->most > 0 ? disturbance->most : count;
  return syscall(SYS_write, descriptor, bytes, std::min(count, most));
}

extern "C" int fsync(int descriptor) {
  if (fails(isFolder(descriptor) ? "fsync folder" : "fsync")) return -1;
  return static_cast<int>(syscall(SYS_fsync, descriptor));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  if (fails("rename")) return -1;
  return static_cast<int>(syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

namespace awdtest {

DisturbedFiles::DisturbedFiles() { disturbance = new Disturbance; }
DisturbedFiles::~DisturbedFiles() {
  delete disturbance;
  disturbance = nullptr;
}
void DisturbedFiles::failAt(size_t call, int error) {
  *disturbance = Disturbance();
  disturbance->failing = call;
  disturbance->error = error;
}
void DisturbedFiles::hamper(size_t most) {
  *disturbance = Disturbance();
  disturbance->most = most;
}
const std::vector<std::string>& DisturbedFiles::calls() { return disturbance->calls; }

}  // namespace awdtest
