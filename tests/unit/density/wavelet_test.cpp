// SPDX-License-Identifier: Apache-2.0
#include "density/wavelet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "basis/quadrature.h"
#include "density/axis.h"
#include "density/levels.h"
#include "util/error.h"

namespace awd {
namespace {

constexpr uint32_t kMost = 2 * AWD_BASIS_MAX_ORDER;

/// int_0^1 by Gauss's rule on `cells` cells.
template <class Function>
double integral(uint32_t cells, const Function& function) {
  const GaussRule gauss;
  double sum = 0.0;
  for (uint32_t c = 0; c < cells; ++c) {
    for (uint32_t g = 0; g < kMaxOrder; ++g) {
      sum += gauss.weights[g] / cells * function((c + gauss.points[g]) / cells);
    }
  }
  return sum;
}

/// sum c_j N_j(x), from the plugin.
double valueOf(const AWDBasisFamily& t, uint32_t level, const double* c, double x) {
  uint32_t first = 0;
  double values[AWD_BASIS_MAX_ORDER], sum = 0.0;
  const uint32_t alive = t.eval(level, x, &first, values);
  for (uint32_t a = 0; a < alive; ++a) sum += c[first + a] * values[a];
  return sum;
}

class EveryNested : public testing::TestWithParam<const char*> {
 protected:
  const AWDBasisFamily& table_ = table(GetParam());
  const Family family_ = family(GetParam(), 2);
  const WaveletFilter filter_{std::pmr::get_default_resource(), family_};
  const uint32_t n_ = filter_.size();
  const uint32_t cells_ = table_.cells(1);

