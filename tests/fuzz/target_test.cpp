// SPDX-License-Identifier: Apache-2.0
// What the fuzzers do, for inputs that are the same each time: seeds, changes of them, and all that
// was ever found.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

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

/// Folders of the command's targets count only where it is built.
TEST(Regressions, AreTakenByTheirTargets) {
  namespace fs = std::filesystem;
  std::map<std::string, const Target*> targets = {
      {"obj", nullptr}, {"gltf", nullptr}, {"camera-file", nullptr}};
  for (const Target* target : {AWD_FUZZ_TARGETS}) targets[target->name] = target;
  size_t taken = 0;
  for (const fs::directory_entry& file : fs::recursive_directory_iterator(AWD_FUZZ_REGRESSIONS)) {
    if (!file.is_regular_file()) continue;
    SCOPED_TRACE(file.path());
    const auto target = targets.find(file.path().parent_path().filename());
    ASSERT_NE(target, targets.end()) << "no target has the name of its folder";
    if (!target->second) continue;
    std::ifstream stream(file.path(), std::ios::binary);
    const Input input(std::istreambuf_iterator<char>(stream), {});
    ASSERT_FALSE(input.empty());
    target->second->run(input.data(), input.size());
    ++taken;
  }
  EXPECT_GT(taken, 0u);
}

std::string nameOf(const testing::TestParamInfo<const Target*>& target) {
  std::string name = target.param->name;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, FuzzTargets, testing::Values(AWD_FUZZ_TARGETS), nameOf);

}  // namespace
