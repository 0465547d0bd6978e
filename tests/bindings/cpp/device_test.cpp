// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>

#include "awd/basis.h"
#include "bindings/cpp/room.h"

namespace {

using namespace awdtest;

TEST(Device, ListsBases) {
  const awd::Device device = oneThread();
  const std::vector<AWDBasisInfo> bases = MUST(device.bases());
  const auto haar = std::find_if(bases.begin(), bases.end(), [](const AWDBasisInfo& info) {
    return std::strcmp(info.name, "haar") == 0;
  });
  ASSERT_NE(haar, bases.end());
  EXPECT_EQ(haar->status, AWD_SUCCESS);
  MUST(device.loadBasisModule(haar->file));

  int checks = 0;
  MUST(awd::checkBasisModule(haar->file, [&](const AWDBasisCheck& check) {
    EXPECT_LE(check.worst, check.limit);
    ++checks;
  }));
  EXPECT_GT(checks, 10);
}

TEST(Device, RefusesWhatIsNoModule) {
  const awd::Device device = oneThread();
  expectError([&] { return device.loadBasisModule("/nowhere/at-all.so"); }, AWD_ERROR_PLUGIN_LOAD,
              "/nowhere/at-all.so");
  const auto unheard = [](const AWDBasisCheck&) {};
  expectError([&] { return awd::checkBasisModule(std::string("/nowhere.so"), unheard); },
              AWD_ERROR_PLUGIN_LOAD, "/nowhere.so");
  AWDBasisModule empty = {};
  empty.structSize = sizeof empty;
  expectError([&] { return device.registerBasisModule(empty); }, AWD_ERROR_PLUGIN_ABI, "");
}

TEST(Device, LooksWhereItIsTold) {
  const char* const paths[] = {"/nowhere"};
  awd::DeviceDesc desc;
  desc.setBasisPaths(paths);
  EXPECT_EQ(desc.basisPathCount, 1u);
  EXPECT_TRUE(MUST(awd::Device::create(desc)));
  const char* const relative[] = {"nowhere"};
  desc.setBasisPaths(relative);
  expectError([&] { return awd::Device::create(desc); }, AWD_ERROR_INVALID_ARGUMENT, "nowhere");
}

TEST(Device, CallsBack) {
  std::vector<std::string> log;
  const auto onLog = [&](int32_t severity, const std::string& message) {
    EXPECT_EQ(severity, AWD_LOG_WARNING);
    log.push_back(message);
  };
  double fraction = -1.0;
  auto onProgress = [&](const AWDProgress& progress) { fraction = progress.fraction; };
  awd::DeviceDesc desc;
  desc.threads = 1;
  desc.setLog(onLog);
  desc.setProgress(onProgress);
  const awd::Device device = MUST(awd::Device::create(desc));
  awd::Scene empty = MUST(awd::Scene::create(device));
  MUST(empty.commit());
  ASSERT_FALSE(log.empty());
  EXPECT_NE(log.front().find("empty"), std::string::npos);
  makeRoom(device);
  EXPECT_EQ(fraction, 1.0);
}

TEST(Device, ProgressCancels) {
  bool goOn = true;
  const auto onProgress = [&](const AWDProgress&) { return goOn; };
  awd::DeviceDesc desc;
  desc.setProgress(onProgress);
  awd::Scene scene = uploadRoom(MUST(awd::Device::create(desc)));
  goOn = false;
  expectError([&] { return scene.commit(); }, AWD_ERROR_CANCELLED, "commit");
  goOn = true;
  MUST(scene.commit());
}

TEST(Device, HasAVersion) {
  EXPECT_EQ(awd::version(), unsigned{AWD_VERSION});
  EXPECT_STREQ(awd::resultString(AWD_ERROR_OUT_OF_MEMORY),
               awdGetResultString(AWD_ERROR_OUT_OF_MEMORY));
}

}  // namespace
