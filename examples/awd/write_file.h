// SPDX-License-Identifier: Apache-2.0
// Files that are there whole or not at all, and a look ahead at whether they can be written.
#pragma once

#include <string>

namespace command {

/// Throws a Failure if no file can be made in the folder of `path`, or if something else than a
/// file has that name. Meant for before the work: writing may still fail after it.
void checkWritable(const std::string& path);

/// A file, and what the user has called it for.
struct NamedFile {
  const char* what;
  std::string path;
};

/// Throws a UsageError if both are one file, by whatever path.
void checkApart(const NamedFile& one, const NamedFile& other);

/// Writes beside `path`, or beside what it leads to if it is a link, then renames into it. Throws a
/// Failure that names the path.
void writeFile(const std::string& path, const std::string& text);

}  // namespace command
