// SPDX-License-Identifier: Apache-2.0
// Calls of every function in any order with wild arguments: a result and a message each, and the
// library is none the worse for it.
#include "misuse/sequence.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/soak.h"

namespace {

using namespace awdmisuse;

TEST(Sequences, EndWellWhateverTheCalls) {
  constexpr size_t kCalls = 100;
  const long sequences = awdtest::soakSize(40, 12000);
  World world;
  size_t bases = 0;  // looked for once and not in every child
  for (const AWDDevice device : world.devices) awdGetBasisCount(device, &bases);
  const std::vector<double> reference = referenceBits(world.devices[0]);
  ASSERT_EQ(referenceBits(world.devices[0]), reference);
  EXPECT_GT(*std::max_element(reference.end() - 36, reference.end()), 0.0) << "a black film";
  int failures = 0;
  for (long seed = 0; seed < sequences && failures < 3; ++seed) {
    const std::vector<Step> steps = randomSteps(static_cast<uint64_t>(seed), kCalls);
    if (runSteps(world, steps, reference).complaint.empty()) continue;
    ++failures;
    const Outcome least = runSteps(world, shrink(world, steps, reference), reference);
    ADD_FAILURE() << "seed " << seed << ": " << least.complaint << "\n" << least.calls;
  }
}

}  // namespace
