// SPDX-License-Identifier: Apache-2.0
// Many items at a time: the bits of single calls, and errors that say which item is wrong.
#include <algorithm>
#include <limits>

#include "field/saved.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

constexpr size_t kCount = 200;
constexpr size_t kBad = 21;  // where the vector of item 7 begins
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

void expectSame(const AWDDirectionSample& a, const AWDDirectionSample& b) {
  EXPECT_TRUE(std::equal(a.direction, a.direction + 3, b.direction));
  EXPECT_TRUE(std::equal(a.square, a.square + 2, b.square));
  EXPECT_EQ(a.pdf, b.pdf);
  EXPECT_EQ(a.component, b.component);
  EXPECT_EQ(a.solidAngle, b.solidAngle);
}

/// What a wavefront has at hand, of a field that knows something.
class Batch : public testing::TestWithParam<FieldCase> {
 protected:
  Batch() : field_(trainedField(device_, GetParam())) {
    const std::vector<Normal> all = someNormals();
    for (size_t i = 0; i < kCount; ++i) {
      for (int k = 0; k < 3; ++k) {
        positions_.push_back(static_cast<float>(random_.uniform()));
        normals_.push_back(all[i % all.size()].values[k]);
        directions_.push_back(all[(i / 3) % all.size()].values[k]);
        uniforms_.push_back(random_.uniform());
      }
      patches_.push_back(static_cast<uint32_t>(i % 5));
      values_.push_back(random_.uniform());
    }
    if (GetParam().spatial()) findAll();
    must(awdSampleFieldBatch(field_, kCount, patches_.data(), normals_.data(), uniforms_.data(),
                             samples_.data()));
  }
  void findAll() {
    must(awdFindPatches(field_, kCount, positions_.data(), normals_.data(), patches_.data()));
  }

  Random random_{53};
  Device device_ = newDevice(1u);
  Field field_;
  std::vector<float> positions_, normals_, directions_;
  std::vector<double> uniforms_, values_;
  std::vector<uint32_t> patches_;
  std::vector<AWDDirectionSample> samples_ = std::vector<AWDDirectionSample>(kCount);
};

INSTANTIATE_TEST_SUITE_P(Fields, Batch, testing::ValuesIn(fieldCases()),
                         [](const auto& of) { return std::string(of.param.name); });

/// Also of normals and directions that are unit vectors only nearly.
TEST_P(Batch, HasTheBitsOfSingleCallsOfNearlyUnitVectors) {
  for (float& x : normals_) x *= 1.0009f;
  for (float& x : directions_) x *= 0.9991f;
  if (GetParam().spatial()) findAll();
  std::vector<float> pdfs(kCount);
  must(awdSampleFieldBatch(field_, kCount, patches_.data(), normals_.data(), uniforms_.data(),
                           samples_.data()));
  must(awdGetFieldPdfs(field_, kCount, patches_.data(), normals_.data(), directions_.data(),
                       pdfs.data()));
  for (size_t i = 0; i < kCount; ++i) {
    AWDDirectionSample one = {};
    must(awdSampleField(field_, patches_[i], &normals_[3 * i], &uniforms_[3 * i], &one));
    expectSame(samples_[i], one);
    float pdf = 0.0f;
    must(awdGetFieldPdf(field_, patches_[i], &normals_[3 * i], &directions_[3 * i], &pdf));
    EXPECT_EQ(pdfs[i], pdf);
    if (!GetParam().spatial()) continue;
    uint32_t patch = 0;
    must(awdFindPatch(field_, &positions_[3 * i], &normals_[3 * i], &patch));
    EXPECT_EQ(patches_[i], patch);
  }
}

TEST_P(Batch, HasTheBitsOfSingleCalls) {
  std::vector<float> pdfs(kCount);
  must(awdGetFieldPdfs(field_, kCount, patches_.data(), normals_.data(), directions_.data(),
                       pdfs.data()));
  const Field copy = loaded(device_, saved(field_));
  must(awdRecordFieldBatch(field_, kCount, patches_.data(), samples_.data(), values_.data()));
  size_t above = 0;
  for (size_t i = 0; i < kCount; ++i) {
    const float* normal = &normals_[3 * i];
    if (GetParam().spatial()) {
      uint32_t patch;
      must(awdFindPatch(copy, &positions_[3 * i], normal, &patch));
      EXPECT_EQ(patches_[i], patch);
    }
    AWDDirectionSample sample;
    must(awdSampleField(copy, patches_[i], normal, &uniforms_[3 * i], &sample));
    expectSame(sample, samples_[i]);
    float pdf;
    must(awdGetFieldPdf(copy, patches_[i], normal, &directions_[3 * i], &pdf));
    EXPECT_EQ(pdfs[i], pdf);
    above += pdf > 0.0f;
    must(awdRecordField(copy, patches_[i], &samples_[i], values_[i]));
  }
  EXPECT_GT(above, kCount / 10);
  EXPECT_TRUE(sameBytes(field_, copy));
  EXPECT_EQ(adapt(field_).samples, kCount);
}

