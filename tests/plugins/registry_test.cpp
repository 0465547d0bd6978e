// SPDX-License-Identifier: Apache-2.0
// Modules by path and from memory, names, and the listing.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <thread>

#include "honest.h"
#include "support.h"

namespace {

TEST(Modules, LoadByPath) {
  const test::Device device;
  ASSERT_EQ(awdLoadBasisModule(device, AWD_HONEST_FILE), AWD_SUCCESS) << awdGetLastErrorMessage();
  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].name, "haar");
  EXPECT_EQ(lines[0].file, AWD_HAAR_FILE);
  EXPECT_EQ(lines[0].flags, AWD_BASIS_ORTHOGONAL | AWD_BASIS_NESTED);
  EXPECT_EQ(lines[0].order, 1u);
  EXPECT_EQ(lines[0].minLevel, 0u);
  EXPECT_EQ(lines[0].maxLevel, AWD_BASIS_MAX_LEVEL);
  EXPECT_EQ(lines[1].name, "test-linear");
  EXPECT_EQ(lines[2].name, "test-linear-periodic");
  EXPECT_EQ(lines[2].flags, AWD_BASIS_PERIODIC);
  EXPECT_EQ(lines[3].name, "test-quadratic");
  EXPECT_EQ(lines[3].order, 3u);
  EXPECT_EQ(lines[3].maxLevel, 12u);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(lines[i].file, AWD_HONEST_FILE);
    EXPECT_EQ(lines[i].status, AWD_SUCCESS);
    EXPECT_EQ(lines[i].message, "");
  }
  // The same file again changes nothing.
  EXPECT_EQ(awdLoadBasisModule(device, AWD_HONEST_FILE), AWD_SUCCESS);
  EXPECT_EQ(test::listing(device).size(), 4u);
}

TEST(Modules, ARelativePathIsRefused) {
  const test::Device device;
  EXPECT_EQ(awdLoadBasisModule(device, "haar.so"), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_STREQ(awdGetLastErrorMessage(),
               "awdLoadBasisModule: absolutePath \"haar.so\" is not absolute: give the whole path, "
               "from '/' on");
  EXPECT_EQ(awdLoadBasisModule(device, ""), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(awdLoadBasisModule(device, nullptr), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(test::listing(device).size(), 1u) << "no candidate was refused";
}

TEST(Modules, RegisterFromMemory) {
  const test::Device device;
  ASSERT_EQ(awdRegisterBasisModule(device, honestModule()), AWD_SUCCESS)
      << awdGetLastErrorMessage();
  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[1].name, "test-linear");
  EXPECT_EQ(lines[1].file, "");
}

TEST(Modules, ATableThatIsInUseIsNoConflict) {
  const test::Device device;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(awdRegisterBasisModule(device, honestModule()), AWD_SUCCESS)
        << awdGetLastErrorMessage();
    EXPECT_EQ(test::listing(device).size(), 4u);
  }
}

TEST(Modules, AnExceptionOfATableIsARefusal) {
  AWDBasisFamily family = *honestModule()->families[0];
  const AWDBasisFamily* const families[] = {&family};
  AWDBasisModule module = *honestModule();
  module.families = families;
  module.familyCount = 1;
  const test::Device device;
  family.weight = [](uint32_t, uint32_t) -> double { throw std::runtime_error("no weights"); };
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_ERROR_PLUGIN_SELF_TEST);
  EXPECT_STREQ(awdGetLastErrorMessage(),
               "awdRegisterBasisModule: basis \"test-linear\": a function of the table throws an "
               "exception: no weights");
  family.count = [](uint32_t) -> uint32_t { throw 7; };
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_ERROR_PLUGIN_SELF_TEST);
  EXPECT_STREQ(awdGetLastErrorMessage(),
               "awdRegisterBasisModule: basis \"test-linear\": a function of the table throws an "
               "exception");
  EXPECT_EQ(test::names(device), "haar");
}

/// The exception lies in the module, which is closed again.
TEST(Modules, AnExceptionOfTheEntryIsARefusal) {
  const test::Device device;
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(awdLoadBasisModule(device, AWD_THROWING_FILE), AWD_ERROR_PLUGIN_LOAD);
    EXPECT_TRUE(test::contains(awdGetLastErrorMessage(),
                               "its entry point throws an exception: no licence today"))
        << awdGetLastErrorMessage();
  }
}

