// SPDX-License-Identifier: Apache-2.0
#include "basis/library_folder.h"

#include <dlfcn.h>
#include <link.h>

#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

#include "util/uncancelled.h"

namespace awd {

namespace {

const char anchor = 0;  // lies in the file that we look for

/// The file mapped at our address, as the kernel knows it.
std::string mappedFile() {
  const auto address = reinterpret_cast<std::uintptr_t>(&anchor);
  std::ifstream maps("/proc/self/maps");
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR, &begin, &end) != 2) continue;
    const std::size_t path = line.find('/');
    if (begin <= address && address < end && path != std::string::npos) return line.substr(path);
  }
  return "";
}

}  // namespace

std::string libraryFolder() {
  const Uncancelled uncancelled;
  std::string file;
  Dl_info info = {};
  void* extra = nullptr;
  if (dladdr1(&anchor, &info, &extra, RTLD_DL_LINKMAP) != 0 && extra) {
    // The name is that of the call that loaded it: it may be relative, and is empty for a program.
    const char* name = static_cast<const link_map*>(extra)->l_name;
    if (name && name[0] == '/') {
      const std::unique_ptr<char, void (*)(void*)> real(realpath(name, nullptr), std::free);
      file = real ? real.get() : name;
    }
  }
  if (file.empty()) file = mappedFile();
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "" : file.substr(0, slash);
}

}  // namespace awd
