// SPDX-License-Identifier: Apache-2.0
// Parts of a pass recorded by several fields and combined number by number, as MPI_Allreduce does.
#include <algorithm>

#include "field/saved.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

using Patches = std::vector<uint32_t>;

struct Exported {
  std::vector<uint64_t> numbers;
  size_t sums = 0, maxima = 0;
};

Exported exported(AWDField field, const Patches& patches) {
  Exported result;
  must(awdExportField(field, patches.data(), patches.size(), nullptr, 0, &result.sums,
                      &result.maxima));
  result.numbers.resize(result.sums + result.maxima);
  must(awdExportField(field, patches.data(), patches.size(), result.numbers.data(),
                      result.numbers.size(), &result.sums, &result.maxima));
  return result;
}

Exported combined(Exported a, const Exported& b) {
  EXPECT_EQ(a.sums, b.sums);
  EXPECT_EQ(a.numbers.size(), b.numbers.size());
  for (size_t i = 0; i < a.numbers.size(); ++i) {
    uint64_t& x = a.numbers[i];
    x = i < a.sums ? x + b.numbers[i] : std::max(x, b.numbers[i]);
  }
  return a;
}

AWDResult import(AWDField field, const Patches& patches, const Exported& numbers) {
  return awdImportField(field, patches.data(), patches.size(), numbers.numbers.data(),
                        numbers.numbers.size());
}

class Exchange : public testing::Test {
 protected:
  /// Of all that may be recorded in, some never are.
  static Patches patchesOf(const FieldCase& c) {
    return c.spatial() ? Patches() : Patches{0, 1, 2, 9};
  }

  Device device_ = newDevice(1u);
};

/// From the first pass on, in which each field has touched other patches; one of them touches none.
TEST_F(Exchange, HasTheBitsOfOneFieldThatRecordedAll) {
  for (const FieldCase& c : fieldCases()) {
    SCOPED_TRACE(c.name);
    const Patches patches = patchesOf(c);
    const Field whole = newField(device_, &c.desc);
    std::vector<Field> parts;
    for (int i = 0; i < 4; ++i) parts.push_back(newField(device_, &c.desc));
    Random random(61);
    for (int pass = 0; pass < 4; ++pass) {
      for (int i = 0; i < 900; ++i) {
        const Fed fed = drawFed(whole, c.spatial(), random);
        recordFed(whole, fed);
        // By place, so that patches are each one part's; and two that share.
        recordFed(parts[pass % 2 ? fed.patch / 8 % 3 : i % 3], fed);
      }
      Exported all = exported(parts[0], patches);
      for (int i = 1; i < 4; ++i) all = combined(all, exported(parts[i], patches));
      // What awdMergeField makes of it.
      const Field merged = loaded(device_, saved(parts[0]));
      for (int i = 1; i < 4; ++i) must(awdMergeField(merged, parts[i]));
      EXPECT_TRUE(sameBytes(merged, whole));
      for (const Field& part : parts) {
        must(import(part, patches, all));
        EXPECT_TRUE(sameBytes(part, whole)) << "before adapt " << pass;
        adapt(part);
      }
      adapt(whole);
      for (const Field& part : parts) EXPECT_TRUE(sameBytes(part, whole)) << "adapt " << pass;
    }
  }
}

TEST_F(Exchange, AfterAMarkWhatCameBeforeItStays) {
  const FieldCase c = fieldCases()[1];
  const Bytes bytes = saved(trainedField(device_, c));
  const Field whole = loaded(device_, bytes), first = loaded(device_, bytes),
              second = loaded(device_, bytes);
  Random random(67);
  for (int pass = 0; pass < 3; ++pass) {
    for (const Field* field : {&whole, &first, &second}) must(awdMarkField(*field));
    for (int i = 0; i < 600; ++i) {
      const Fed fed = drawFed(whole, true, random);
      recordFed(whole, fed);
      recordFed(i % 2 ? first : second, fed);
    }
    const Exported all = combined(exported(first, {}), exported(second, {}));
    for (const Field* field : {&first, &second}) {
      must(import(*field, {}, all));
      EXPECT_TRUE(sameBytes(*field, whole));
    }
  }
  for (const Field* field : {&whole, &first, &second}) adapt(*field);
  EXPECT_TRUE(sameBytes(first, whole));
  EXPECT_TRUE(sameBytes(second, whole));
}

/// Values that are wrong, too large for the unit, or so many that sums go past their end.
TEST_F(Exchange, OfExtremesToo) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const FieldCase& c : fieldCases()) {
    SCOPED_TRACE(c.name);
    const Patches patches = patchesOf(c);
    const Field whole = newField(device_, &c.desc);
    std::vector<Field> parts;
    for (int i = 0; i < 3; ++i) parts.push_back(newField(device_, &c.desc));
    Random random(71);
    const double values[] = {1e-300, 1e300, -1.0, inf, std::nan(""), 0.0, 1.0};
    for (int pass = 0; pass < 3; ++pass) {
      for (int i = 0; i < 500; ++i) {
        Fed fed = drawFed(whole, c.spatial(), random);
        fed.value = values[random.bits() % 7];
        recordFed(whole, fed);
        recordFed(parts[i % 3], fed);
      }
      Exported all = exported(parts[0], patches);
      for (int i = 1; i < 3; ++i) all = combined(all, exported(parts[i], patches));
      const Field merged = loaded(device_, saved(parts[0]));
      for (int i = 1; i < 3; ++i) must(awdMergeField(merged, parts[i]));
      adapt(whole);
      for (const Field& part : parts) {
        must(import(part, patches, all));
        EXPECT_TRUE(sameBytes(part, merged));
        adapt(part);
        EXPECT_TRUE(sameBytes(part, whole));
      }
    }
  }
}

