// SPDX-License-Identifier: Apache-2.0
// What tests/plugins can't see through the C interface.
#include "basis/registry.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tables.h"

namespace {

using namespace awd;

class RegistryTest : public testing::Test {
 protected:
  AWDDeviceDesc desc_ = AWD_DEVICE_DESC_INIT;
  Ref<Context> context_ = Context::make(desc_);
  Registry registry_{*context_, {}, true};
};

TEST_F(RegistryTest, FindGivesACopyThatTheModuleCannotChange) {
  AWDBasisFamily table = test::linear();
  char name[] = "changing", summary[] = "A line";
  table.name = name;
  table.summary = summary;
  const AWDBasisFamily* const families[] = {&table};
  AWDBasisModule module = *honestModule();
  module.familyCount = 1;
  module.families = families;
  registry_.add(module);
  const AWDBasisFamily& found = registry_.find("changing");
  name[0] = 'x';
  summary[0] = 'x';
  table.order = 7;
  table.eval = nullptr;
  EXPECT_STREQ(found.name, "changing");
  EXPECT_STREQ(found.summary, "A line");
  EXPECT_EQ(found.order, 2u);
  EXPECT_NE(found.eval, nullptr);
  EXPECT_EQ(&registry_.find("changing"), &found);
}

TEST_F(RegistryTest, FamiliesStayWhereTheyAre) {
  registry_.load(AWD_HAAR_FILE);
  const AWDBasisFamily& haar = registry_.find("haar");
  registry_.add(*honestModule());
  EXPECT_EQ(&registry_.find("haar"), &haar);
}

TEST_F(RegistryTest, WithNothingThereTheMessageSaysSo) {
  try {
    registry_.find("haar\n");
    FAIL() << "found";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_UNSUPPORTED);
    const std::string text = error.what();
    EXPECT_EQ(text.rfind("there is no basis \"haar?\"; there are none; looked in \"/", 0), 0u)
        << text;
    EXPECT_NE(text.find("/" AWD_MODULE_FOLDER "\" (does not exist)"), std::string::npos) << text;
  }
}

}  // namespace