/// The self-test looks at some cells of 8192; the others are looked at when they are used.
TEST(Modules, WhatTheSelfTestDidNotSeeIsSeenLater) {
  const auto family = [](auto&& eval, auto&& weight) {
    AWDBasisFamily boxes = {};
    boxes.structSize = sizeof boxes;
    boxes.name = "test-boxes";
    boxes.summary = "boxes that are not all right";
    boxes.flags = AWD_BASIS_ORTHOGONAL | AWD_BASIS_NESTED;
    boxes.order = boxes.sampleDims = 1;
    boxes.minLevel = 0;
    boxes.maxLevel = 13;
    boxes.count = boxes.cells = [](uint32_t level) -> uint32_t { return 1u << level; };
    boxes.support = [](uint32_t level, uint32_t j, double ab[2]) {
      ab[0] = std::ldexp(j, -static_cast<int>(level));
      ab[1] = std::ldexp(j + 1.0, -static_cast<int>(level));
    };
    boxes.weight = weight;
    boxes.eval = eval;
    boxes.sample = [](uint32_t level, uint32_t j, const double* u) {
      return std::ldexp(j + u[0], -static_cast<int>(level));
    };
    boxes.twoScale = [](uint32_t, uint32_t j, uint32_t* first, double* h) -> uint32_t {
      *first = 2 * j;
      h[0] = h[1] = 1.0;
      return 2;
    };
    return boxes;
  };
  using Eval = uint32_t (*)(uint32_t, double, uint32_t*, double*);
  const auto evalOf = [](auto value) -> Eval {
    return [](uint32_t level, double x, uint32_t* first, double* values) -> uint32_t {
      *first = std::min(static_cast<uint32_t>(std::ldexp(x, static_cast<int>(level))),
                        (1u << level) - 1);
      values[0] = level == 13 && *first == 3001 ? decltype(value)::of() : 1.0;
      return 1;
    };
  };
  struct One {
    static double of() { return 1.0; }
  };
  struct NaN {
    static double of() { return std::nan(""); }
  };
  struct Infinite {
    static double of() { return HUGE_VAL; }
  };
  struct Negative {
    static double of() { return -1.0; }
  };
  const auto right = [](uint32_t level, uint32_t) {
    return std::ldexp(1.0, -static_cast<int>(level));
  };
  const auto wrong = [](uint32_t level, uint32_t j) {
    return std::ldexp(level == 13 && j == 3001 ? 2.0 : 1.0, -static_cast<int>(level));
  };
  AWDBasisFamily all[] = {family(evalOf(One()), right), family(evalOf(NaN()), right),
                          family(evalOf(Infinite()), right), family(evalOf(Negative()), right),
                          family(evalOf(One()), wrong)};
  for (AWDBasisFamily& boxes : all) {
    const AWDBasisFamily* const families[] = {&boxes};
    AWDBasisModule module = *honestModule();
    module.families = families;
    module.familyCount = 1;
    const test::Device device;
    ASSERT_EQ(awdRegisterBasisModule(device, &module), AWD_SUCCESS) << awdGetLastErrorMessage();
    const AWDDensityAxis axis = {"test-boxes", AWD_LEVEL(13), AWD_LEVEL(13)};
    AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
    desc.dimensions = 1;
    desc.axes = &axis;
    AWDDensity density = nullptr;
    const AWDResult result = awdNewDensity(device, &desc, &density);
    if (&boxes == all) {
      EXPECT_EQ(result, AWD_SUCCESS) << awdGetLastErrorMessage();
    } else {
      EXPECT_EQ(result, AWD_ERROR_PLUGIN_SELF_TEST) << &boxes - all;
      EXPECT_TRUE(test::contains(awdGetLastErrorMessage(), "function 3001"))
          << awdGetLastErrorMessage();
    }
    awdReleaseDensity(density);
  }
}