/// A sum that goes past its end once or more, which its own bits don't always tell, ends a patch's
/// pass as it does in one process.
TEST_F(Exchange, SumsPastTheirEndAreFoundOut) {
  const Field fresh = newField(device_);
  const float up[3] = {0, 0, 1};
  Random random(73);
  const AWDDirectionSample sample = draw(fresh, 0, up, random);
  const Field part = newField(device_);
  for (int i = 0; i < 2000; ++i) must(awdRecordField(part, 0, &sample, 1e30));  // all clamped
  const Exported one = exported(part, {0});
  for (int doublings = 0; doublings < 6; ++doublings) {
    Exported all = one;
    const Field merged = loaded(device_, saved(part));
    for (int k = 1; k < 1 << doublings; ++k) {
      all = combined(all, one);
      must(awdMergeField(merged, part));
    }
    const Field imported = newField(device_);
    must(import(imported, {0}, all));
    EXPECT_TRUE(sameBytes(imported, merged)) << (1 << doublings) << " parts";
  }
}

TEST_F(Exchange, OnlyOfFieldsThatAreTheSame) {
  const FieldCase c = fieldCases()[1];
  const Bytes bytes = saved(trainedField(device_, c));
  const Field field = loaded(device_, bytes);
  const auto expectRefused = [&](const Exported& numbers, const char* part) {
    expectFailure(import(field, {}, numbers), AWD_ERROR_INVALID_ARGUMENT, {part});
    EXPECT_TRUE(saved(field) == bytes) << part;
  };
  const auto expectOther = [&](const Field& other, const char* part) {
    Exported numbers = exported(other, {});
    expectRefused(numbers, part);
    const Exported ours = exported(field, {});
    if (numbers.sums == ours.sums) expectRefused(combined(ours, numbers), part);
  };
  expectRefused(exported(newField(device_, &c.desc), {}), "do all processes have the same");
  const Field scaled = loaded(device_, bytes);
  must(awdSetFieldScale(scaled, 1e6));
  expectOther(scaled, "the scale");

  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  const auto taught = [&](const AWDFieldDesc& of, uint64_t seed) {
    Field made = newField(device_, &of);
    Random random(seed);
    recordPass(made, 0, 100, random, [](double u, double) { return u; });
    adapt(made);
    return made;
  };
  const Field host = taught(desc, 1);
  const auto expectOtherHost = [&](const Field& other, const Patches& patches, const char* part) {
    expectFailure(import(host, {0, 1}, exported(other, patches)), AWD_ERROR_INVALID_ARGUMENT,
                  {part});
  };
  expectOtherHost(taught(desc, 2), {0, 1}, "what patches have learned");
  expectOtherHost(taught(desc, 1), {0, 2}, "where patches lie");
  AWDFieldDesc other = desc;
  other.alpha = 0.25;
  expectOtherHost(taught(other, 1), {0, 1}, "settings");
  must(import(host, {0, 1}, exported(taught(desc, 1), {0, 1})));

  Exported numbers = exported(field, {});
  numbers.numbers[0] = 0;
  expectRefused(numbers, "no field at all");
  numbers = exported(field, {});
  numbers.numbers.back() = ~uint64_t{0};  // as of maxima that were added up
  expectRefused(numbers, "make no sense");
}

TEST_F(Exchange, ArgumentsAreChecked) {
  const Field host = newField(device_), spatial = newField(device_, &fieldCases()[1].desc);
  size_t sums = 0, maxima = 0;
  const uint32_t patches[] = {3, 5, 5};
  std::vector<uint64_t> numbers(100000);
  const auto bad = AWD_ERROR_INVALID_ARGUMENT;
  uint64_t* to = numbers.data();
  expectFailure(awdExportField(nullptr, nullptr, 0, to, 9, &sums, &maxima), bad, {"field"});
  expectFailure(awdExportField(host, patches, 3, nullptr, 0, &sums, &maxima), bad,
                {"patches[2]", "ascend"});
  expectFailure(awdExportField(host, nullptr, 3, nullptr, 0, &sums, &maxima), bad, {"patches"});
  expectFailure(awdExportField(spatial, patches, 2, nullptr, 0, &sums, &maxima), bad,
                {"patchCount", "spatial"});
  expectFailure(awdExportField(spatial, nullptr, 0, nullptr, 0, nullptr, &maxima), bad, {"sums"});
  expectFailure(awdExportField(spatial, nullptr, 0, nullptr, 0, &sums, nullptr), bad, {"maxima"});
  must(awdExportField(host, patches, 2, nullptr, 0, &sums, &maxima));
  expectFailure(awdExportField(host, patches, 2, to, sums + maxima - 1, &sums, &maxima), bad,
                {"capacity"});
  EXPECT_EQ(numbers[0], 0u);
  expectFailure(awdImportField(host, patches, 2, to, sums + maxima - 1), bad, {"count"});
  expectFailure(awdImportField(host, patches, 2, nullptr, sums + maxima), bad, {"numbers"});
  expectFailure(awdImportField(nullptr, patches, 2, to, 1), bad, {"field"});

  Random random(79);
  const float up[3] = {0, 0, 1};
  const AWDDirectionSample sample = draw(host, 7, up, random);
  must(awdRecordField(host, 7, &sample, 1.0));
  expectFailure(awdExportField(host, patches, 2, to, numbers.size(), &sums, &maxima), bad,
                {"patch 7", "lacks"});
}

}  // namespace
