// SPDX-License-Identifier: Apache-2.0
// Paths: what the library makes of their vertices is what a host would by hand.
#include <algorithm>
#include <limits>

#include "field/saved.h"
#include "support/expect.h"
#include "support/statistics.h"

namespace {

using namespace awdtest;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kUp[3] = {0, 0, 1};

double luminance(const double c[3]) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; }

class Path : public testing::Test {
 protected:
  /// Three vertices, all of powers of two: sums and products are exact.
  std::vector<AWDPathVertex> path(AWDField field) {
    std::vector<AWDPathVertex> vertices(3);
    for (uint32_t i = 0; i < 3; ++i) {
      AWDPathVertex& v = vertices[i];
      v = {i, 1.0f, draw(field, i, kUp, random_), {}, {}, {}};
      v.sample.pdf = 0.25f;
      for (int k = 0; k < 3; ++k) {
        v.emitted[k] = i == 0 ? 8.0f : 0.5f;
        v.direct[k] = k == 0 ? 1.0f : 0.25f;
        v.scattering[k] = k == 2 ? 0.125f : 0.5f;
      }
    }
    vertices[1].continuation = 0.5f;
    return vertices;
  }
  static std::vector<float> record(AWDField field, const std::vector<AWDPathVertex>& vertices,
                                   const float* background = nullptr) {
    std::vector<float> radiance(3);
    must(awdRecordFieldPath(field, vertices.size(), vertices.data(), background, radiance.data()));
    return radiance;
  }

  Random random_{59};
  Device device_ = newDevice(1u);
};

TEST_F(Path, IsTheSumByHand) {
  const Field field = newField(device_), hand = newField(device_);
  const float background[3] = {2.0f, 4.0f, 16.0f};
  for (const bool leaves : {true, false}) {
    std::vector<AWDPathVertex> vertices = path(field);
    vertices[2].continuation = leaves ? 1.0f : 0.0f;
    double incoming[3], radiance[3] = {2.0, 4.0, 16.0};
    for (size_t i = 3; i-- > 0;) {
      const AWDPathVertex& v = vertices[i];
      double reflected[3];
      for (int k = 0; k < 3; ++k) {
        incoming[k] = radiance[k];
        reflected[k] = static_cast<double>(v.scattering[k]) * incoming[k];
        radiance[k] = static_cast<double>(v.emitted[k]) + static_cast<double>(v.direct[k]);
        if (v.continuation > 0.0f) {
          radiance[k] += reflected[k] / (0.25 * static_cast<double>(v.continuation));
        }
      }
      if (v.continuation > 0.0f)
        must(awdRecordField(hand, v.patch, &v.sample, luminance(reflected)));
    }
    const std::vector<float> seen = record(field, vertices, background);
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(static_cast<double>(seen[k]), radiance[k]) << leaves;
    EXPECT_TRUE(sameBytes(field, hand)) << leaves;
  }
  const AWDFieldStatistics figures = adapt(field);
  EXPECT_EQ(figures.samples, 5u) << "a vertex where the path ended records nothing";
  EXPECT_EQ(figures.rejected, 0u);
}

TEST_F(Path, MayPassMirrorsAndEndWithoutBackground) {
  const Field field = newField(device_);
  std::vector<AWDPathVertex> vertices = path(field);
  vertices[1].patch = AWD_INVALID_ID;
  vertices[1].sample.square[0] = kNaN;  // of no meaning there
  const std::vector<float> seen = record(field, vertices);
  // (0.5 + 1) / (0.25 * 0.5) * 0.5 + 1.5 = 7.5 leaves the mirror; 7.5 * 0.5 / 0.25 + 9 the first.
  EXPECT_EQ(seen[0], 24.0f);
  const AWDFieldStatistics figures = adapt(field);
  EXPECT_EQ(figures.samples, 2u);
  EXPECT_EQ(figures.rejected, 0u);
  EXPECT_EQ(figures.patches, 2u);

  const float background[3] = {1.0f, 2.0f, 3.0f};
  EXPECT_EQ(record(field, {}, background), (std::vector<float>{1.0f, 2.0f, 3.0f}));
  EXPECT_EQ(record(field, {}), (std::vector<float>{0.0f, 0.0f, 0.0f}));
  must(awdRecordFieldPath(field, 3, vertices.data(), nullptr, nullptr));
}

/// Of every estimator, with nothing but rejected samples at first and with a good pass after it.
TEST_F(Path, WhatMakesNoSenseIsRejectedAndCounted) {
  for (const FieldCase& c : fieldCases()) {
    if (c.spatial()) continue;
    SCOPED_TRACE(c.name);
    const Field field = newField(device_, &c.desc);
    uint64_t pdfs = 0, paths = 0;
    const auto spoil = [&](const auto& change) {
      std::vector<AWDPathVertex> vertices = path(field);
      vertices.pop_back();
      vertices.back().continuation = 0.0f;
      change(vertices[0], vertices[1]);
      const std::vector<float> seen = record(field, vertices);
      ++paths;
      return seen[0];
    };
    for (const float bad : {0.0f, -1.0f, kNaN, kInfinity}) {
      EXPECT_EQ(spoil([&](AWDPathVertex& v, AWDPathVertex&) { v.sample.pdf = bad; }), 9.0f);
      spoil([&](AWDPathVertex& v, AWDPathVertex&) { v.sample.solidAngle = bad; });
      pdfs += 2;
    }
    for (const float bad : {-0.1f, kNaN, 1.5f}) {
      spoil([&](AWDPathVertex& v, AWDPathVertex&) { v.sample.square[1] = bad; });
      ++pdfs;
    }
    EXPECT_EQ(spoil([](AWDPathVertex&, AWDPathVertex& end) { end.direct[1] = kNaN; }), 9.0f);
    spoil([](AWDPathVertex&, AWDPathVertex& end) { end.emitted[2] = kInfinity; });
    spoil([](AWDPathVertex& v, AWDPathVertex&) { v.scattering[0] = -kInfinity; });
    spoil([](AWDPathVertex& v, AWDPathVertex&) { v.scattering[1] = -50.0f; });
    const AWDFieldStatistics figures = adapt(field);
    EXPECT_EQ(figures.samples, paths);
    EXPECT_EQ(figures.rejected, paths);
    EXPECT_EQ(figures.rejectedPdf, pdfs);
    EXPECT_EQ(figures.rejectedNaN, 1u);
    EXPECT_EQ(figures.rejectedInfinite, 1u);
    EXPECT_EQ(figures.rejectedNegative, 2u);

    // One bad sample among good ones hardly matters.
    recordPass(field, 0, 3000, random_, [](double u, double v) { return 0.2 + u * v; });
    spoil([](AWDPathVertex& v, AWDPathVertex&) { v.sample.pdf = kNaN; });
    EXPECT_EQ(adapt(field).rejectedPdf, 1u);
    const Coefficients found = coefficientsOf(field, 0);
    for (const double x : found.c) EXPECT_TRUE(x >= 0.0 && x < 6.0) << x;
    EXPECT_GT(found.c.back(), found.c.front());
  }
}