/// Sums over 2048 cells are rounded, which is no mistake of the family's.
TEST(Modules, WideFunctionsAreNotRefusedForRounding) {
  AWDBasisFamily halves = {};
  halves.structSize = sizeof halves;
  halves.name = "test-halves";
  halves.summary = "two boxes on many cells";
  halves.flags = AWD_BASIS_ORTHOGONAL;
  halves.order = halves.sampleDims = 1;
  halves.count = [](uint32_t) -> uint32_t { return 2; };
  halves.cells = [](uint32_t) -> uint32_t { return 2048; };
  halves.support = [](uint32_t, uint32_t j, double ab[2]) {
    ab[0] = 0.5 * j, ab[1] = 0.5 * (j + 1);
  };
  halves.weight = [](uint32_t, uint32_t) { return 0.5; };
  halves.eval = [](uint32_t, double x, uint32_t* first, double* values) -> uint32_t {
    *first = x < 0.5 ? 0 : 1;
    values[0] = 1.0;
    return 1;
  };
  halves.sample = [](uint32_t, uint32_t j, const double* u) { return 0.5 * (j + u[0]); };
  halves.twoScale = [](uint32_t, uint32_t, uint32_t*, double*) -> uint32_t { return 0; };
  const AWDBasisFamily* const families[] = {&halves};
  AWDBasisModule module = *honestModule();
  module.families = families;
  module.familyCount = 1;
  const test::Device device;
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_SUCCESS) << awdGetLastErrorMessage();
  halves.weight = [](uint32_t, uint32_t) { return 0.5 + 1e-9; };
  const test::Device another;
  EXPECT_EQ(awdRegisterBasisModule(another, &module), AWD_ERROR_PLUGIN_SELF_TEST);
  EXPECT_TRUE(test::contains(awdGetLastErrorMessage(), "weight is not the integral"))
      << awdGetLastErrorMessage();
}

TEST(Modules, TheFirstOfANameWins) {
  const test::Device device;
  ASSERT_EQ(awdRegisterBasisModule(device, honestModule()), AWD_SUCCESS);
  EXPECT_EQ(awdLoadBasisModule(device, AWD_HONEST_FILE), AWD_ERROR_PLUGIN_NAME_TAKEN);
  EXPECT_TRUE(test::contains(awdGetLastErrorMessage(),
                             "basis \"test-linear\": the name is taken by a family in memory"))
      << awdGetLastErrorMessage();
  const std::vector<test::Info> lines = test::listing(device);
  ASSERT_EQ(lines.size(), 7u);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_EQ(lines[i].file, "");
  for (std::size_t i = 4; i < 7; ++i) {
    EXPECT_EQ(lines[i].file, AWD_HONEST_FILE);
    EXPECT_EQ(lines[i].status, AWD_ERROR_PLUGIN_NAME_TAKEN);
  }
}

TEST(Modules, AllFamiliesOrNone) {
  const AWDBasisModule& honest = *honestModule();
  AWDBasisFamily bad = *honest.families[1];
  bad.weight = [](uint32_t, uint32_t) { return 0.125; };
  const AWDBasisFamily* const families[] = {honest.families[0], &bad};
  AWDBasisModule module = honest;
  module.families = families;
  module.familyCount = 2;
  const test::Device device;
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_ERROR_PLUGIN_SELF_TEST);
  EXPECT_STREQ(
      awdGetLastErrorMessage(),
      "awdRegisterBasisModule: basis \"test-linear-periodic\": weight is not the integral: "
      "level 0, function 0: got 0.125, want 1");
  EXPECT_EQ(test::names(device), "haar");
  ASSERT_EQ(test::listing(device).size(), 2u);
  EXPECT_EQ(test::listing(device)[1].name, "test-linear-periodic");

  // Twice the same name within a module.
  const AWDBasisFamily* const twice[] = {honest.families[0], honest.families[0]};
  module.families = twice;
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_ERROR_PLUGIN_NAME_TAKEN);
  EXPECT_EQ(test::names(device), "haar");
}

TEST(Modules, TablesOfAnotherInterfaceAreRefused) {
  const test::Device device;
  const AWDBasisModule& honest = *honestModule();
  const auto refused = [&](const AWDBasisModule& module, const char* sentence) {
    EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_ERROR_PLUGIN_ABI);
    EXPECT_TRUE(test::contains(awdGetLastErrorMessage(), sentence)) << awdGetLastErrorMessage();
  };
  AWDBasisModule module = honest;
  module.abi = 0;
  refused(module, "basis ABI 0");
  module = honest;
  module.structSize = 8;
  refused(module, "AWDBasisModule has structSize 8");
  module.structSize = SIZE_MAX;
  refused(module, "AWDBasisModule has structSize");
  module = honest;
  module.familyCount = 0;
  refused(module, "0 families");
  module.familyCount = 257;
  refused(module, "257 families");
  module = honest;
  module.families = nullptr;
  refused(module, "NULL");
  const AWDBasisFamily* const none[] = {nullptr};
  module.families = none;
  module.familyCount = 1;
  refused(module, "families[0] is NULL");

  // A longer table of a newer header: fine unless it uses what we don't know.
  struct Longer {
    AWDBasisFamily family;
    void* newer[2];
  } longer = {*honest.families[0], {nullptr, nullptr}};
  longer.family.structSize = sizeof longer;
  const AWDBasisFamily* const one[] = {&longer.family};
  module.families = one;
  longer.newer[1] = &longer;
  refused(module, "uses a field at byte");
  longer.newer[1] = nullptr;
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_SUCCESS) << awdGetLastErrorMessage();
  EXPECT_EQ(test::names(device), "haar test-linear");
  EXPECT_EQ(awdRegisterBasisModule(device, nullptr), AWD_ERROR_INVALID_ARGUMENT);
}

