// SPDX-License-Identifier: Apache-2.0
// What the fuzzers do, for inputs that are the same each time: seeds, changes of them, and all that
// was ever found.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mutate.h"
#include "support/soak.h"

namespace {

using fuzz::Input;
using fuzz::Target;

class FuzzTargets : public testing::TestWithParam<const Target*> {};

TEST_P(FuzzTargets, TakeSeedsAndChangesOfThem) {
  const Target& target = *GetParam();
  const std::vector<Input> seeds = target.seeds();
  ASSERT_FALSE(seeds.empty());
  for (const Input& seed : seeds) target.run(seed.data(), seed.size());
  awdtest::Random random(1999);
  for (long left = awdtest::soakSize(60, 20000); left > 0; --left) {
    const Input input = fuzz::mutated(seeds[random.bits() % seeds.size()], 1u << 16, random);
    target.run(input.data(), input.size());
  }
}

TEST_P(FuzzTargets, TakeWhatWasFound) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(AWD_FUZZ_REGRESSIONS) / GetParam()->name;
  if (!fs::exists(folder)) return;
  std::vector<fs::path> files(fs::directory_iterator(folder), fs::directory_iterator{});
  std::sort(files.begin(), files.end());
  for (const fs::path& path : files) {
    SCOPED_TRACE(path);
    std::ifstream file(path, std::ios::binary);
    const Input input(std::istreambuf_iterator<char>(file), {});
    GetParam()->run(input.data(), input.size());
  }
}

std::string nameOf(const testing::TestParamInfo<const Target*>& target) {
  std::string name = target.param->name;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, FuzzTargets, testing::Values(AWD_FUZZ_TARGETS), nameOf);

}  // namespace