TEST_P(Batch, OfNoneNeedsNoArrays) {
  must(awdSampleFieldBatch(field_, 0, nullptr, nullptr, nullptr, nullptr));
  must(awdGetFieldPdfs(field_, 0, nullptr, nullptr, nullptr, nullptr));
  must(awdRecordFieldBatch(field_, 0, nullptr, nullptr, nullptr));
  if (GetParam().spatial()) must(awdFindPatches(field_, 0, nullptr, nullptr, nullptr));
}

TEST_P(Batch, AWrongItemIsNamedAndNothingIsDone) {
  const Bytes before = saved(field_);
  const auto expectBad = [](AWDResult result, const char* argument) {
    expectFailure(result, AWD_ERROR_INVALID_ARGUMENT, {argument, "item 7"});
  };
  const auto record = [&] {
    return awdRecordFieldBatch(field_, kCount, patches_.data(), samples_.data(), values_.data());
  };
  const AWDDirectionSample good = samples_[7];
  samples_[7].solidAngle = 0.0f;
  expectBad(record(), "solidAngle");
  samples_[7] = good;
  if (GetParam().desc.preset == AWD_PRESET_PAPER) {
    samples_[7].component = AWD_INVALID_ID;
    expectBad(record(), "component");
  } else {
    samples_[7].square[1] = kNaN;
    expectBad(record(), "square");
    samples_[7] = good;
    samples_[7].pdf = kNaN;
    expectBad(record(), "pdf");
  }
  samples_[7] = good;
  if (GetParam().spatial()) {
    const uint32_t patch = patches_[7];
    patches_[7] = 1u << 30;
    expectBad(record(), "patch");
    patches_[7] = patch;
    positions_[kBad] = kNaN;
    expectBad(awdFindPatches(field_, kCount, positions_.data(), normals_.data(), patches_.data()),
              "positions");
  }
  EXPECT_TRUE(saved(field_) == before) << "nothing was recorded";

  directions_[kBad + 1] = 3.0f;
  std::vector<float> pdfs(kCount, -1.0f);
  expectBad(awdGetFieldPdfs(field_, kCount, patches_.data(), normals_.data(), directions_.data(),
                            pdfs.data()),
            "directions");
  EXPECT_EQ(pdfs, std::vector<float>(kCount, -1.0f));
  uniforms_[kBad + 2] = 1.0;
  expectBad(awdSampleFieldBatch(field_, kCount, patches_.data(), normals_.data(), uniforms_.data(),
                                samples_.data()),
            "uniforms[2]");
  normals_[kBad] = 0.5f;
  uniforms_[kBad + 2] = 0.0;
  expectBad(awdSampleFieldBatch(field_, kCount, patches_.data(), normals_.data(), uniforms_.data(),
                                samples_.data()),
            "normals");
  expectFailure(awdRecordFieldBatch(field_, 1, patches_.data(), nullptr, values_.data()),
                AWD_ERROR_INVALID_ARGUMENT, {"samples"});
}

/// A direction that the field drew maps back to where it was drawn.
TEST_P(Batch, MapsDirectionsOfTheHost) {
  for (size_t i = 0; i < kCount; ++i) {
    const AWDDirectionSample& drawn = samples_[i];
    const float* normal = &normals_[3 * i];
    AWDDirectionSample mapped;
    must(awdMapDirection(field_, patches_[i], normal, drawn.direction, &mapped));
    float pdf;
    must(awdGetFieldPdf(field_, patches_[i], normal, drawn.direction, &pdf));
    EXPECT_EQ(mapped.pdf, pdf);
    EXPECT_EQ(mapped.component, AWD_INVALID_ID);
    EXPECT_TRUE(std::equal(mapped.direction, mapped.direction + 3, drawn.direction));
    // Near the horizon and the pole, floats tell squares and angles apart badly.
    const double cosTheta = cosine(drawn, normal);
    if (cosTheta < 0.1 || cosTheta > 0.995) continue;
    EXPECT_NEAR(mapped.square[0], drawn.square[0], 2e-5) << i;
    EXPECT_NEAR(mapped.square[1], drawn.square[1], 2e-5) << i;
    EXPECT_NEAR(mapped.solidAngle, drawn.solidAngle, 1e-4 * double(drawn.solidAngle)) << i;
  }
  const float up[3] = {0, 0, 1}, down[3] = {0, 0, -1};
  AWDDirectionSample below;
  must(awdMapDirection(field_, patches_[0], up, down, &below));
  EXPECT_EQ(below.pdf, 0.0f);
  EXPECT_EQ(below.solidAngle, 0.0f);
  EXPECT_EQ(awdRecordField(field_, patches_[0], &below, 1.0), AWD_ERROR_INVALID_ARGUMENT);
}

}  // namespace
