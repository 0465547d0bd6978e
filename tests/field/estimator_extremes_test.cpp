// SPDX-License-Identifier: Apache-2.0
// Under each estimator: bad settings, records that are none, data of no use, passes given up.
#include <algorithm>
#include <limits>

#include "field/estimators.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

using EstimatorExtremes = Estimators;
INSTANTIATE_TEST_SUITE_P(All, EstimatorExtremes, testing::ValuesIn(estimators()), nameOfEstimator);

/// A cancelled adapt leaves everything as it was, also what has been recorded.
TEST_P(EstimatorExtremes, CancelledAdaptsChangeNothing) {
  bool stop = true;
  AWDDeviceDesc deviceDesc = AWD_DEVICE_DESC_INIT;
  deviceDesc.threads = 2;
  deviceDesc.progress = [](void* user, const AWDProgress*) -> int32_t {
    return !*static_cast<bool*>(user);
  };
  deviceDesc.progressUser = &stop;
  const Device device = newDevice(&deviceDesc);
  const AWDFieldDesc with = desc("linear-bspline", 2, 3);
  const Field field = newField(device, &with);
  Random random(37);
  for (uint32_t patch = 0; patch < 8; ++patch) recordPass(field, patch, 1000, random, steps);
  expectFailure(awdAdaptField(field, nullptr), AWD_ERROR_CANCELLED, {});
  for (uint32_t patch = 0; patch < 8; ++patch) {
    const Coefficients as = coefficientsOf(field, patch);
    EXPECT_EQ(as.c, std::vector<double>(25, 1.0));
    EXPECT_EQ(as.samples, 1000u);
  }
  stop = false;
  EXPECT_EQ(adapt(field).samples, 8000u);
}

void expectSane(const Coefficients& density) {
  for (const double c : density.c) EXPECT_TRUE(std::isfinite(c) && c >= 0.0) << c;
  EXPECT_GT(*std::max_element(density.c.begin(), density.c.end()), 0.0);
}

