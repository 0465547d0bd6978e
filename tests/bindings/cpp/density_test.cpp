// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <random>

#include "bindings/cpp/mode.h"

namespace {

using namespace awdtest;

std::vector<double> randoms(size_t count) {
  std::mt19937_64 generator(7);
  std::vector<double> result(count);
  for (double& u : result) u = std::ldexp(static_cast<double>(generator() >> 11), -53);
  return result;
}

awd::Density newDensity(uint32_t dimensions,
                        AWDDensityStructure structure = AWD_STRUCTURE_DEFAULT) {
  awd::DensityDesc desc(dimensions);
  desc.structure = structure;
  return MUST(awd::Density::create(MUST(awd::Device::create()), desc));
}

/// Records x^2 at 1000 points of two dimensions, drawn from p.
void recordSquares(awd::Density& density) {
  std::vector<double> points(2000), pdfs(1000), values(1000);
  MUST(density.sample(randoms(2000), points, pdfs));
  for (size_t i = 0; i < 1000; ++i) values[i] = points[2 * i] * points[2 * i];
  MUST(density.record(points, pdfs, values));
}

TEST(Density, LearnsAndEstimates) {
  awd::Density density = newDensity(2);
  EXPECT_EQ(density.dimensions(), 2u);
  EXPECT_EQ(density.uniforms(), 2u);
  recordSquares(density);
  const AWDDensityReport report = MUST(density.adapt());
  EXPECT_EQ(report.samples, 1000u);
  const AWDDensityEstimate estimate = MUST(density.estimate());
  EXPECT_NEAR(estimate.integral, 1.0 / 3.0, 5.0 * estimate.standardError);

  const double low[] = {0.1, 0.5}, high[] = {0.9, 0.5};
  EXPECT_GT(MUST(density.pdf(high)), 2.0 * MUST(density.pdf(low)));
  std::array<double, 2> pdfs = {};
  const double both[] = {0.1, 0.5, 0.9, 0.5};
  MUST(density.pdf(both, pdfs));
  EXPECT_EQ(pdfs[1], MUST(density.pdf(high)));

  const double origin[] = {0.0, 0.0}, middle[] = {0.5, 1.0};
  EXPECT_NEAR(MUST(density.integral()), 1.0, 1e-12);
  EXPECT_LT(MUST(density.integral(origin, middle)), 0.4);
  EXPECT_EQ(MUST(density.info()).passes, 1u);
  EXPECT_EQ(MUST(density.axisInfo(1)).order, 2u);
}

TEST(Density, CoefficientsGoInAndOut) {
  awd::Density density = newDensity(2);
  std::vector<double> c = MUST(density.coefficients());
  EXPECT_EQ(c.size(), MUST(density.info()).coefficients);
  c[0] = 3.0;
  MUST(density.setCoefficients(c));
  const double before = MUST(density.coefficients())[0];
  EXPECT_GT(before, 2.0);
  MUST(density.refine());
  EXPECT_GT(MUST(density.coefficients()).size(), c.size());
}

TEST(Density, TreesHaveLeavesAndDetails) {
  awd::Density tree = newDensity(2, AWD_STRUCTURE_TREE);
  MUST(tree.refine(0));
  const std::vector<double> leaves = MUST(tree.leaves());
  EXPECT_EQ(leaves.size(), 4 * MUST(tree.info()).leaves);
  EXPECT_GE(leaves.size(), 8u);
  double sum = 0.0;
  for (const double energy : MUST(tree.detailEnergy())) sum += energy;
  EXPECT_NEAR(sum, 1.0, 1e-12);  // int of p^2, p = 1
}

TEST(Density, GoesOnElsewhere) {
  const awd::Device device = MUST(awd::Device::create());
  awd::Density density = newDensity(2);
  recordSquares(density);
  const std::vector<std::byte> saved = MUST(density.save());
  const std::vector<std::byte> statistics = MUST(density.exportStatistics());
  awd::Density loaded = MUST(awd::Density::load(device, saved));
  EXPECT_EQ(loaded.dimensions(), 2u);
  MUST(loaded.importStatistics(statistics));
  EXPECT_EQ(MUST(loaded.info()).samples, 1000u);
  MUST(loaded.addStatistics(statistics));
  EXPECT_EQ(MUST(loaded.info()).samples, 2000u);

  awd::Density fork = MUST(density.fork());
  recordSquares(fork);
  MUST(density.join(fork));
  EXPECT_EQ(MUST(density.info()).samples, 2000u);

  const std::vector<std::byte> half(saved.begin(), saved.begin() + 40);
  expectError([&] { return awd::Density::load(device, half); }, AWD_ERROR_IO, "awdLoadDensity");
}

TEST(Density, ComponentsAreTold) {
  awd::DensityDesc desc(1);
  desc.sampler = AWD_SAMPLER_COMPONENT;
  desc.estimator = AWD_ESTIMATOR_PAPER;
  awd::Density density = MUST(awd::Density::create(MUST(awd::Device::create()), desc));
  EXPECT_EQ(density.uniforms(), 2u);
  std::vector<double> points(4), pdfs(4);
  std::vector<uint32_t> components(4);
  MUST(density.sample(randoms(8), points, pdfs, components));
  for (const uint32_t component : components)
    EXPECT_LT(component, MUST(density.info()).coefficients);
  MUST(density.record(points, {}, points, components));
  EXPECT_EQ(MUST(density.info()).samples, 4u);
}

TEST(Density, ViewsMustFit) {
  awd::Density density = newDensity(3);
  std::vector<double> six(6), five(5), two(2), one(1);
  std::vector<uint32_t> components(3);
  const auto refused = [](auto&& call, const char* part) {
    expectError(call, AWD_ERROR_INVALID_ARGUMENT, part);
  };
  MUST(density.sample(six, six));
  refused([&] { return density.sample(six, five); }, "points has 5 elements");
  refused([&] { return density.sample(five, six); }, "uniforms has 5 elements");
  refused([&] { return density.sample(six, six, one); }, "pdfs has 1 elements");
  refused([&] { return density.sample(six, six, two, components); }, "components has 3");
  refused([&] { return density.pdf(five, one); }, "points has 5");
  refused([&] { return density.pdf(six, one); }, "pdfs has 1");
  refused([&] { return density.pdf(two); }, "point has 2");
  refused([&] { return density.record(five, {}, two); }, "points has 5");
  refused([&] { return density.record(six, {}, one); }, "values has 1");
  refused([&] { return density.record(six, one, two); }, "pdfs has 1");
  refused([&] { return density.record(six, two, two, components); }, "components has 3");
  refused([&] { return density.integral(two, two); }, "lower has 2");
  refused([&] { return awd::Density().pdf(two, one); }, "points has 2");
  EXPECT_EQ(MUST(density.info()).samples, 0u);
}

TEST(Density, AxesSayHowManyDimensions) {
  const AWDDensityAxis axes[] = {{"haar", AWD_LEVEL(1), 0}, {"quadratic-bspline", 0, 0}};
  awd::DensityDesc desc;
  desc.setAxes(axes);
  const awd::Density density = MUST(awd::Density::create(MUST(awd::Device::create()), desc));
  EXPECT_EQ(density.dimensions(), 2u);
  EXPECT_STREQ(MUST(density.axisInfo(1)).basis, "quadratic-bspline");
  const awd::Density copy = density, shared = awd::Density::share(density.get());
  EXPECT_EQ(copy.dimensions(), 2u);
  EXPECT_EQ(shared.uniforms(), 2u);
}

}  // namespace