TEST_F(Path, AVertexThatCanNotBeFailsTheCall) {
  const FieldCase spatial = fieldCases()[1];
  const Field field = trainedField(device_, spatial);
  const Bytes before = saved(field);
  const auto expectBad = [&](const char* part, const auto& change) {
    std::vector<AWDPathVertex> vertices = path(field);
    change(vertices[1]);
    expectFailure(awdRecordFieldPath(field, 3, vertices.data(), nullptr, nullptr),
                  AWD_ERROR_INVALID_ARGUMENT, {part, "item 1"});
    EXPECT_TRUE(saved(field) == before);
  };
  for (const float bad : {-0.5f, 1.5f, kNaN}) {
    expectBad("continuation", [&](AWDPathVertex& v) { v.continuation = bad; });
  }
  expectBad("patch", [](AWDPathVertex& v) { v.patch = 1u << 30; });
  expectFailure(awdRecordFieldPath(field, 1, nullptr, nullptr, nullptr), AWD_ERROR_INVALID_ARGUMENT,
                {"vertices"});

  AWDFieldDesc paper = AWD_FIELD_DESC_INIT;
  paper.preset = AWD_PRESET_PAPER;
  const Field byComponent = newField(device_, &paper);
  AWDPathVertex vertex = path(byComponent)[0];
  must(awdMapDirection(byComponent, 0, kUp, vertex.sample.direction, &vertex.sample));
  expectFailure(awdRecordFieldPath(byComponent, 1, &vertex, nullptr, nullptr),
                AWD_ERROR_INVALID_ARGUMENT, {"component", "item 0"});
}

/// A host draws half of its directions from a field that has learned something else, and half
/// uniformly from the hemisphere. Null hypothesis: with the mixture's pdf the coefficients are the
/// means of f over their cells; false-alarm rate 1 % over 16 cells. The scatter comes from 40
/// independent fields.
TEST_F(Path, OneSampleMixturesTeachTheSameFunction) {
  AWDFieldDesc desc = fieldDesc(AWD_MAP_CYLINDRICAL, 2, 2, -1.0);
  desc.basis = "haar";
  desc.estimator = AWD_ESTIMATOR_MIXTURE;
  const auto function = [](double u, double v) { return 4.0 * u * v; };
  constexpr size_t kFields = 40;
  std::vector<double> sum(16), squares(16);
  for (size_t run = 0; run < kFields; ++run) {
    const Field field = newField(device_, &desc);
    recordPass(field, 0, 2000, random_, [](double u, double v) { return 2.0 - u - v; });
    adapt(field);
    for (int i = 0; i < 4000; ++i) {
      AWDPathVertex v = {0, 1.0f, draw(field, 0, kUp, random_), {}, {}, {}};
      if (i % 2) {
        const double z = 1.0 - random_.uniform(), phi = 2.0 * kPi * random_.uniform();
        const double r = std::sqrt(1.0 - z * z);
        const Normal direction({r * std::cos(phi), r * std::sin(phi), z});
        must(awdMapDirection(field, 0, kUp, direction.values, &v.sample));
      }
      v.sample.pdf = 0.5f * v.sample.pdf + 0.5f * static_cast<float>(0.5 / kPi);
      const double f = function(v.sample.square[0], v.sample.square[1]);
      std::fill_n(v.scattering, 3,
                  static_cast<float>(f / static_cast<double>(v.sample.solidAngle)));
      const float background[3] = {1.0f, 1.0f, 1.0f};
      must(awdRecordFieldPath(field, 1, &v, background, nullptr));
    }
    adapt(field);
    const Coefficients found = coefficientsOf(field, 0);
    for (size_t i = 0; i < 16; ++i) {
      sum[i] += found.c[i] / kFields;
      squares[i] += found.c[i] * found.c[i] / kFields;
    }
  }
  std::vector<double> scores;
  for (size_t i = 0; i < 16; ++i) {
    const size_t row = i / 4, column = i % 4;
    const double u = (double(row) + 0.5) / 4.0, v = (double(column) + 0.5) / 4.0;
    const double error = std::sqrt((squares[i] - sum[i] * sum[i]) / (kFields - 1.0));
    scores.push_back((sum[i] - function(u, v)) / error);
    EXPECT_LT(error, 0.05 * function(u, v));
  }
  EXPECT_LT(largest(scores), familyThreshold(0.01, 16));
}

}  // namespace
