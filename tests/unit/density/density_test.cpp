// SPDX-License-Identifier: Apache-2.0
// Saved densities and statistics that were changed and then given a valid checksum: whatever they
// hold, a density of them is one, or there is none. (What densities do is tested from outside, in
// tests/density.)
#include "density/density.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "density/levels.h"
#include "density/plain_solver.h"
#include "util/error.h"

namespace awd {
namespace {

using Bytes = std::pmr::vector<char>;
constexpr std::size_t kHeader = 28;

const AWDBasisFamily& find(void*, const char* name) {
  for (const char* known : kShipped) {
    if (std::strcmp(known, name) == 0) return table(known);
  }
  fail(AWD_ERROR_UNSUPPORTED, "no such basis: %s", name);
}

const AWDRefitSolver& findSolver(void*, const char* name) {
  if (std::strcmp(kPlainSolver.name, name) == 0) return kPlainSolver;
  fail(AWD_ERROR_UNSUPPORTED, "no such solver: %s", name);
}

Ref<Context> newContext() {
  AWDDeviceDesc desc = AWD_DEVICE_DESC_INIT;
  desc.threads = 1;
  return Context::make(desc);
}

Ref<Density> newDensity(const std::vector<const char*>& bases, AWDDensityDesc desc) {
  std::vector<AWDDensityAxis> axes;
  std::vector<const AWDBasisFamily*> families;
  for (const char* name : bases) {
    axes.push_back({name, 0, 0});
    families.push_back(&table(name));
  }
  desc.dimensions = static_cast<uint32_t>(bases.size());
  desc.axes = axes.data();
  desc.maxCoefficients = 64;
  desc.passSamples = 20;
  DensitySettings settings = settle(desc, families.data());
  settings.learning.refitter.solver = &kPlainSolver;
  Ref<Context> context = newContext();
  Ref<DensityBases> compiled = compileBases(context->memory(), settings, families.data());
  return Density::make(std::move(context), std::move(compiled), settings);
}

void pass(Density& density, std::size_t count, Uniforms& random) {
  const uint32_t d = density.dimensions();
  std::vector<double> uniforms(count * density.uniforms()), points(count * d), pdfs(count),
      values(count);
  std::vector<uint32_t> components(count);
  for (double& u : uniforms) u = random();
  density.sample(count, uniforms.data(), points.data(), pdfs.data(), components.data());
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(pdfs[i] > 0.0 && std::isfinite(pdfs[i])) << pdfs[i];
    for (uint32_t a = 0; a < d; ++a) {
      ASSERT_TRUE(points[i * d + a] >= 0.0 && points[i * d + a] < 1.0) << points[i * d + a];
    }
    values[i] = 0.1 + points[i * d] * points[i * d];
  }
  density.record(count, points.data(), pdfs.data(), components.data(), values.data());
}

std::vector<Ref<Density>> someDensities() {
  std::vector<Ref<Density>> all;
  AWDDensityDesc desc = AWD_DENSITY_DESC_INIT;
  all.push_back(newDensity({"linear-bspline", "haar"}, desc));
  desc.combination = AWD_COMBINE_CROSS_VARIANCE;
  all.push_back(newDensity({"quadratic-bspline-periodic"}, desc));
  desc.estimator = AWD_ESTIMATOR_PAPER;
  all.push_back(newDensity({"m3"}, desc));
  desc = AWD_DENSITY_DESC_INIT;
  desc.structure = AWD_STRUCTURE_TREE;
  all.push_back(newDensity({"haar", "m2"}, desc));
  desc.combination = AWD_COMBINE_CROSS_VARIANCE;
  desc.target = AWD_TARGET_RMS;
  all.push_back(newDensity({"f2"}, desc));
  desc.estimator = AWD_ESTIMATOR_REFIT;
  all.push_back(newDensity({"m2", "haar"}, desc));
  desc.structure = AWD_STRUCTURE_GRID;
  all.push_back(newDensity({"linear-bspline", "quadratic-bspline"}, desc));
  Uniforms random(1);
  for (const Ref<Density>& density : all) {
    for (int k = 0; k < 2; ++k) {
      pass(*density, 60, random);
      density->adapt();
    }
    pass(*density, 30, random);
  }
  return all;
}

/// What a number could be changed to.
uint64_t oddNumber(Uniforms& random) {
  const double doubles[] = {0.0,    -1.0,   1.0,     std::nan(""), HUGE_VAL, -HUGE_VAL,
                            5e-324, 1e-308, 1.7e308, 1e30,         -1e300,   2.5};
  const uint64_t integers[] = {1,
                               2,
                               3,
                               20,
                               64,
                               1000,
                               UINT64_MAX,
                               UINT64_MAX / 2,
                               uint64_t{1} << 30,
                               uint64_t{1} << 31,
                               uint64_t{1} << 60};
  uint64_t bits;
  if (random() < 0.5) {
    std::memcpy(&bits, &doubles[static_cast<std::size_t>(random() * 12)], sizeof bits);
  } else {
    bits = integers[static_cast<std::size_t>(random() * 11)];
  }
  return bits;
}

/// The same kind of bytes with another content and a checksum that fits.
Bytes forged(const Bytes& bytes, Uniforms& random) {
  std::string content(bytes.begin() + kHeader, bytes.end());
  // Settings and topology are at the front: half of the changes go there.
  const auto place = [&](std::size_t size) {
    const double most =
        random() < 0.5 ? std::min(200.0, double(content.size())) : double(content.size());
    return static_cast<std::size_t>(random() * std::max(most - double(size), 0.0));
  };
  for (auto changes = static_cast<int>(1.0 + 3.0 * random()); changes > 0; --changes) {
    const double kind = random();
    if (kind < 0.3) {
      const std::size_t at = place(1);
      content[at] = static_cast<char>(content[at] ^ (1 << static_cast<int>(8.0 * random())));
    } else if (kind < 0.5) {
      content[place(1)] = static_cast<char>(static_cast<unsigned char>(256.0 * random()));
    } else if (kind < 0.9) {
      const uint64_t number = oddNumber(random);
      const std::size_t size = random() < 0.5 ? 4 : 8;
      content.replace(place(size), size, reinterpret_cast<const char*>(&number), size);
    } else if (kind < 0.95) {
      content.erase(place(8), 1 + static_cast<std::size_t>(8.0 * random()));
    } else {
      content.insert(place(1), 1 + static_cast<std::size_t>(8.0 * random()), '\1');
    }
  }
  ByteWriter writer(bytes.get_allocator().resource(), std::string_view(bytes.data(), 8), 1);
  for (const char c : content) writer.put(c);
  return writer.finish();
}

/// Draws, learns and saves as if nothing had been.
void use(Density& density, Uniforms& random) {
  const Estimate estimate = density.estimate();
  static_cast<void>(estimate);
  pass(density, 20, random);
  if (testing::Test::HasFatalFailure()) return;
  density.adapt();
  pass(density, 20, random);
  const Bytes bytes = density.bytesOf();
  EXPECT_GT(bytes.size(), kHeader);
}

TEST(Density, ForgedBytesMakeADensityOrNone) {
  Uniforms random(2);
  std::size_t refused = 0, taken = 0;
  for (const Ref<Density>& original : someDensities()) {
    const Bytes bytes = original->bytesOf();
    const Ref<Context> context = newContext();
    for (int i = 0; i < 200; ++i) {
      SCOPED_TRACE(i);
      const Bytes odd = forged(bytes, random);
      try {
        const Ref<Density> density =
            Density::load(context, odd.data(), odd.size(), {nullptr, find, findSolver});
        ++taken;
        use(*density, random);
      } catch (const Error& error) {
        EXPECT_TRUE(error.code() == AWD_ERROR_IO || error.code() == AWD_ERROR_UNSUPPORTED ||
                    error.code() == AWD_ERROR_INVALID_OPERATION)
            << error.what();
        ++refused;
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(refused, 300u);
  EXPECT_GT(taken, 150u) << "what no check can find is used";
}

TEST(Density, ForgedStatisticsMakeADensity) {
  Uniforms random(3);
  std::size_t refused = 0, taken = 0;
  for (const Ref<Density>& original : someDensities()) {
    const Bytes bytes = original->statisticsBytes();
    for (int i = 0; i < 200; ++i) {
      SCOPED_TRACE(i);
      const Bytes odd = forged(bytes, random);
      const Ref<Density> fork = Density::fork(*original);
      pass(*fork, 5, random);
      try {
        fork->takeStatistics(odd.data(), odd.size(), i % 2 == 0);
        ++taken;
        use(*fork, random);
      } catch (const Error& error) {
        EXPECT_TRUE(error.code() == AWD_ERROR_IO || error.code() == AWD_ERROR_INVALID_ARGUMENT ||
                    error.code() == AWD_ERROR_INVALID_OPERATION)
            << error.what();
        ++refused;
      }
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(refused, 100u);
  EXPECT_GT(taken, 200u);
}

}  // namespace
}  // namespace awd
