// SPDX-License-Identifier: Apache-2.0
// Fields as bytes and files: they go on with the same bits, damage is found, and parts of a pass
// recorded in several processes add up.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include "field/saved.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

class FieldBytes : public testing::Test {
 protected:
  Device device_ = newDevice(1u);
};

TEST_F(FieldBytes, ALoadedFieldGoesOnWithTheSameBits) {
  const Device other = newDevice(2u);
  for (const FieldCase& c : fieldCases()) {
    SCOPED_TRACE(c.name);
    const Field field = trainedField(device_, c);
    Random random(23);
    feed(field, c.spatial(), random, 300);
    must(awdMarkField(field));
    feed(field, c.spatial(), random, 300);
    const Bytes bytes = saved(field);
    const Field copy = loaded(other, bytes);
    EXPECT_TRUE(saved(copy) == bytes);

    Random ours(29), theirs(29);
    feed(field, c.spatial(), ours, 200);
    feed(copy, c.spatial(), theirs, 200);
    must(awdRevertField(field));
    must(awdRevertField(copy));
    for (int pass = 0; pass < 3; ++pass) {
      feed(field, c.spatial(), ours, 500);
      feed(copy, c.spatial(), theirs, 500);
      EXPECT_TRUE(sameBytes(field, copy)) << "before adapt " << pass;
      const AWDFieldStatistics a = adapt(field), b = adapt(copy);
      EXPECT_EQ(a.patches, b.patches);
      EXPECT_EQ(a.bytes, b.bytes);
      EXPECT_EQ(a.samples, pass == 0 ? 800u : 500u);
      EXPECT_EQ(b.samples, a.samples);
      EXPECT_EQ(a.capped, b.capped);
      EXPECT_TRUE(sameBytes(field, copy)) << "after adapt " << pass;
    }
  }
}

TEST_F(FieldBytes, FreshFieldsAndThoseOfOneTouchComeBack) {
  for (const FieldCase& c : fieldCases()) {
    const Field field = newField(device_, &c.desc);
    must(awdSetFieldScale(field, 300.0));
    EXPECT_TRUE(sameBytes(field, loaded(device_, saved(field)))) << c.name;
    Random random(31);
    feed(field, c.spatial(), random, 1);
    const Field copy = loaded(device_, saved(field));
    adapt(field);
    adapt(copy);
    EXPECT_TRUE(sameBytes(field, copy)) << c.name;
  }
}

TEST_F(FieldBytes, DamageIsFound) {
  const Field field = trainedField(device_, fieldCases()[1]);
  const Bytes bytes = saved(field);
  Random random(37);
  const auto below = [&](size_t n) { return static_cast<size_t>(random.uniform() * double(n)); };
  for (int i = 0; i < 300; ++i) {
    Bytes damaged = bytes;
    // Most of the bits are those of numbers: as many flips in the head as elsewhere.
    const size_t at = below(i % 2 ? bytes.size() : 200);
    if (i % 3 == 0) {
      damaged.resize(at);
    } else {
      damaged[at] = static_cast<char>(damaged[at] ^ (1 << below(8)));
    }
    AWDField none = field;
    ASSERT_EQ(awdLoadField(device_, damaged.data(), damaged.size(), &none), AWD_ERROR_IO);
    ASSERT_EQ(none, nullptr);
    ASSERT_STRNE(awdGetLastErrorMessage(), "");
  }
}

TEST_F(FieldBytes, BytesOfOtherKindsAndVersions) {
  const Field field = newField(device_);
  const Bytes bytes = saved(field);
  AWDField none;
  const auto expectRefused = [&](const Bytes& other, const std::vector<std::string>& parts) {
    expectFailure(awdLoadField(device_, other.data(), other.size(), &none), AWD_ERROR_IO, parts);
  };
  Bytes other = bytes;
  other[0] = 'B';
  expectRefused(other, {"not a saved field"});
  other = bytes;
  other[8] = 9;
  expectRefused(other, {"version 9", "version 2"});
  other = bytes;
  other.pop_back();
  expectRefused(other, {std::to_string(bytes.size()) + " bytes", std::to_string(other.size())});
  other = bytes;
  other.back() = static_cast<char>(other.back() ^ 1);
  expectRefused(other, {"checksum"});
  const char nothing = 0;
  expectFailure(awdLoadField(device_, &nothing, 0, &none), AWD_ERROR_IO, {"0 bytes"});
}

