// SPDX-License-Identifier: Apache-2.0
// The interface from several threads at once, as its headers allow: *free* functions on the same
// objects, and all functions where one call follows the other.
#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <mutex>
#include <regex>
#include <set>
#include <thread>

#include "misuse/caller.h"
#include "misuse/headers.h"
#include "support/soak.h"

namespace {

using namespace awdmisuse;

constexpr size_t kThreads = 4;

/// Those whose words in the headers say that they are free, for all of their arguments.
std::set<std::string> freeFunctions() {
  const std::string text = textOfHeaders();
  // A comment belongs to all functions up to the next one.
  const std::regex item(R"(/\*([^*]|\*(?!/))*\*/|AWD_CALL\s+(awd[A-Z]\w*)\s*\()");
  const std::regex word(R"(\b(F|f)ree\b)"), not_free(R"(\b(E|e)xclusive\b)");
  std::set<std::string> names;
  bool isFree = false;
  for (std::sregex_iterator match(text.begin(), text.end(), item), end; match != end; ++match) {
    if ((*match)[2].matched) {
      if (isFree) names.insert((*match)[2]);
      continue;
    }
    const std::string comment = match->str();
    isFree = std::regex_search(comment, word) && !std::regex_search(comment, not_free);
  }
  return names;
}

/// Each thread makes calls of its own on the shared objects; complaints of all of them.
template <class Choose, class Guard>
std::vector<std::string> runThreads(World& shared, long calls, Choose&& mayCall, Guard&& guarded) {
  std::vector<const Function*> functions;
  for (const Function& function : allFunctions()) {
    if (mayCall(function.name)) functions.push_back(&function);
  }
  std::vector<std::unique_ptr<World>> worlds;
  for (size_t i = 0; i < kThreads; ++i) worlds.push_back(std::make_unique<World>(shared));
  std::vector<std::string> complaints(kThreads);
  std::vector<std::thread> threads;
  for (size_t t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      awdtest::Random random(t);
      for (long i = 0; i < calls && complaints[t].empty(); ++i) {
        const Function& function = *functions[random.bits() % functions.size()];
        Caller caller(*worlds[t], random.bits(), Caller::Mode::kWild);
        caller.named(function.name);
        guarded([&] { function.call(caller); });
        if (!caller.complaint().empty()) complaints[t] = caller.text() + ": " + caller.complaint();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  return complaints;
}

class Threads : public testing::Test {
 protected:
  // Where wild calls write what has no folder in its name.
  Threads() { std::filesystem::current_path(world_.folder.path("")); }
  ~Threads() override { std::filesystem::current_path(before_); }

  void expectNoneTheWorse(const std::vector<std::string>& complaints) {
    for (const std::string& complaint : complaints) EXPECT_EQ(complaint, "");
    EXPECT_TRUE(referenceBits(world_.devices[0]) == reference_);
    world_.release();
    awdReleaseDevice(world_.devices[0]);
    world_.devices.clear();
    EXPECT_EQ(world_.memory.blocks() + world_.others.blocks(), 0u);
  }
  const std::filesystem::path before_ = std::filesystem::current_path();
  World world_;
  std::vector<double> reference_ = referenceBits(world_.devices[0]);
};

TEST_F(Threads, FreeFunctionsOnTheSameObjects) {
  const std::set<std::string> free = freeFunctions();
  EXPECT_EQ(free.count("awdSampleField"), 1u);
  EXPECT_EQ(free.count("awdReleaseRender"), 1u);
  EXPECT_EQ(free.count("awdAdaptField"), 0u);
  EXPECT_EQ(free.count("awdNewRender"), 0u);  // exclusive for the field
  EXPECT_GT(free.size(), 60u);
  expectNoneTheWorse(runThreads(
      world_, awdtest::soakSize(200, 20000), [&](const char* name) { return free.count(name) > 0; },
      [](auto&& call) { call(); }));
}

TEST_F(Threads, AllFunctionsOneAfterTheOther) {
  std::mutex mutex;
  expectNoneTheWorse(runThreads(
      world_, awdtest::soakSize(150, 20000), [](const char*) { return true; },
      [&](auto&& call) {
        const std::lock_guard<std::mutex> lock(mutex);
        call();
      }));
}

/// Both are free: the list was read without regard for patches in the making.
TEST_F(Threads, PatchesAreListedWhileOthersAreMade) {
  constexpr size_t kHostField = 1;  // with the host's patches
  constexpr uint32_t kPatches = 300;
  const AWDField field = world_.fields[kHostField];
  AWDDirectionSample sample = {};
  sample.pdf = 0.3f;
  sample.solidAngle = 3.0f;
  sample.component = AWD_INVALID_ID;
  std::vector<std::thread> threads;
  for (uint32_t t = 0; t < 2; ++t) {
    threads.emplace_back([&, t] {
      for (uint32_t i = 0; i < kPatches; ++i) awdRecordField(field, i << (8 * t + 4), &sample, 1.0);
    });
    threads.emplace_back([&] {
      size_t last = 0, count = 0;
      for (uint32_t i = 0; i < kPatches; ++i, last = count) {
        ASSERT_EQ(awdGetFieldPatches(field, nullptr, 0, &count), AWD_SUCCESS);
        ASSERT_GE(count, last);
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  size_t count = 0;
  ASSERT_EQ(awdGetFieldPatches(field, nullptr, 0, &count), AWD_SUCCESS);
  EXPECT_EQ(count, 2 * kPatches - 1 - (kPatches - 1) / 256) << "numbers that both have";
}

}  // namespace