TEST(Modules, ShorterTablesOfTheFirstVersionAreAccepted) {
  // A plugin that was compiled before wavelets: what lies behind its table is not read.
  AWDBasisFamily family = *honestModule()->families[0];
  family.structSize = offsetof(AWDBasisFamily, wavelet);
  std::memset(reinterpret_cast<char*>(&family) + family.structSize, 0xff,
              sizeof family - family.structSize);
  const AWDBasisFamily* families[] = {&family};
  AWDBasisModule module = *honestModule();
  module.families = families;
  module.familyCount = 1;
  const test::Device device;
  for (const size_t size : {family.structSize - 8, family.structSize + 4}) {
    AWDBasisFamily odd = family;
    odd.structSize = size;
    families[0] = &odd;
    EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_ERROR_PLUGIN_ABI) << size;
  }
  families[0] = &family;
  EXPECT_EQ(awdRegisterBasisModule(device, &module), AWD_SUCCESS) << awdGetLastErrorMessage();
  EXPECT_EQ(test::names(device), "haar test-linear");
}

TEST(Modules, TwoDevicesShareNothing) {
  const test::Device a, b;
  ASSERT_EQ(awdLoadBasisModule(a, AWD_HONEST_FILE), AWD_SUCCESS);
  EXPECT_EQ(test::names(b), "haar");
  ASSERT_EQ(awdLoadBasisModule(b, AWD_HONEST_FILE), AWD_SUCCESS);
  EXPECT_EQ(test::names(a), test::names(b));
}

TEST(Modules, FromManyThreadsAtOnce) {
  const test::Device device;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      EXPECT_EQ(awdLoadBasisModule(device, AWD_HONEST_FILE), AWD_SUCCESS);
      EXPECT_EQ(awdLoadBasisModule(device, AWD_LYING_FOLDER "/nan.so"), AWD_ERROR_PLUGIN_SELF_TEST);
      EXPECT_FALSE(test::names(device).empty());
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(test::names(device), "haar test-linear test-linear-periodic test-quadratic");
  EXPECT_EQ(test::listing(device).size(), 5u);
}

TEST(Listing, ArgumentsAreChecked) {
  const test::Device device;
  std::size_t count = 7;
  EXPECT_EQ(awdGetBasisCount(nullptr, &count), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(awdGetBasisCount(device, nullptr), AWD_ERROR_INVALID_ARGUMENT);
  AWDBasisInfo info = AWD_BASIS_INFO_INIT;
  ASSERT_EQ(awdGetBasisCount(device, &count), AWD_SUCCESS);
  EXPECT_EQ(awdGetBasisInfo(device, count, &info), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(awdGetLastErrorMessage(), "awdGetBasisInfo: index " + std::to_string(count) +
                                          " is not below the count of " + std::to_string(count));
  EXPECT_EQ(awdGetBasisInfo(device, 0, nullptr), AWD_ERROR_INVALID_ARGUMENT);
  info.structSize = 0;
  EXPECT_EQ(awdGetBasisInfo(device, 0, &info), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_TRUE(test::contains(awdGetLastErrorMessage(), "AWD_BASIS_INFO_INIT"));
}

TEST(Listing, TextsLiveAsLongAsTheDevice) {
  const test::Device device;
  AWDBasisInfo info = AWD_BASIS_INFO_INIT;
  ASSERT_EQ(awdGetBasisInfo(device, 0, &info), AWD_SUCCESS);
  const std::string name = info.name, file = info.file;
  ASSERT_EQ(awdRegisterBasisModule(device, honestModule()), AWD_SUCCESS);
  for (int i = 0; i < 100; ++i) {
    const std::string other = "/nowhere/" + std::to_string(i) + ".so";
    EXPECT_EQ(awdLoadBasisModule(device, other.c_str()), AWD_ERROR_PLUGIN_LOAD);
  }
  EXPECT_EQ(info.name, name);
  EXPECT_EQ(info.file, file);
}

}  // namespace