  void fill(Uniforms& random, double* values, uint32_t size) const {
    for (uint32_t i = 0; i < size; ++i) values[i] = 2.0 * random() - 1.0;
  }
  double wavelet(uint32_t k, double x) const {
    double g[kMost];
    table_.wavelet(k, g);
    return valueOf(table_, 1, g, x);
  }
};

INSTANTIATE_TEST_SUITE_P(Families, EveryNested, testing::ValuesIn(kNested),
                         [](const auto& name) { return std::string(name.param); });

TEST_P(EveryNested, AnalysisIsProjectionAndIntegralsAgainstWavelets) {
  Uniforms random(1);
  for (int repetition = 0; repetition < 20; ++repetition) {
    double halves[kMost], coarse[kMost], detail[kMost];
    fill(random, halves, 2 * n_);
    filter_.analyse(halves, halves + n_, 1, coarse, detail);
    const auto f = [&](double x) { return valueOf(table_, 1, halves, x); };
    const auto rest = [&](double x) { return f(x) - valueOf(table_, 0, coarse, x); };
    for (uint32_t j = 0; j < n_; ++j) {
      double unit[kMost] = {};
      unit[j] = 1.0;
      const auto function = [&](double x) { return valueOf(table_, 0, unit, x); };
      EXPECT_NEAR(integral(cells_, [&](double x) { return rest(x) * function(x); }), 0.0, 1e-15);
      EXPECT_NEAR(integral(cells_, [&](double x) { return f(x) * wavelet(j, x); }), detail[j],
                  1e-14);
    }
    EXPECT_NEAR(integral(cells_, rest), 0.0, 1e-15) << "mass";
    EXPECT_NEAR(filter_.mergeError(halves, halves + n_, 1),
                integral(cells_, [&](double x) { return rest(x) * rest(x); }), 1e-14);
  }
}

TEST_P(EveryNested, SynthesisReconstructsPerfectly) {
  Uniforms random(2);
  for (int repetition = 0; repetition < 1000; ++repetition) {
    // Strided, in place, over 6 decades.
    double left[4 * kMost], right[4 * kMost], before[2][4 * kMost];
    for (uint32_t i = 0; i < 4 * kMost; ++i) {
      before[0][i] = left[i] = std::pow(10.0, 6.0 * random());
      before[1][i] = right[i] = std::pow(10.0, 6.0 * random());
    }
    filter_.analyse(left + 1, right + 1, 3, left + 1, right + 1);
    filter_.synthesise(left + 1, right + 1, 3, left + 1, right + 1);
    for (uint32_t i = 0; i < 4 * kMost; ++i) {
      const bool within = i % 3 == 1 && i / 3 < n_;
      EXPECT_NEAR(left[i], before[0][i], within ? 1e-13 * 1e6 : 0.0);
      EXPECT_NEAR(right[i], before[1][i], within ? 1e-13 * 1e6 : 0.0);
    }
  }
}

TEST_P(EveryNested, SplitIsTheSameFunction) {
  Uniforms random(3);
  double coarse[kMost], halves[kMost], again[kMost], detail[kMost];
  for (uint32_t i = 0; i < n_; ++i) coarse[i] = random();
  filter_.split(coarse, 1, halves, halves + n_);
  for (int i = 0; i <= 64; ++i) {
    EXPECT_NEAR(valueOf(table_, 0, coarse, i / 64.0), valueOf(table_, 1, halves, i / 64.0), 1e-15);
  }
  for (uint32_t i = 0; i < 2 * n_; ++i) EXPECT_GE(halves[i], 0.0);
  filter_.analyse(halves, halves + n_, 1, again, detail);
  for (uint32_t i = 0; i < n_; ++i) EXPECT_NEAR(again[i], coarse[i], 1e-15);
  EXPECT_NEAR(filter_.mergeError(halves, halves + n_, 1), 0.0, 1e-30);
}

TEST_P(EveryNested, EnergyOfDetailsIsThatOfTheirSynthesis) {
  Uniforms random(4);
  for (int repetition = 0; repetition < 20; ++repetition) {
    const double nothing[kMost] = {};
    double detail[kMost], halves[kMost], orthonormal[kMost];
    fill(random, detail, n_);
    filter_.synthesise(nothing, detail, 1, halves, halves + n_);
    const double energy =
        integral(cells_, [&](double x) { return std::pow(valueOf(table_, 1, halves, x), 2); });
    EXPECT_NEAR(filter_.detailEnergy(detail, 1), energy, 1e-13);
    filter_.toOrthonormalDetail(detail, 1, orthonormal);
    double sum = 0.0;
    for (uint32_t k = 0; k < n_; ++k) sum += orthonormal[k] * orthonormal[k];
    EXPECT_NEAR(sum, energy, 1e-13);
  }
}

TEST_P(EveryNested, OrthonormalCoefficientsKeepTheNorm) {
  Uniforms random(5);
  for (int repetition = 0; repetition < 20; ++repetition) {
    double c[kMost], o[kMost], back[kMost], squares = 0.0;
    fill(random, c, n_);
    filter_.toOrthonormal(c, 1, o);
    filter_.fromOrthonormal(o, 1, back);
    for (uint32_t i = 0; i < n_; ++i) {
      EXPECT_NEAR(back[i], c[i], 1e-14);
      squares += o[i] * o[i];
    }
    EXPECT_NEAR(squares,
                integral(cells_, [&](double x) { return std::pow(valueOf(table_, 0, c, x), 2); }),
                1e-14);
  }
}

TEST_P(EveryNested, WaveletsHaveTheMomentsTheyClaim) {
  EXPECT_EQ(family_.split().vanishingMoments, table_.vanishingMoments);
  bool more = true;  // whether one moment more vanishes for all of them
  for (uint32_t k = 0; k < n_; ++k) {
    for (uint32_t i = 0; i <= table_.vanishingMoments; ++i) {
      const double moment =
          integral(cells_, [&](double x) { return std::pow(x, i) * wavelet(k, x); });
      if (i < table_.vanishingMoments) {
        EXPECT_NEAR(moment, 0.0, 1e-15) << k << " " << i;
      } else {
        more = more && std::abs(moment) < 1e-10;
      }
    }
  }
  EXPECT_FALSE(more);
}

// Alpert's construction, section 1.1 of "A class of bases in L^2 for the sparse representation of
// integral operators" (1993), asks for k vanishing moments, and one more for each wavelet after
// the first: k + j moments of psi_j, which with their norm determines them up to the sign.
TEST(Multiwavelets, AreAlperts) {
  for (const char* name : {"m2", "m3"}) {
    const AWDBasisFamily& t = table(name);
    const uint32_t k = t.count(0);
    const auto wavelet = [&](uint32_t i, double x) {
      double g[kMost];
      t.wavelet(i, g);
      return valueOf(t, 1, g, x);
    };
    for (uint32_t i = 0; i < k; ++i) {
      for (uint32_t j = 0; j < k; ++j) {
        const double product = integral(2, [&](double x) { return wavelet(i, x) * wavelet(j, x); });
        EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 2e-15) << name << " " << i << " " << j;
      }
      uint32_t moments = 0;  // one that is 0 has them all
      while (moments < 2 * k + 2 && std::abs(integral(2, [&](double x) {
                                      return std::pow(x, moments) * wavelet(i, x);
                                    })) < 1e-14) {
        ++moments;
      }
      EXPECT_LT(moments, 2 * k + 2) << name << " wavelet " << i;
      EXPECT_GE(moments, k + i) << name << " wavelet " << i;
    }
  }
}

TEST(Multiwavelets, OrthonormalCoefficientsAreLegendres) {
  // sqrt(2i + 1) P_i(2x - 1) as Bernstein coefficients, i < k
  const double root3 = std::sqrt(3.0), root5 = std::sqrt(5.0);
  const std::vector<std::vector<double>> legendre2 = {{1, 1}, {-root3, root3}};
  const std::vector<std::vector<double>> legendre3 = {
      {1, 1, 1}, {-root3, 0, root3}, {root5, -2 * root5, root5}};
  for (const auto& [name, rows] : {std::pair{"m2", legendre2}, std::pair{"m3", legendre3}}) {
    const WaveletFilter filter(std::pmr::get_default_resource(), family(name));
    for (uint32_t i = 0; i < filter.size(); ++i) {
      double o[kMost];
      filter.toOrthonormal(rows[i].data(), 1, o);
      for (uint32_t k = 0; k < filter.size(); ++k) {
        EXPECT_NEAR(o[k], i == k ? 1.0 : 0.0, 2e-15) << name << " " << i << " " << k;
      }
    }
  }
}

TEST(Boxes, OrthonormalCoefficientsAreBoxesTimesARoot) {
  const double c[2] = {3.0, 5.0};
  double o[2];
  const WaveletFilter haar(std::pmr::get_default_resource(), family("haar"));
  haar.toOrthonormal(c, 1, o);
  EXPECT_EQ(o[0], 3.0);
  const WaveletFilter flatlets(std::pmr::get_default_resource(), family("f2"));
  flatlets.toOrthonormal(c, 1, o);
  EXPECT_NEAR(o[0], 3.0 / std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(o[1], 5.0 / std::sqrt(2.0), 1e-15);
}

TEST(Boxes, HaarIsExactSumAndDifference) {
  const WaveletFilter filter(std::pmr::get_default_resource(), family("haar"));
  const double left = 5.0, right = 2.0;
  double coarse, detail, l, r;
  filter.analyse(&left, &right, 1, &coarse, &detail);
  EXPECT_EQ(coarse, 3.5);
  EXPECT_EQ(detail, 1.5);
  EXPECT_EQ(filter.detailEnergy(&detail, 1), 2.25);
  EXPECT_EQ(filter.mergeError(&left, &right, 1), 2.25);
  filter.synthesise(&coarse, &detail, 1, &l, &r);
  EXPECT_EQ(l, left);
  EXPECT_EQ(r, right);
}

TEST(Boxes, FlatletsSeeNoDetailInAStraightLine) {
  const WaveletFilter filter(std::pmr::get_default_resource(), family("f2"));
  const double halves[4] = {1.0, 3.0, 5.0, 7.0};
  double coarse[2], detail[2], left[2], right[2];
  filter.analyse(halves, halves + 2, 1, coarse, detail);
  EXPECT_EQ(coarse[0], 2.0);
  EXPECT_EQ(coarse[1], 6.0);
  EXPECT_EQ(detail[0], 0.0);
  EXPECT_EQ(detail[1], 0.0);
  EXPECT_EQ(filter.detailEnergy(detail, 1), 0.0);
  EXPECT_EQ(filter.mergeError(halves, halves + 2, 1), 1.0) << "and yet merging loses it";
  filter.synthesise(coarse, detail, 1, left, right);
  EXPECT_NEAR(left[0], 1.0, 1e-15);
  EXPECT_NEAR(right[1], 7.0, 1e-15);
}

TEST(Wavelets, TheLibraryFindsThoseThatAPluginDoesNotGive) {
  for (const char* name : kNested) {
    AWDBasisFamily without = table(name);
    without.wavelet = nullptr;
    without.vanishingMoments = 0;
    const Family compiled(std::pmr::get_default_resource(), without, 0);
    EXPECT_EQ(compiled.split().vanishingMoments, 1u);
    const WaveletFilter filter(std::pmr::get_default_resource(), compiled);
    Uniforms random(6);
    double halves[kMost], coarse[kMost], detail[kMost];
    for (uint32_t i = 0; i < 2 * filter.size(); ++i) halves[i] = random();
    filter.analyse(halves, halves + filter.size(), 1, coarse, detail);
    double energy = 0.0;
    for (uint32_t k = 0; k < filter.size(); ++k) energy += detail[k] * detail[k];
    // Orthonormal, and orthogonal to the cell's functions.
    EXPECT_NEAR(filter.detailEnergy(detail, 1), energy, 1e-14) << name;
    EXPECT_NEAR(filter.mergeError(halves, halves + filter.size(), 1), energy, 1e-14) << name;
  }
}

TEST(Wavelets, OfAFamilyThatDoesNotNestAreRefused) {
  try {
    const WaveletFilter filter(std::pmr::get_default_resource(), family("linear-bspline"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), AWD_ERROR_UNSUPPORTED);
    EXPECT_NE(std::string(error.what()).find("\"linear-bspline\" has no wavelets"),
              std::string::npos);
  }
}

TEST(Wavelets, ThatDetermineNothingAreRefused) {
  AWDBasisFamily lying = table("f2");
  lying.wavelet = [](uint32_t, double* g) {
    g[0] = g[3] = 1.0;
    g[1] = g[2] = -1.0;
  };
  const Family compiled(std::pmr::get_default_resource(), lying, 1);
  EXPECT_THROW(WaveletFilter(std::pmr::get_default_resource(), compiled), Error);
}

}  // namespace
}  // namespace awd
