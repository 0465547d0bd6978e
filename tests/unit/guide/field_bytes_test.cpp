// SPDX-License-Identifier: Apache-2.0
// What a saved field holds may make no sense though its checksum is right: whoever made it that
// way, loading refuses it or makes a field that works.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "density/levels.h"
#include "guide/field.h"
#include "util/error.h"

namespace awd {
namespace {

constexpr std::size_t kHeader = 28;

/// Gives out so much and no more.
struct Allowance {
  std::size_t now = 0, most = 0, limit = std::size_t{1} << 26;

  AWDDeviceDesc desc() {
    AWDDeviceDesc result = AWD_DEVICE_DESC_INIT;
    result.threads = 1;
    result.alloc = [](void* user, size_t size, size_t) -> void* {
      auto& allowance = *static_cast<Allowance*>(user);
      if (size > allowance.limit - allowance.now) return nullptr;
      allowance.now += size;
      allowance.most = std::max(allowance.most, allowance.now);
      return std::malloc(size);
    };
    result.free = [](void* user, void* ptr, size_t size, size_t) {
      static_cast<Allowance*>(user)->now -= size;
      std::free(ptr);
    };
    result.allocUser = this;
    return result;
  }
};

const AWDBasisFamily& family(void*, const char* name) {
  for (const char* known : kFamilies) {
    if (std::string(known) == name) return table(known);
  }
  fail(AWD_ERROR_UNSUPPORTED, "no basis \"%s\"", name);
}

void feed(Field& field, int samples, uint64_t seed) {
  Uniforms random(seed);
  for (int i = 0; i < samples; ++i) {
    // In a part of the box alone, so that there are leaves without a sample.
    const Vec3f point = {0.3f * static_cast<float>(random()), static_cast<float>(random()), 0.5f};
    const double u[3] = {random(), random(), random()};
    const uint32_t patch =
        field.isSpatial() ? field.findPatch(point, {0, 0, 1}) : static_cast<uint32_t>(i % 3);
    const AWDDirectionSample s = field.sample(patch, {0, 0, 1}, u);
    field.record(patch, s, u[2] * double(s.square[0]));
  }
}

class FieldBytes : public testing::TestWithParam<AWDEstimator> {
 protected:
  Ref<Field> load(const std::pmr::vector<char>& bytes) {
    return Field::load(context_, bytes.data(), bytes.size(), {nullptr, family, nullptr});
  }
  static AWDFieldDesc desc() {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.estimator = GetParam();
    desc.startLevel = AWD_LEVEL(1);
    desc.maxLevel = AWD_LEVEL(2);
    desc.patches = AWD_PATCHES_SPATIAL;
    desc.upper[0] = desc.upper[1] = desc.upper[2] = 1.0f;
    desc.patchSamples = 100;
    return desc;
  }
  /// In the second pass after two, with a mark in it.
  Ref<Field> trained() {
    const AWDBasisFamily& basis = table("test-linear");
    Ref<Field> field =
        Field::make(context_, basis, settle(std::pmr::get_default_resource(), desc(), basis));
    for (uint64_t pass = 0; pass < 2; ++pass) {
      feed(*field, 600, pass);
      field->adapt();
    }
    feed(*field, 60, 2);
    field->mark();
    feed(*field, 60, 3);
    return field;
  }

