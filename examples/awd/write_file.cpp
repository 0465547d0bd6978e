// SPDX-License-Identifier: Apache-2.0
#include "write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "failure.h"

namespace command {
namespace {

/// A new file beside its final place, which goes away unless it is renamed into it.
class Temporary {
 public:
  explicit Temporary(const std::string& path) : path_(path), name_(path + ".XXXXXX") {
    descriptor_ = mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ < 0) failed();
  }
  ~Temporary() {
    close(descriptor_);
    if (!renamed_) unlink(name_.c_str());
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  void write(const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t written = ::write(descriptor_, text.data() + done, text.size() - done);
      if (written >= 0) {
        done += static_cast<std::size_t>(written);
      } else if (errno != EINTR) {
        failed();
      }
    }
  }

  void rename() {
    // Temporary files are private; this one is to be what any other new file would be.
    const mode_t mask = umask(0);
    umask(mask);
    if (fchmod(descriptor_, 0666 & ~mask) != 0 || fsync(descriptor_) != 0 ||
        std::rename(name_.c_str(), path_.c_str()) != 0) {
      failed();
    }
    renamed_ = true;
  }

 private:
  [[noreturn]] void failed() const {
    throw Failure("can't write " + inQuotes(path_) + ": " + std::strerror(errno));
  }

  std::string path_, name_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

}  // namespace

void checkWritable(const std::string& path) {
  if (path.empty() || path.back() == '/') {
    throw Failure("can't write " + inQuotes(path) + ": that is no name of a file");
  }
  struct stat status;
  // Renaming into a device such as /dev/null would replace it.
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {
    throw Failure("can't write " + inQuotes(path) + ": it exists and is not a regular file");
  }
  Temporary probe(path);
}

void checkApart(const NamedFile& one, const NamedFile& other) {
  std::error_code error;
  const auto place = [&](const std::string& path) {
    const std::filesystem::path known =
        std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
    return error ? std::filesystem::path(path) : known;
  };
  if (place(one.path) != place(other.path) &&
      !std::filesystem::equivalent(one.path, other.path, error)) {
    return;
  }
  throw UsageError(std::string(one.what) + " and " + other.what + " are one file, " +
                   inQuotes(one.path));
}

void writeFile(const std::string& path, const std::string& text) {
  std::error_code error;
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  Temporary file(error ? path : target.string());  // what a link leads to, not the link
  file.write(text);
  file.rename();
}

}  // namespace command
