// SPDX-License-Identifier: Apache-2.0
// Details of nested families: their energy, and what is saved by dropping them.
#include <gtest/gtest.h>

#include <numeric>

#include "density/densities.h"

namespace awdtest {
namespace {

std::vector<double> energiesOf(AWDDensity density) {
  size_t count;
  must(awdGetDensityDetailEnergy(density, nullptr, 0, &count));
  std::vector<double> energies(count);
  must(awdGetDensityDetailEnergy(density, energies.data(), count, &count));
  return energies;
}

/// int p^2 by Gauss's rule of three points on n cells an axis; exact where p has degree up to 2 on
/// them.
double energyByQuadrature(AWDDensity density, uint32_t n) {
  const double points[3] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)};
  const double weights[3] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  std::vector<double> at, mass;
  for (uint32_t i = 0; i < 3 * n; ++i) {
    for (uint32_t k = 0; k < 3 * n; ++k) {
      at.push_back((i / 3 + points[i % 3]) / n);
      at.push_back((k / 3 + points[k % 3]) / n);
      mass.push_back(weights[i % 3] * weights[k % 3] / n / n);
    }
  }
  const std::vector<double> pdfs = pdfsAt(density, at);
  double sum = 0.0;
  for (size_t i = 0; i < pdfs.size(); ++i) sum += mass[i] * pdfs[i] * pdfs[i];
  return sum;
}

class Wavelets : public testing::TestWithParam<const char*> {
 protected:
  Device device = newDevice();
};
INSTANTIATE_TEST_SUITE_P(Families, Wavelets, testing::ValuesIn(kNested));

TEST_P(Wavelets, EnergiesSumToThatOfTheDensity) {
  Random random(1);
  for (const bool tree : {false, true}) {
    const Axes axes = {axisFrom(GetParam(), 3, 4), axisFrom(GetParam(), 2, 4)};
    const Density density = newDensity(device, axes, tree ? treeDesc() : gridDesc());
    setRandomCoefficients(density, random);
    const double want = energyByQuadrature(density, 16);
    const std::vector<double> energies = energiesOf(density);
    EXPECT_EQ(energies.size(), tree ? 6u : 4u);
    EXPECT_NEAR(std::accumulate(energies.begin(), energies.end(), 0.0), want, 1e-11 * want);
    for (const double energy : energies) EXPECT_GT(energy, 0.0);
    const std::vector<double> c = coefficientsOf(density, AWD_COEFFICIENTS_ORTHONORMAL);
    EXPECT_NEAR(std::inner_product(c.begin(), c.end(), c.begin(), 0.0), want, 1e-11 * want);
  }
}

TEST_P(Wavelets, RefiningAddsNoDetails) {
  Random random(2);
  const Density density =
      newDensity(device, {axisFrom(GetParam(), 1, 3), axisFrom(GetParam(), 1, 3)});
  setRandomCoefficients(density, random);
  const std::vector<double> before = energiesOf(density);
  must(awdRefineDensity(density, AWD_ALL_AXES));
  const std::vector<double> after = energiesOf(density);
  ASSERT_EQ(after.size(), before.size() + 1);
  for (size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 1e-12 * before[0]);
  EXPECT_NEAR(after.back(), 0.0, 1e-12 * before[0]);
}

TEST_P(Wavelets, OfAConstantNothingIsKeptButOneBox) {
  Random random(3);
  const Density density =
      newDensity(device, {axisFrom(GetParam(), 4, 5), axisFrom(GetParam(), 4, 5)}, treeDesc());
  const uint64_t before = infoOf(density).coefficients;
  const AWDDensityReport report = pass(density, 20000, random, [](const double*) { return 0.3; });
  EXPECT_EQ(infoOf(density).leaves, 1u);
  EXPECT_EQ(report.coarsened, before - infoOf(density).coefficients);
}

/// Coefficients dropped where f rises steadily, of 32 x 32 boxes.
uint64_t droppedOnARamp(AWDDevice device, const char* basis) {
  Random random(4);
  const Density density =
      newDensity(device, {axisFrom(basis, 5, 6), axisFrom(basis, 5, 6)}, treeDesc());
  return pass(density, 20000, random, [](const double* x) { return 0.2 + x[0] + 0.5 * x[1]; })
      .coarsened;
}

// The only difference between the two: flatlets have a second vanishing moment, so that a steady
// slope makes no details.
TEST(Flatlets, DropTheDetailsOfARampAndHaarDoesNot) {
  const Device device = newDevice();
  EXPECT_EQ(droppedOnARamp(device, "haar"), 0u);
  EXPECT_GT(droppedOnARamp(device, "f2"), 1000u);
}

TEST(Wavelets, SplinesHaveNone) {
  const Device device = newDevice();
  const Density density = newDensity(device, {fixedAxis("linear-bspline", 2)});
  size_t count;
  EXPECT_EQ(awdGetDensityDetailEnergy(density, nullptr, 0, &count), AWD_ERROR_UNSUPPORTED);
  double c[5];
  EXPECT_EQ(awdGetDensityCoefficients(density, AWD_COEFFICIENTS_ORTHONORMAL, c, 5),
            AWD_ERROR_UNSUPPORTED);
}

}  // namespace
}  // namespace awdtest
