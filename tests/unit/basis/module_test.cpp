// SPDX-License-Identifier: Apache-2.0
#include "basis/module.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "honest.h"
#include "util/error.h"

namespace {

using namespace awd;

bool resident(const char* file) {
  void* handle = dlopen(file, RTLD_NOW | RTLD_NOLOAD);
  if (handle) dlclose(handle);
  return handle != nullptr;
}

TEST(Module, GivesItsTableAndIsClosedUnlessKept) {
  const std::string copy = std::string(AWD_HAAR_FILE) + ".module-test";
  std::filesystem::copy_file(AWD_HAAR_FILE, copy,
                             std::filesystem::copy_options::overwrite_existing);
  {
    const Module module(copy.c_str());
    EXPECT_EQ(module.table().familyCount, 1u);
    EXPECT_STREQ(module.table().families[0]->name, "haar");
    EXPECT_TRUE(resident(copy.c_str()));
  }
  EXPECT_FALSE(resident(copy.c_str()));
  {
    Module module(copy.c_str());
    module.keep();
  }
  EXPECT_TRUE(resident(copy.c_str()));
  std::filesystem::remove(copy);
}

AWDResult codeOf(const char* path, std::string* text) {
  try {
    const Module module(path);
  } catch (const Error& error) {
    *text = error.what();
    return error.code();
  }
  return AWD_SUCCESS;
}

TEST(Module, SaysWhyItCannotBeUsed) {
  std::string text;
  EXPECT_EQ(codeOf("libm.so.6", &text), AWD_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(codeOf("/no/such/file.so", &text), AWD_ERROR_PLUGIN_LOAD);
  EXPECT_EQ(text, "can't be opened: cannot open shared object file: No such file or directory");
}

TEST(Module, TablesOfOtherLengthsAreReadAsFarAsTheyGo) {
  AWDBasisFamily family = *honestModule()->families[0];
  family.vanishingMoments = 3;
  EXPECT_EQ(knownPart(family).vanishingMoments, 3u);
  family.structSize = offsetof(AWDBasisFamily, vanishingMoments);
  const AWDBasisFamily known = knownPart(family);
  EXPECT_EQ(known.structSize, sizeof known);
  EXPECT_EQ(known.twoScale, family.twoScale);
  EXPECT_EQ(known.vanishingMoments, 0u);
  struct Longer {
    AWDBasisFamily family;
    double newer;
  } longer = {*honestModule()->families[0], 0.0};
  longer.family.structSize = sizeof longer;
  EXPECT_EQ(knownPart(longer.family).structSize, sizeof(AWDBasisFamily));
}

TEST(Module, TextsOfPluginsAreShownOnOneLine) {
  EXPECT_EQ(printable(nullptr, 8), "");
  EXPECT_EQ(printable("a\nb\x7f", 8), "a?b?");
  EXPECT_EQ(printable("caf\xc3\xa9", 8), "caf\xc3\xa9");
  EXPECT_EQ(printable("abcdef", 4), "abcd");
}

TEST(Module, SharesNoNames) {
  const Module module(AWD_HAAR_FILE);
  // This program has an entry point of that name too, by its test families; but nothing of the
  // module may be seen by others.
  void* everybody = dlopen(nullptr, RTLD_NOW);
  void* symbol = dlsym(everybody, "awdBasisModule_v1");
  Dl_info info = {};
  const bool found = symbol && dladdr(symbol, &info) != 0;
  EXPECT_TRUE(!found || !std::strstr(info.dli_fname, "haar")) << info.dli_fname;
  dlclose(everybody);
}

}  // namespace