/// Passes of no use, and of little: a density always, figures that say what came, and nothing
/// printed.
TEST_P(EstimatorExtremes, BadData) {
  testing::internal::CaptureStderr();
  struct Case {
    const char* what;
    size_t samples;
    double (*value)(double u, double v, size_t i);
    uint64_t rejected, kept;
  };
  const Case cases[] = {
      {"no samples", 0, [](double, double, size_t) { return 1.0; }, 0, 0},
      {"one sample", 1, [](double, double, size_t) { return 1.0; }, 0, 0},
      {"one sample of zero", 1, [](double, double, size_t) { return 0.0; }, 0, 1},
      {"zeros", 3000, [](double, double, size_t) { return 0.0; }, 0, 1},
      {"nonsense", 300, [](double, double, size_t) { return std::nan(""); }, 300, 1},
      {"some nonsense", 3000,
       [](double u, double v, size_t i) { return i % 3   ? steps(u, v)
                                                 : i % 2 ? -1.0
                                                         : HUGE_VAL; },
       1000, 0},
      {"one bright sample", 3000, [](double, double, size_t i) { return i == 7 ? 1.0 : 0.0; }, 0,
       0},
      {"half dark", 3000, [](double u, double, size_t) { return u < 0.5 ? 1.0 : 0.0; }, 0, 0},
      {"sixty decades", 3000, [](double u, double, size_t) { return u < 0.5 ? 1e-30 : 1e30; }, 0,
       0},
      {"huge", 3000, [](double u, double v, size_t) { return 1e300 * steps(u, v); }, 0, 0},
      {"as good as nothing", 3000, [](double, double, size_t) { return 5e-324; }, 0, 1},
  };
  for (const char* basis : {"haar", "linear-bspline", "m3"}) {
    for (const double tau : {0.0, kNoFloor}) {
      for (const double shrinkage : {0.0, -1.0}) {
        for (const Case& c : cases) {
          SCOPED_TRACE(std::string(basis) + ", " + c.what);
          AWDFieldDesc with = desc(basis, 3, 3, tau);
          with.shrinkage = shrinkage;
          begin(with);
          const std::vector<double> start = coefficientsOf(field_, kPatch).c;
          Random random(38);
          for (int pass = 0; pass < 2; ++pass) {  // the second one knows the magnitude
            size_t i = 0;
            record(c.samples, random, [&](double u, double v) { return c.value(u, v, i++); });
            const AWDFieldStatistics figures = adapt(field_);
            EXPECT_EQ(figures.samples, c.samples);
            EXPECT_EQ(figures.rejected, c.rejected);
            EXPECT_EQ(figures.refitFailed, 0u);
            const Coefficients density = coefficientsOf(field_, kPatch);
            expectSane(density);
            if (pass > 0) continue;
            EXPECT_EQ(figures.kept, c.kept);
            if (c.kept > 0 || c.samples == 0) {
              EXPECT_EQ(density.c, start);
            }
          }
        }
      }
    }
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

/// What is recorded must be what was drawn: these estimators go by place and pdf.
TEST_P(EstimatorExtremes, RecordsThatNobodyDrew) {
  begin(desc("haar", 2, 2));
  const float up[3] = {0, 0, 1};
  Random random(39);
  const AWDDirectionSample good = draw(field_, kPatch, up, random);
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {-0.01f, 1.01f, 1e30f, none}) {
    for (int axis = 0; axis < 2; ++axis) {
      AWDDirectionSample s = good;
      s.square[axis] = bad;
      expectFailure(awdRecordField(field_, kPatch, &s, 1.0), AWD_ERROR_INVALID_ARGUMENT,
                    {"square"});
    }
  }
  for (const float bad : {-1.0f, HUGE_VALF, none}) {
    AWDDirectionSample s = good;
    s.pdf = bad;
    expectFailure(awdRecordField(field_, kPatch, &s, 1.0), AWD_ERROR_INVALID_ARGUMENT, {"pdf"});
  }
  EXPECT_EQ(adapt(field_).samples, 0u);
  AWDDirectionSample s = good;
  s.pdf = 0.0f;  // what a tiny one is rounded to
  must(awdRecordField(field_, kPatch, &s, 1.0));
  s.square[0] = s.square[1] = 1.0f;
  must(awdRecordField(field_, kPatch, &s, 1.0));
  const AWDFieldStatistics figures = adapt(field_);
  EXPECT_EQ(figures.samples, 2u);
  EXPECT_EQ(figures.saturated, 2u);
  expectSane(coefficientsOf(field_, kPatch));
}

TEST(FieldEstimators, SettingsOutOfRange) {
  const Device device = newDevice(1u);
  AWDField field;
  for (const AWDEstimator bad : {-1, 7, 1000}) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.estimator = bad;
    expectFailure(awdNewField(device, &desc, &field), AWD_ERROR_INVALID_ARGUMENT,
                  {"estimator", std::to_string(bad)});
  }
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
    desc.estimator = AWD_ESTIMATOR_QUASI;
    desc.shrinkage = bad;
    expectFailure(awdNewField(device, &desc, &field), AWD_ERROR_INVALID_ARGUMENT, {"shrinkage"});
  }
}

#ifdef AWD_TEST_REFIT
TEST(FieldEstimators, UnknownSolversAreNamed) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.estimator = AWD_ESTIMATOR_REFIT;
  desc.refitSolver = "nonesuch";
  AWDField field;
  expectFailure(awdNewField(device, &desc, &field), AWD_ERROR_UNSUPPORTED,
                {"nonesuch", "ceres", "descent", "refit-1.so"});
}

/// 4098^2 coefficients with 15 products each.
TEST(FieldEstimators, RefitsTooLargeAreRefused) {
  const Device device = newDevice(1u);
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.basis = "quadratic-bspline";
  desc.estimator = AWD_ESTIMATOR_REFIT;
  desc.maxLevel = AWD_LEVEL(12);
  AWDField field;
  expectFailure(awdNewField(device, &desc, &field), AWD_ERROR_INVALID_ARGUMENT,
                {"desc->maxLevel is level 12", "bytes a patch"});
}
#endif

}  // namespace
