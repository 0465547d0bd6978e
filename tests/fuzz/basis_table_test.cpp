// SPDX-License-Identifier: Apache-2.0
// What the fuzzer does, for a few thousand inputs that are the same each time.
#include <gtest/gtest.h>

#include <vector>

#include "basis_use.h"
#include "support/random.h"

namespace {

using fuzz::Outcome;

Outcome tryBytes(const std::vector<uint8_t>& bytes) {
  return fuzz::tryTable(bytes.data(), bytes.size());
}

TEST(BasisTables, HonestOnesAreAccepted) {
  // Kind, for those of Bernstein polynomials the order, and where that is 1 whether there are
  // wavelets; then levels 0 to 2.
  std::vector<std::vector<uint8_t>> heads = {{0}, {1}, {2}, {3, 0, 0}, {3, 0, 1}};
  for (uint8_t order = 1; order < 8; ++order) heads.push_back({3, order});
  for (std::vector<uint8_t>& head : heads) {
    head.insert(head.end(), {1, 2, 0});
    const Outcome outcome = tryBytes(head);
    EXPECT_TRUE(outcome.honest);
    EXPECT_TRUE(outcome.accepted) << "kind " << int{head[0]} << ", " << int{head[1]};
    EXPECT_TRUE(outcome.used);
  }
}

TEST(BasisTables, RandomOnesNeverBreakAnything) {
  awdtest::Random random(19990621);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 1000; ++i) {
    std::vector<uint8_t> bytes(12 + random.bits() % 60);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random.bits());
    const Outcome outcome = tryBytes(bytes);
    ++(outcome.accepted ? accepted : refused);
  }
  EXPECT_GT(accepted, 50) << "what is used";
  EXPECT_GT(refused, 500) << "what is refused";
}

}  // namespace
