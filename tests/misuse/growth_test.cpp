// SPDX-License-Identifier: Apache-2.0
// Structs grow at their end. From both sides: a host that is older than the library has shorter
// ones, one that is newer longer ones. Each ends where memory does.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <regex>

#include "misuse/headers.h"
#include "misuse/structs.h"
#include "support/guarded.h"

namespace {

using namespace awdmisuse;
using awdtest::Guarded;

constexpr size_t kWord = sizeof(size_t), kLongest = 4096;

void setSize(char* place, size_t size) { std::memcpy(place, &size, sizeof size); }

/// The first bytes of a struct before a guard, and zeros behind them if it is to be longer.
std::unique_ptr<Guarded> versionOf(const std::vector<char>& good, size_t size, size_t claimed) {
  auto place = std::make_unique<Guarded>(size);
  std::memset(place->data(), 0, size);
  std::memcpy(place->data(), good.data(), std::min(size, good.size()));
  setSize(place->data(), claimed);
  return place;
}

class Growth : public testing::Test {
 protected:
  World world_;
};

TEST_F(Growth, OldHostsGetTheDefaultsOfWhatTheyLack) {
  for (const Input& input : allInputs()) {
    std::vector<Seen> different;
    Seen whole;
    for (size_t size = kWord; size <= input.good.size(); size += kWord) {
      SCOPED_TRACE(std::string(input.name) + " of " + std::to_string(size) + " bytes");
      std::vector<char> filled(input.good.begin(),
                               input.good.begin() + static_cast<std::ptrdiff_t>(size));
      filled.resize(input.good.size());
      setSize(filled.data(), filled.size());
      const Seen now = input.see(world_, filled.data());
      EXPECT_TRUE(input.see(world_, versionOf(input.good, size, size)->data()) == now);
      if (std::find(different.begin(), different.end(), now) == different.end()) {
        different.push_back(now);
      }
      whole = now;
    }
    // Not all of them can have been refused alike.
    EXPECT_GT(different.size(), 1u) << input.name;
    EXPECT_EQ(whole[0], AWD_SUCCESS)
        << input.name << ": " << std::string(whole.begin(), whole.end());
  }
}

TEST_F(Growth, NewHostsMayNotUseWhatIsNotKnown) {
  for (const Input& input : allInputs()) {
    const Seen now = input.see(world_, input.good.data());
    const size_t ours = input.good.size();
    for (const size_t size : {ours + kWord, ours + 5 * kWord, kLongest}) {
      SCOPED_TRACE(std::string(input.name) + " of " + std::to_string(size) + " bytes");
      const auto longer = versionOf(input.good, size, size);
      EXPECT_TRUE(input.see(world_, longer->data()) == now);
      for (const size_t at : {ours, ours + 1, ours + kWord - 1, size - 1}) {
        longer->data()[at] = 1;
        const Seen refused = input.see(world_, longer->data());
        EXPECT_EQ(refused[0], AWD_ERROR_INVALID_ARGUMENT);
        const std::string message(refused.begin() + 1, refused.end());
        EXPECT_NE(message.find("at byte " + std::to_string(at)), std::string::npos) << message;
        longer->data()[at] = 0;
      }
    }
  }
}

TEST_F(Growth, SizesThatNoVersionHasAreRefused) {
  for (const size_t claimed : {size_t{0}, size_t{7}, size_t{9}, kLongest + kWord, SIZE_MAX,
                               SIZE_MAX - 7, size_t{1} << 63}) {
    for (const Input& input : allInputs()) {
      const Seen refused =
          input.see(world_, versionOf(input.good, input.good.size(), claimed)->data());
      EXPECT_EQ(refused[0], AWD_ERROR_INVALID_ARGUMENT) << input.name << ' ' << claimed;
      const std::string message(refused.begin() + 1, refused.end());
      EXPECT_NE(message.find("_INIT"), std::string::npos) << message;
    }
    for (const Output& output : allOutputs()) {
      const std::vector<char> empty(output.size);
      const auto place = versionOf(empty, output.size, claimed);
      EXPECT_EQ(output.fill(world_, place->data()), AWD_ERROR_INVALID_ARGUMENT)
          << output.name << ' ' << claimed;
    }
  }
}

TEST_F(Growth, OutputsAreWrittenAsFarAsTheyReach) {
  size_t basis = 0;
  ASSERT_EQ(awdGetBasisCount(world_.devices[0], &basis), AWD_SUCCESS);
  for (const Output& output : allOutputs()) {
    std::vector<char> whole(output.size);
    setSize(whole.data(), output.size);
    ASSERT_EQ(output.fill(world_, whole.data()), AWD_SUCCESS) << output.name;
    for (size_t size = kWord; size <= output.size + 4 * kWord; size += kWord) {
      SCOPED_TRACE(std::string(output.name) + " of " + std::to_string(size) + " bytes");
      Guarded place(size);
      std::memset(place.data(), 0xcd, size);
      setSize(place.data(), size);
      ASSERT_EQ(output.fill(world_, place.data()), AWD_SUCCESS) << awdGetLastErrorMessage();
      size_t claimed = 0;
      std::memcpy(&claimed, place.data(), sizeof claimed);
      EXPECT_EQ(claimed, size);
      const size_t known = std::min(size, output.size);
      if (!output.changes) {
        EXPECT_EQ(std::memcmp(place.data() + kWord, whole.data() + kWord, known - kWord), 0);
      }
      for (size_t i = output.size; i < size; ++i) EXPECT_EQ(place.data()[i], 0) << i;
    }
  }
}

struct Counted {
  size_t calls = 0, right = 0;
};

TEST_F(Growth, WhatTheLibraryTellsHasItsSize) {
  Counted checks, reports;
  const AWDBasisCheckFn count = [](void* user, const AWDBasisCheck* check) {
    auto& counted = *static_cast<Counted*>(user);
    ++counted.calls;
    counted.right += check->structSize == sizeof *check;
  };
  ASSERT_EQ(awdCheckBasisModule(world_.modulePath.c_str(), count, &checks), AWD_SUCCESS);
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;
  desc.progressUser = &reports;
  desc.progress = [](void* user, const AWDProgress* progress) -> int32_t {
    auto& counted = *static_cast<Counted*>(user);
    ++counted.calls;
    counted.right += progress->structSize == sizeof *progress;
    return 1;
  };
  AWDDevice device = nullptr;
  ASSERT_EQ(awdNewDevice(&desc, &device), AWD_SUCCESS);
  referenceBits(device);
  awdReleaseDevice(device);
  for (const Counted& counted : {checks, reports}) {
    EXPECT_GT(counted.calls, 0u);
    EXPECT_EQ(counted.calls, counted.right);
  }
}

// --- tables of plugins
// ----------------------------------------------------------------------------

AWDResult registerTable(const AWDBasisModule* module) {
  AWDDevice device = nullptr;
  if (awdNewDevice(nullptr, &device) != AWD_SUCCESS) return AWD_ERROR_UNKNOWN;
  AWDResult result = awdRegisterBasisModule(device, module);
  if (result == AWD_SUCCESS) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.basis = "misuse";
    AWDField field = nullptr;
    result = awdNewField(device, &desc, &field);
    awdReleaseField(field);
  }
  awdReleaseDevice(device);
  return result;
}

