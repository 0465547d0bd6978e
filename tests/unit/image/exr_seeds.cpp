// SPDX-License-Identifier: Apache-2.0
#include "exr_seeds.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "exr_files.h"

namespace awdtest {

std::vector<std::string> exrSeeds(const std::string& path) {
  using awd::test::FileKind;
  std::vector<std::string> files;
  const auto keep = [&] {
    std::ifstream file(path, std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  };
  FileKind kind;
  kind.width = 6;
  kind.height = 5;
  kind.type = Imf::HALF;
  for (const Imf::Compression compression : awd::test::compressions()) {
    kind.compression = compression;
    awd::test::writeScanlines(path, kind);
    keep();
  }
  kind.compression = Imf::ZIP_COMPRESSION;
  awd::test::writeTiles(path, kind, Imf::ONE_LEVEL);
  keep();
  awd::test::writeTiles(path, kind, Imf::RIPMAP_LEVELS);
  keep();
  awd::test::writeParts(path, kind);
  keep();
  kind.width = 8, kind.height = 6;
  awd::test::writeLumaChroma(path, kind, true);
  keep();
  kind.compression = Imf::ZIPS_COMPRESSION;
  for (const bool tiles : {false, true}) {
    awd::test::writeDeep(path, kind, tiles, awd::test::someSamples(kind));
    keep();
  }
  std::filesystem::remove(path);
  return files;
}

}  // namespace awdtest