  Allowance allowance_;
  const Ref<Context> context_ = Context::make(allowance_.desc());
  const std::size_t idle_ = allowance_.now;
};

INSTANTIATE_TEST_SUITE_P(Estimators, FieldBytes,
                         testing::Values(AWD_ESTIMATOR_LUMPED, AWD_ESTIMATOR_PAPER,
                                         AWD_ESTIMATOR_RATIO));

TEST_P(FieldBytes, WhatAPassNeedsToKnowOfAPatchComesBack) {
  const Ref<Field> field = trained();
  // What a leaf is known by during a pass is what was known before the pass touched it.
  const uint32_t touched = field->findPatch({0.9f, 0.9f, 0.5f}, {0, 0, 1});
  const double u[3] = {0.1, 0.2, 0.3};
  EXPECT_TRUE(field->view(touched).known && !field->view(touched).statistics);
  field->record(touched, field->sample(touched, {0, 0, 1}, u), 1.0);
  const Ref<Field> copy = load(field->bytesOf());
  EXPECT_GT(field->patches().size(), 8u);
  for (uint32_t leaf = 0; leaf < 100; ++leaf) {
    const PatchView ours = field->view(8 * leaf);
    const PatchView theirs = copy->view(8 * leaf);
    EXPECT_EQ(ours.mean, theirs.mean);
    EXPECT_EQ(ours.known, theirs.known) << leaf;
    EXPECT_EQ(ours.density->coefficients(), theirs.density->coefficients());
    EXPECT_EQ(ours.statistics == nullptr, theirs.statistics == nullptr) << leaf;
  }
  EXPECT_EQ(field->statistics().bytes, copy->statistics().bytes);
}

TEST_P(FieldBytes, RunningOutOfMemoryLosesNothing) {
  const Ref<Field> field = trained();
  const std::pmr::vector<char> bytes = field->bytesOf();
  const std::size_t before = allowance_.now;
  const Ref<Field> other = load(bytes);
  const std::size_t all = allowance_.now;
  for (int i = 0; i < 60; ++i) {
    allowance_.limit = all + (all - before) * static_cast<std::size_t>(i) / 60;
    EXPECT_THROW(load(bytes), std::bad_alloc);
    EXPECT_EQ(allowance_.now, all);
  }
  // To merge, only patches that have not been touched here need memory.
  allowance_.limit = std::size_t{1} << 26;
  other->adapt();
  const std::pmr::vector<char> adapted = other->bytesOf();
  const Ref<Field> first = load(adapted);
  const Ref<Field> second = load(adapted);
  for (uint32_t bin = 0; bin < SpatialTree::kBins; ++bin) {
    const double u[3] = {0.1, 0.2, 0.3};
    const uint32_t patch = 8 * bin;
    second->record(patch, second->sample(patch, {0, 0, 1}, u), 1.0);
  }
  allowance_.limit = allowance_.now + 100;
  EXPECT_THROW(first->merge(*second), std::bad_alloc);
  allowance_.limit = std::size_t{1} << 26;
  EXPECT_TRUE(first->bytesOf() == adapted);
  first->merge(*second);
  EXPECT_TRUE(first->bytesOf() == second->bytesOf());
}

/// The bytes of a field without patches, but for the 25 that say so: no splits of a tree, no views,
/// no densities, no patches.
std::pmr::vector<char> withoutEnd(const Field& fresh) {
  std::pmr::vector<char> bytes = fresh.bytesOf();
  bytes.resize(bytes.size() - 25);
  return {bytes.begin() + kHeader, bytes.end()};
}

std::pmr::vector<char> framed(const std::pmr::vector<char>& body,
                              const std::function<void(ByteWriter&)>& end) {
  ByteWriter writer(std::pmr::get_default_resource(), "AWDFIELD", 2);
  for (const char c : body) writer.put(c);
  end(writer);
  return writer.finish();
}

TEST_P(FieldBytes, LeavesDeeperThanAnyAreRefused) {
  const AWDBasisFamily& basis = table("haar");
  const Ref<Field> fresh =
      Field::make(context_, basis, settle(std::pmr::get_default_resource(), desc(), basis));
  const auto splits = [&](uint64_t count) {
    return framed(withoutEnd(*fresh), [&](ByteWriter& writer) {
      writer.put(count);
      for (uint64_t i = 0; i < count; ++i) {
        writer.put(uint32_t{0});
        writer.put(uint8_t{1});
      }
      writer.put(uint8_t{0});
      writer.put(uint64_t{0});
      writer.put(uint64_t{0});
    });
  };
  const Ref<Field> deepest = load(splits(45));
  EXPECT_EQ(deepest->findPatch({9, 9, 9}, {1, 0, 0}) / 8, 6u) << "the half that split off first";
  EXPECT_EQ(deepest->findPatch({-9, -9, -9}, {1, 0, 0}) / 8, 0u);
  EXPECT_THROW(load(splits(46)), Error);
}

TEST_P(FieldBytes, NoMemoryIsTakenForWhatIsNotThere) {
  AWDFieldDesc fine = desc();
  fine.startLevel = fine.maxLevel = AWD_LEVEL(6);
  const AWDBasisFamily& basis = table("haar");
  const Ref<Field> fresh =
      Field::make(context_, basis, settle(std::pmr::get_default_resource(), fine, basis));
  load(fresh->bytesOf());
  const std::size_t most = allowance_.most;
  const auto bytes = framed(withoutEnd(*fresh), [&](ByteWriter& writer) {
    writer.put(uint64_t{0});
    writer.put(uint8_t{0});
    writer.put(uint64_t{0});
    writer.put(uint64_t{1});
    writer.put(uint32_t{0});
    writer.put(uint32_t{0xffffffffu});  // the start density
    for (int i = 0; i < 90; ++i) writer.put(char{0});
  });
  EXPECT_THROW(load(bytes), Error);
  EXPECT_LT(allowance_.most, most + 12000);  // the table of patches, without 32768 bytes of sums
}

TEST_P(FieldBytes, NonsenseUnderARightChecksumIsRefusedOrWorks) {
  const std::pmr::vector<char> bytes(trained()->bytesOf(), std::pmr::get_default_resource());
  Uniforms random(67);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() * double(n)); };
  int refused = 0, worked = 0;
  for (int i = 0; i < 300; ++i) {
    std::pmr::vector<char> forged = bytes;
    // Settings, counts and the tree are in the first bytes, numbers in all others.
    const std::size_t at = kHeader + below(i % 3 ? 400 : forged.size() - kHeader - 8);
    const std::size_t width = i % 2 ? 1 : 8;
    for (std::size_t k = 0; k < width; ++k) {
      forged[at + k] = i % 5 ? static_cast<char>(below(256)) : static_cast<char>(-1);
    }
    if (i % 7 == 0) forged.resize(at);
    ByteWriter frame(std::pmr::get_default_resource(), "AWDFIELD", 2);
    for (std::size_t k = kHeader; k < forged.size(); ++k) frame.put(forged[k]);
    try {
      const Ref<Field> field = load(frame.finish());
      feed(*field, 20, 71);
      field->adapt();
      ++worked;
    } catch (const Error& error) {
      EXPECT_NE(error.code(), AWD_ERROR_UNKNOWN) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(worked, 20);
  EXPECT_EQ(allowance_.now, idle_);
  EXPECT_LT(allowance_.most, std::size_t{1} << 23);
}

}  // namespace
}  // namespace awd
