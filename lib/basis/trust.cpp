// SPDX-License-Identifier: Apache-2.0
#include "basis/trust.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace awd {

std::string distrust(const std::string& file) {
  if (file.empty() || file[0] != '/') return "not absolute";
  const std::unique_ptr<char, void (*)(void*)> real(realpath(file.c_str(), nullptr), std::free);
  struct stat status = {};
  if (!real || stat(real.get(), &status) != 0) {
    return errno == ENOENT ? "does not exist"
                           : std::string("can't be read: ") + std::strerror(errno);
  }
  if (!S_ISREG(status.st_mode)) return "is not a file";
  if (status.st_mode & S_IWOTH) {
    return "anybody may write to it: take that right away (chmod o-w)";
  }
  std::string folder = real.get();
  folder.resize(std::max<std::size_t>(folder.rfind('/'), 1));
  if (stat(folder.c_str(), &status) != 0) {
    return "its folder can't be read: " + std::string(std::strerror(errno));
  }
  if (status.st_mode & S_IWOTH) {
    return "it lies in \"" + folder + "\", to which anybody may write: take that right away";
  }
  return "";
}

}  // namespace awd
