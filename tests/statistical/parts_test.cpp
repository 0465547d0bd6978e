// SPDX-License-Identifier: Apache-2.0
// Passes rendered in parts by several processes, each here with a device of its own: film, field
// and figures have the bits of one that renders them alone.
#include <gtest/gtest.h>

#include <algorithm>

#include "support/expect.h"
#include "support/outcome.h"
#include "support/scenes.h"
#include "support/temporary_folder.h"

namespace {

using namespace awdtest;

struct Numbers {
  std::vector<uint64_t> all;
  size_t sums = 0, maxima = 0;
};

Numbers exported(AWDRender render) {
  Numbers result;
  must(awdExportPass(render, nullptr, 0, &result.sums, &result.maxima));
  result.all.resize(result.sums + result.maxima);
  must(awdExportPass(render, result.all.data(), result.all.size(), &result.sums, &result.maxima));
  return result;
}

Numbers combined(Numbers a, const Numbers& b) {
  EXPECT_EQ(a.sums, b.sums);
  EXPECT_EQ(a.all.size(), b.all.size());
  for (size_t i = 0; i < a.all.size(); ++i) {
    a.all[i] = i < a.sums ? a.all[i] + b.all[i] : std::max(a.all[i], b.all[i]);
  }
  return a;
}

AWDResult import(AWDRender render, const Numbers& numbers, AWDPassStatistics* figures = nullptr) {
  return awdImportPass(render, numbers.all.data(), numbers.all.size(), figures);
}

/// What a process has.
struct Rank {
  Rank(const SceneBuilder& room, const AWDRenderDesc& desc, uint32_t threads)
      : device(newDevice(threads)), scene(room.commit(device)), render(newRender(scene, desc)) {}
  Device device;
  Scene scene;
  Render render;
};

class Parts : public testing::Test {
 protected:
  std::vector<Rank> ranks(uint32_t count) const {
    std::vector<Rank> made;
    for (uint32_t i = 0; i < count; ++i) made.emplace_back(room_, desc_, 1 + i % 2);
    return made;
  }
  /// The next pass; false: there is none left.
  static bool pass(std::vector<Rank>& ranks, const AWDSchedule& schedule) {
    const auto count = static_cast<uint32_t>(ranks.size());
    uint32_t samples = 0;
    Numbers all;
    for (uint32_t i = 0; i < count; ++i) {
      must(awdRenderPassPart(ranks[i].render, &schedule, i, count, &samples));
      if (samples == 0) continue;
      all = i == 0 ? exported(ranks[i].render) : combined(all, exported(ranks[i].render));
    }
    if (samples == 0) return false;
    for (Rank& rank : ranks) must(import(rank.render, all));
    return true;
  }

  const SceneBuilder room_ = sevenLampRoom();
  const AWDCamera view_ = lampRoomCamera(33);  // 9 tiles
  AWDRenderDesc desc_ = renderDesc(view_, AWD_GUIDE_ADAPTIVE, 7);
};

TEST_F(Parts, HaveTheBitsOfTheWholeSlow) {
  static const uint32_t passes[] = {2, 3, 4};
  AWDSchedule divided = AWD_SCHEDULE_INIT, listed = divided, few = divided, limited = divided;
  divided.totalSamples = 12;
  listed.samplesPerPass = passes;
  listed.passCount = 3;
  few.totalSamples = 4;  // too few for guiding
  limited.error = 0.3;
  limited.totalSamples = 24;
  const auto expectSame = [&](const AWDSchedule& schedule, const char* name) {
    SCOPED_TRACE(name);
    const Rank alone(room_, desc_, 2);
    must(awdRenderPasses(alone.render, &schedule));
    const Outcome whole = outcomeOf(alone.render);
    for (const uint32_t count : {1u, 2u, 4u, 10u}) {
      SCOPED_TRACE(count);
      std::vector<Rank> all = ranks(count);
      while (pass(all, schedule)) {
      }
      for (const Rank& rank : all) expectSameOutcome(outcomeOf(rank.render), whole);
    }
  };
  expectSame(divided, "divided");
  expectSame(few, "few");
  expectSame(limited, "limited");
  desc_.guide = AWD_GUIDE_COSINE;
  expectSame(listed, "unguided");
  desc_.guide = AWD_GUIDE_ADAPTIVE;
  desc_.preset = AWD_PRESET_PAPER;
  expectSame(listed, "paper");
}

/// A process dies, and the others are cancelled, in the middle of a pass: others, of another
/// number, go on from the last checkpoint.
TEST_F(Parts, GoOnFromACheckpoint) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = 12;
  const Rank alone(room_, desc_, 2);
  must(awdRenderPasses(alone.render, &schedule));
  const TemporaryFolder folder;
  const std::string file = folder.path("a.checkpoint");
  std::vector<Rank> three = ranks(3);
  for (int i = 0; i < 4; ++i) ASSERT_TRUE(pass(three, schedule));
  must(awdSaveRender(three[1].render, file.c_str()));
  uint32_t samples = 0;
  must(awdRenderPassPart(three[1].render, &schedule, 1, 3, &samples));
  expectFailure(awdSaveRender(three[1].render, file.c_str()), AWD_ERROR_INVALID_OPERATION,
                {"part of a pass"});

