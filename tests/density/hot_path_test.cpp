// SPDX-License-Identifier: Apache-2.0
// What drawing, looking up and recording do not do: allocate, or call the plugin.
#include <gtest/gtest.h>

#include "density/densities.h"
#include "honest.h"
#include "support/counting_allocator.h"

namespace awdtest {
namespace {

// A plugin's table that counts the calls of its functions.
std::atomic<int> calls;
const AWDBasisFamily& original() { return *honestModule()->families[0]; }

AWDBasisFamily countedFamily() {
  AWDBasisFamily family = original();
  family.name = "counted-linear";
  family.count = [](uint32_t level) {
    ++calls;
    return original().count(level);
  };
  family.cells = [](uint32_t level) {
    ++calls;
    return original().cells(level);
  };
  family.support = [](uint32_t level, uint32_t j, double ab[2]) {
    ++calls;
    original().support(level, j, ab);
  };
  family.weight = [](uint32_t level, uint32_t j) {
    ++calls;
    return original().weight(level, j);
  };
  family.eval = [](uint32_t level, double x, uint32_t* first, double* values) {
    ++calls;
    return original().eval(level, x, first, values);
  };
  family.sample = [](uint32_t level, uint32_t j, const double* u) {
    ++calls;
    return original().sample(level, j, u);
  };
  family.twoScale = [](uint32_t level, uint32_t j, uint32_t* first, double* h) {
    ++calls;
    return original().twoScale(level, j, first, h);
  };
  return family;
}

/// Draws, looks up and records, without adapting.
void work(AWDDensity density, Random& random) {
  const Samples samples =
      draw(density, 1000, random, [](const double* x) { return 1.0 + x[0] * x[1]; });
  pdfsAt(density, samples.points);
  record(density, samples);
}

TEST(HotPath, NeitherAllocatesNorLeavesTheTables) {
  CountingAllocator allocator;
  {
    const AWDDeviceDesc deviceDesc = allocator.desc(1);
    const Device device = newDevice(&deviceDesc);
    const AWDBasisFamily family = countedFamily();
    const AWDBasisFamily* const families[] = {&family};
    AWDBasisModule module = *honestModule();
    module.familyCount = 1;
    module.families = families;
    must(awdRegisterBasisModule(device, &module));

    std::vector<Density> densities;
    for (const AWDSampler sampler : {AWD_SAMPLER_INVERSE_CDF, AWD_SAMPLER_COMPONENT}) {
      AWDDensityDesc desc = gridDesc();
      desc.sampler = sampler;
      densities.push_back(newDensity(
          device, {fixedAxis("counted-linear", 3), fixedAxis("counted-linear", 2)}, desc));
    }
    for (const char* basis : kNested) {
      densities.push_back(
          newDensity(device, {axisFrom(basis, 2, 4), axisFrom(basis, 2, 4)}, treeDesc()));
    }
    Random random(1);
    for (const Density& density : densities) {
      pass(density, 1000, random, [](const double* x) { return x[0]; });
      const size_t allocated = allocator.calls();
      const int called = calls;
      work(density, random);
      EXPECT_EQ(allocator.calls(), allocated);
      EXPECT_EQ(calls, called);
      adapt(density);
      EXPECT_GT(allocator.calls(), allocated);  // it counts
      EXPECT_EQ(calls, called);                 // not even adapting asks the plugin
    }
    EXPECT_GT(calls, 0);
  }
  EXPECT_EQ(allocator.blocks(), 0u);
}

}  // namespace
}  // namespace awdtest