TEST_F(Growth, TablesOfOlderAndNewerPlugins) {
  constexpr size_t kFirst = offsetof(AWDBasisFamily, wavelet);
  AWDBasisFamily plain = world_.family;
  plain.wavelet = nullptr;  // which came with its number of vanishing moments
  plain.vanishingMoments = 0;
  std::vector<char> good(sizeof plain);
  std::memcpy(good.data(), &plain, good.size());
  AWDBasisModule module = world_.module;
  for (size_t size = kWord; size <= good.size() + 4 * kWord; size += kWord) {
    SCOPED_TRACE(size);
    const auto place = versionOf(good, size, size);
    const auto* family = reinterpret_cast<const AWDBasisFamily*>(place->data());
    module.families = &family;
    EXPECT_EQ(registerTable(&module), size < kFirst ? AWD_ERROR_PLUGIN_ABI : AWD_SUCCESS)
        << awdGetLastErrorMessage();
    if (size <= good.size()) continue;
    place->data()[size - 1] = 1;
    EXPECT_EQ(registerTable(&module), AWD_ERROR_PLUGIN_ABI);
  }
  std::vector<char> table(sizeof module);
  std::memcpy(table.data(), &world_.module, table.size());
  for (size_t size = kWord; size <= table.size() + 4 * kWord; size += kWord) {
    SCOPED_TRACE(size);
    const auto place = versionOf(table, std::max(size, sizeof(AWDBasisModule)), size);
    const auto* known = reinterpret_cast<const AWDBasisModule*>(place->data());
    EXPECT_EQ(registerTable(known), size < sizeof module ? AWD_ERROR_PLUGIN_ABI : AWD_SUCCESS);
    if (size <= table.size()) continue;
    place->data()[size - 1] = 1;
    EXPECT_EQ(registerTable(known), AWD_ERROR_PLUGIN_ABI);
  }
}

// --- the tables of this test
// ----------------------------------------------------------------------

TEST(GrowthTable, HasEveryStructOfTheHeaders) {
  std::map<std::string, bool> listed;  // whether it has a structSize
  for (const Input& input : allInputs()) listed[input.name] = true;
  for (const Output& output : allOutputs()) listed[output.name] = true;
  // WhatTheLibraryTellsHasItsSize and TablesOfOlderAndNewerPlugins; that of the host is the
  // library's to give.
  for (const char* name :
       {"AWDBasisCheck", "AWDProgress", "AWDBasisFamily", "AWDBasisHost", "AWDBasisModule"}) {
    listed[name] = true;
  }
  for (const Fixed& fixed : allFixed()) {
    listed[fixed.name] = false;
    EXPECT_EQ(fixed.size, fixed.wanted) << fixed.name << " never grows";
  }
  std::map<std::string, bool> declared;
  const std::string text = textOfHeaders();
  const std::regex pattern(R"(typedef struct (AWD\w+) \{([^}]*)\})");
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    declared[(*match)[1]] = (*match)[2].str().find("size_t structSize;") != std::string::npos;
  }
  EXPECT_EQ(listed, declared);
  EXPECT_GT(declared.size(), 20u);
}

/// abidiff lets those grow that have a structSize, and no others.
TEST(GrowthTable, IsThatOfTheAbiGate) {
  std::ifstream file(AWD_TEST_SUPPRESSIONS);
  std::string line, allowed;
  while (std::getline(file, line)) {
    std::smatch found;
    if (std::regex_match(line, found, std::regex(R"(\s*name_regexp = (.*))"))) allowed = found[1];
  }
  const std::regex mayGrow(allowed);
  const auto expectGrowing = [&](const char* name, bool growing) {
    EXPECT_EQ(std::regex_match(name, mayGrow), growing) << name;
  };
  for (const Input& input : allInputs()) expectGrowing(input.name, true);
  for (const Output& output : allOutputs()) expectGrowing(output.name, true);
  for (const char* name :
       {"AWDBasisCheck", "AWDProgress", "AWDBasisFamily", "AWDBasisHost", "AWDBasisModule"}) {
    expectGrowing(name, true);
  }
  for (const Fixed& fixed : allFixed()) expectGrowing(fixed.name, false);
}

}  // namespace
