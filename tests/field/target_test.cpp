// SPDX-License-Identifier: Apache-2.0
// What densities are made proportional to: the mean, or the root mean square, of what paths bring.
#include "field/learning.h"
#include "support/expect.h"

namespace {

using namespace awdtest;

struct Target {
  const char* name;
  AWDEstimator estimator;
  const char* basis;
};
void PrintTo(const Target& target, std::ostream* out) { *out << target.name; }

class FieldTarget : public testing::TestWithParam<Target> {
 protected:
  /// Over half of the square 1 comes each time, over the rest 10 one time of ten. Of `passes`, in
  /// this unit.
  double ratioOfHalves(AWDTarget target, double unit, int passes) {
    AWDFieldDesc desc = fieldDesc(AWD_MAP_DEFAULT, 2, 2, kNoFloor);
    desc.estimator = GetParam().estimator;
    desc.basis = GetParam().basis;
    desc.alpha = -1.0;
    desc.target = target;
    field_ = newField(device_, &desc);
    must(awdSetFieldScale(field_, unit));
    Random random(3);
    for (int pass = 0; pass < passes; ++pass) {
      recordPass(field_, kPatch, 40000, random, [&](double u, double) {
        if (u < 0.5) return unit;
        return random.uniform() < 0.1 ? 10.0 * unit : 0.0;
      });
      adapt(field_);
    }
    constexpr uint32_t kSide = 64;
    std::vector<float> image(kSide * kSide);
    must(awdGetPatchPdf(field_, kPatch, kSide, image.data(), 0));
    const auto average = [&](uint32_t from) {  // of a quarter of the columns
      double sum = 0.0;
      for (uint32_t i = 0; i < kSide * kSide / 4; ++i) {
        sum += static_cast<double>(image[i / (kSide / 4) * kSide + from + i % (kSide / 4)]);
      }
      return sum;
    };
    // Away from the step, which not all bases follow.
    return average(3 * kSide / 4) / average(0);
  }
  Device device_ = newDevice(1u);
  Field field_;
};

/// Null hypothesis: E[f] is 1 in both halves and sqrt(E[f^2]) is 1 and sqrt(10). 40,000 samples a
/// pass leave standard errors below 3 % in the ratio; 15 % are allowed.
TEST_P(FieldTarget, IsTheMeanOrItsRootMeanSquare) {
  EXPECT_NEAR(ratioOfHalves(AWD_TARGET_DEFAULT, 1.0, 1), 1.0, 0.15);
  EXPECT_NEAR(ratioOfHalves(AWD_TARGET_MEAN, 1.0, 2), 1.0, 0.15);
  for (const double unit : {1e-20, 1.0, 1e20}) {
    const int passes = unit == 1.0 ? 1 : 2;
    EXPECT_NEAR(ratioOfHalves(AWD_TARGET_RMS, unit, passes), std::sqrt(10.0),
                0.15 * std::sqrt(10.0));
    if (GetParam().estimator == AWD_ESTIMATOR_PAPER) continue;
    float mean = -1.0f;  // of what is recorded, in solid angle
    must(awdGetPatchMean(field_, kPatch, &mean));
    EXPECT_NEAR(static_cast<double>(mean) / unit, 1.0, 0.05) << "is still known";
  }
}

INSTANTIATE_TEST_SUITE_P(All, FieldTarget,
                         testing::Values(Target{"lumped", AWD_ESTIMATOR_LUMPED, "haar"},
                                         Target{"lumpedLinear", AWD_ESTIMATOR_LUMPED,
                                                "linear-bspline"},
                                         Target{"paper", AWD_ESTIMATOR_PAPER, "haar"},
                                         Target{"quasi", AWD_ESTIMATOR_QUASI, "linear-bspline"},
                                         Target{"mixture", AWD_ESTIMATOR_MIXTURE, "haar"},
                                         Target{"ratio", AWD_ESTIMATOR_RATIO, "haar"}),
                         [](const auto& c) { return std::string(c.param.name); });

TEST(FieldTargets, UnknownOnesAreRefused) {
  AWDFieldDesc desc = AWD_FIELD_DESC_INIT;
  desc.target = 3;
  Field field;
  expectFailure(awdNewField(newDevice(1u), &desc, field.out()), AWD_ERROR_INVALID_ARGUMENT,
                {"desc->target is 3"});
}

}  // namespace