TEST_F(FieldBytes, TheSizeIsToldBeforeAnythingIsWritten) {
  const Field field = newField(device_);
  size_t size = 0, again = 0;
  must(awdSaveField(field, nullptr, 0, &size));
  Bytes bytes(size, 'x');
  expectFailure(awdSaveField(field, bytes.data(), size - 1, &again), AWD_ERROR_INVALID_ARGUMENT,
                {"capacity", std::to_string(size - 1), std::to_string(size)});
  EXPECT_EQ(again, size);
  EXPECT_EQ(bytes, Bytes(size, 'x'));
  expectFailure(awdSaveField(field, nullptr, size, &again), AWD_ERROR_INVALID_ARGUMENT, {"bytes"});
  expectFailure(awdSaveField(field, nullptr, 0, nullptr), AWD_ERROR_INVALID_ARGUMENT, {"size"});
}

class FieldFiles : public FieldBytes {
 protected:
  FieldFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "awd-field-XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~FieldFiles() override { std::filesystem::remove_all(folder_); }
  std::string path(const char* name) const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

TEST_F(FieldFiles, AFileIsTheSameBytes) {
  const Field field = trainedField(device_, fieldCases()[0]);
  const std::string file = path("a.field");
  must(awdWriteField(field, file.c_str()));
  Field copy;
  must(awdReadField(device_, file.c_str(), copy.out()));
  EXPECT_TRUE(sameBytes(field, copy));
  adapt(copy);
  must(awdWriteField(copy, file.c_str()));  // over the former one
  must(awdReadField(device_, file.c_str(), copy.out()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(FieldFiles, WhatIsWrongWithAFileIsSaid) {
  const Field field = newField(device_);
  AWDField none = field;
  const std::string missing = path("no/such.field"), damaged = path("damaged.field");
  expectFailure(awdReadField(device_, missing.c_str(), &none), AWD_ERROR_IO, {missing, "No such"});
  EXPECT_EQ(none, nullptr);
  expectFailure(awdWriteField(field, missing.c_str()), AWD_ERROR_IO, {missing, "No such"});
  const Bytes bytes = saved(field);
  std::ofstream(damaged, std::ios::binary).write(bytes.data(), 50);
  expectFailure(awdReadField(device_, damaged.c_str(), &none), AWD_ERROR_IO, {damaged, "50"});
  std::ofstream(damaged, std::ios::binary).close();
  expectFailure(awdReadField(device_, damaged.c_str(), &none), AWD_ERROR_IO, {damaged, "0 bytes"});
  expectFailure(awdWriteField(field, nullptr), AWD_ERROR_INVALID_ARGUMENT, {"path"});
  expectFailure(awdReadField(device_, nullptr, &none), AWD_ERROR_INVALID_ARGUMENT, {"path"});
}

/// As two processes would: each loads the same bytes, and one takes the bytes of the other back.
TEST_F(FieldBytes, PartsOfAPassAddUpToTheBitsOfTheWhole) {
  const Device here = newDevice(1u), there = newDevice(2u);
  for (const FieldCase& c : fieldCases()) {
    SCOPED_TRACE(c.name);
    const Bytes bytes = saved(trainedField(device_, c));
    const Field whole = loaded(device_, bytes), first = loaded(here, bytes);
    Field second = loaded(there, bytes);
    Random random(41);
    for (int pass = 0; pass < 2; ++pass) {
      for (int i = 0; i < 1200; ++i) {
        const Fed fed = drawFed(whole, c.spatial(), random);
        recordFed(whole, fed);
        recordFed(i % 3 ? first : second, fed);
        if (i == 600) must(awdMarkField(second));
      }
      must(awdMergeField(first, loaded(here, saved(second))));
      EXPECT_TRUE(sameBytes(first, whole)) << "before the adapt";
      adapt(whole);
      adapt(first);
      EXPECT_TRUE(sameBytes(first, whole));
      second = loaded(there, saved(first));
    }
  }
}

TEST_F(FieldBytes, WhatThreadsRecordHasTheBitsOfOne) {
  const FieldCase c = fieldCases()[1];
  const Bytes bytes = saved(trainedField(device_, c));
  const Field alone = loaded(device_, bytes);
  std::vector<Fed> all(4000);
  Random random(43);
  for (Fed& fed : all) fed = drawFed(alone, true, random);
  for (const Fed& fed : all) recordFed(alone, fed);
  adapt(alone);
  for (const size_t threads : {2u, 5u}) {
    const Device device = newDevice(static_cast<uint32_t>(threads));
    const Field together = loaded(device, bytes);
    std::vector<std::thread> running;
    for (size_t t = 0; t < threads; ++t) {
      running.emplace_back([&, t] {
        for (size_t i = t; i < all.size(); i += threads) recordFed(together, all[i]);
      });
    }
    for (std::thread& thread : running) thread.join();
    adapt(together);
    EXPECT_TRUE(sameBytes(together, alone)) << threads << " threads";
  }
}

TEST_F(FieldBytes, OnlyFieldsThatAreTheSameAreMerged) {
  const FieldCase c = fieldCases()[1];
  const Field field = trainedField(device_, c);
  const Bytes before = saved(field);
  const auto expectRefused = [&](AWDField other, const char* part) {
    expectFailure(awdMergeField(field, other), AWD_ERROR_INVALID_ARGUMENT, {part});
    EXPECT_TRUE(saved(field) == before) << part;
  };
  expectRefused(field, "itself");
  expectRefused(nullptr, "other");
  expectFailure(awdMergeField(nullptr, field), AWD_ERROR_INVALID_ARGUMENT, {"field"});

  const auto with = [&](const char* part, const auto& change) {
    FieldCase other = c;
    change(other.desc);
    expectRefused(trainedField(device_, other), part);
  };
  with("its map", [](AWDFieldDesc& desc) { desc.map = AWD_MAP_CYLINDRICAL; });
  with("its basis", [](AWDFieldDesc& desc) { desc.basis = "haar"; });
  with("its levels", [](AWDFieldDesc& desc) { desc.startLevel = AWD_LEVEL(1); });
  with("its estimator", [](AWDFieldDesc& desc) { desc.estimator = AWD_ESTIMATOR_QUASI; });
  with("alpha", [](AWDFieldDesc& desc) { desc.alpha = 0.5; });
  with("tau", [](AWDFieldDesc& desc) { desc.tau = 0.5; });
  with("its box", [](AWDFieldDesc& desc) { desc.upper[1] = 2.0f; });
  with("kind of its patches", [](AWDFieldDesc& desc) { desc.patchSamples = 50; });

  expectRefused(newField(device_, &c.desc), "where its patches lie");
  const Field scaled = loaded(device_, before);
  must(awdSetFieldScale(scaled, 1e6));
  expectRefused(scaled, "scale");
  // The same patches, of which one has learned something else.
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  const Field a = newField(device_, &desc), b = newField(device_, &desc);
  Random random(47);
  const float up[3] = {0, 0, 1};
  for (int i = 0; i < 100; ++i) {
    AWDDirectionSample sample = draw(a, 5, up, random);
    must(awdRecordField(a, 5, &sample, static_cast<double>(sample.square[0])));
    const double value = static_cast<double>(sample.square[0]);
    std::swap(sample.square[0], sample.square[1]);  // of the same mean
    must(awdRecordField(b, 5, &sample, value));
  }
  adapt(a);
  must(awdMergeField(a, loaded(device_, saved(a))));
  adapt(b);
  expectFailure(awdMergeField(a, b), AWD_ERROR_INVALID_ARGUMENT, {"patch 5 has learned"});
  const Field fresh = newField(device_, &desc);
  expectFailure(awdMergeField(a, fresh), AWD_ERROR_INVALID_ARGUMENT, {"patch 5 has learned"});
  expectFailure(awdMergeField(fresh, a), AWD_ERROR_INVALID_ARGUMENT, {"patch 5 has learned"});
}

}  // namespace