  std::vector<Rank> two = ranks(2);
  for (Rank& rank : two) {
    must(awdLoadRender(rank.scene, file.c_str(), nullptr, &desc_, rank.render.out()));
  }
  while (pass(two, schedule)) {
  }
  for (const Rank& rank : two) expectSameOutcome(outcomeOf(rank.render), outcomeOf(alone.render));

  // The one whose part was never imported renders the same pass, and the rest, by itself.
  AWDSchedule rest = schedule;
  rest.resume = 1;
  must(awdRenderPasses(three[1].render, &rest));
  expectSameOutcome(outcomeOf(three[1].render), outcomeOf(alone.render));
}

TEST_F(Parts, TellTheTimeOfAll) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = 12;
  std::vector<Rank> two = ranks(2);
  uint32_t samples = 0;
  for (uint32_t i : {0u, 1u}) must(awdRenderPassPart(two[i].render, &schedule, i, 2, &samples));
  const Numbers all = combined(exported(two[0].render), exported(two[1].render));
  AWDPassStatistics figures[2] = {AWD_PASS_STATISTICS_INIT, AWD_PASS_STATISTICS_INIT};
  for (uint32_t i : {0u, 1u}) must(import(two[i].render, all, &figures[i]));
  EXPECT_GT(figures[0].cpuSeconds, 0.0);
  EXPECT_EQ(figures[0].cpuSeconds, figures[1].cpuSeconds);
  EXPECT_EQ(figures[0].wallSeconds, figures[1].wallSeconds);
}

TEST_F(Parts, ThatDontMakeAPassAreRefused) {
  AWDSchedule schedule = AWD_SCHEDULE_INIT;
  schedule.totalSamples = 12;
  std::vector<Rank> two = ranks(2);
  AWDRender first = two[0].render, second = two[1].render;
  uint32_t samples = 9;
  size_t sums = 0, maxima = 0;
  const auto bad = AWD_ERROR_INVALID_ARGUMENT;
  expectFailure(awdExportPass(first, nullptr, 0, &sums, &maxima), AWD_ERROR_INVALID_OPERATION,
                {"awdRenderPassPart"});
  expectFailure(awdRenderPassPart(first, &schedule, 2, 2, &samples), bad, {"part is 2 of 2"});
  EXPECT_EQ(samples, 0u);
  expectFailure(awdRenderPassPart(first, &schedule, 0, 0, &samples), bad, {"parts"});
  expectFailure(awdRenderPassPart(first, &schedule, 0, 2, nullptr), bad, {"samplesPerPixel"});
  AWDSchedule timed = AWD_SCHEDULE_INIT;
  timed.seconds = 1.0;
  expectFailure(awdRenderPassPart(first, &timed, 0, 2, &samples), bad, {"seconds"});

  const auto render = [&](AWDRender of, uint32_t part, uint32_t parts) {
    must(awdRenderPassPart(of, &schedule, part, parts, &samples));
    return exported(of);
  };
  const Numbers ours = render(first, 0, 2), theirs = render(second, 1, 2);
  const std::vector<char> before = fieldBytes(first);
  const auto expectRefused = [&](const Numbers& numbers, const char* part) {
    expectFailure(import(first, numbers), bad, {part});
    EXPECT_TRUE(fieldBytes(first) == before);
    EXPECT_EQ(readFilm(first).samplesPerPixel, 0u);
  };
  expectRefused(ours, "1 parts of a pass of 2");
  expectRefused(combined(ours, ours), "each must be in them once");
  expectRefused(combined(combined(ours, theirs), theirs), "3 parts of a pass of 2");
  expectRefused(combined(ours, render(second, 1, 3)), "differ in");
  schedule.totalSamples = 5;  // unguided
  Numbers fewer = render(second, 1, 2);
  fewer.all.insert(fewer.all.begin() + static_cast<std::ptrdiff_t>(fewer.sums),
                   ours.sums - fewer.sums, 0);
  fewer.all.resize(ours.all.size());
  fewer.sums = ours.sums;
  expectRefused(combined(ours, fewer), "differ in");
  Numbers broken = combined(ours, theirs);
  broken.all[6 + 9 * 40] = ~uint64_t{0};
  expectRefused(broken, "pixel 40 make no sense");
  broken = combined(ours, theirs);
  broken.all.pop_back();
  expectRefused(broken, "count is");
  // In another seed only the digests show it.
  desc_.seed = 8;
  const Rank other(room_, desc_, 1);
  schedule.totalSamples = 12;
  expectRefused(combined(ours, render(other.render, 1, 2)), "differ in");
  must(import(first, combined(ours, theirs)));
  EXPECT_EQ(readFilm(first).samplesPerPixel, 1u);
}

}  // namespace
