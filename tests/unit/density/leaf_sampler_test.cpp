// SPDX-License-Identifier: Apache-2.0
#include "density/leaf_sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "density/levels.h"
#include "density/tree_density.h"

namespace awd {
namespace {

constexpr double kEdges[] = {0.0, 0x1p-1074, 0x1p-53, 0.5, 1.0 - 0x1p-53};

/// Leaves of random coefficients, of several sizes, with zeros but none without mass.
struct Leaves {
  Leaves(const std::vector<const char*>& names, uint32_t splits, Uniforms& random)
      : tree(memory(), static_cast<uint32_t>(names.size())) {
    const auto d = static_cast<uint32_t>(names.size());
    for (const char* name : names) families.push_back(family(name, 0));
    for (uint32_t a = 0; a < d; ++a) levels[a] = &families[a].level(0);
    // One leaf is as small as they get, elsewhere than at 0.
    uint32_t node = 0;
    for (uint32_t i = 0; i < splits; ++i) {
      tree.split(node, i % d);
      node = tree.nodes()[node].child + (i < d || i % 7 == 0);
    }
    tree.finish();
    const std::size_t size = shapeOf(levels, d).size();
    coefficients.assign(tree.leaves() * size, 0.0);
    for (double& c : coefficients) c = random() < 0.3 ? 0.0 : std::pow(10.0, 4.0 * random());
    for (std::size_t i = 0; i < coefficients.size(); i += size) {
      coefficients[i + static_cast<std::size_t>(random() * double(size))] = 1.0;
    }
  }
  std::vector<Family> families;
  Tree tree;
  const BasisLevel* levels[kMaxDimensions] = {};
  Coefficients coefficients;
};

template <uint32_t D>
void compareWithAny(const std::vector<const char*>& names, Uniforms& random) {
  const Leaves leaves(names, 6 * D, random);
  const Shape shape = shapeOf(leaves.levels, D);
  const LeafSampler sampler(leaves.levels, shape);
  Coefficients marginals(leaves.tree.leaves() * sampler.marginalSize(), 0.0);
  for (uint32_t leaf = 0; leaf < leaves.tree.leaves(); ++leaf) {
    sampler.marginals(&leaves.coefficients[leaf * shape.size()],
                      marginals.data() + leaf * sampler.marginalSize());
  }
  const Coefficients masses(leaves.tree.nodes().size(), 1.0);
  const TreeDescent descent(leaves.tree, masses);
  const LeafSampler::Leaves from = {descent, leaves.coefficients.data(), marginals.data()};
  for (int round = 0; round < 20; ++round) {
    BlockDescent<kBlock> block;
    double points[kBlock * D], alone[D], any[D];
    for (std::size_t i = 0; i < kBlock; ++i) {
      block.leaf[i] = static_cast<uint32_t>(random() * leaves.tree.leaves());
      for (uint32_t a = 0; a < D; ++a) {
        block.u[a][i] = round < 2 ? kEdges[static_cast<std::size_t>(5.0 * random())] : random();
      }
    }
    sampler.sample(from, kBlock, block, points, nullptr);
    for (std::size_t i = 0; i < kBlock; ++i) {
      BlockDescent<1> one;
      double u[D];
      one.leaf[0] = block.leaf[i];
      for (uint32_t a = 0; a < D; ++a) one.u[a][0] = u[a] = block.u[a][i];
      sampler.sample(from, 1, one, alone, nullptr);
      sampler.sampleAny<D>(from, block.leaf[i], u, any);
      for (uint32_t a = 0; a < D; ++a) {
        ASSERT_EQ(points[i * D + a], any[a]) << names[0] << " axis " << a << " of " << D;
        ASSERT_EQ(alone[a], any[a]) << names[0] << " axis " << a << " of " << D;
      }
    }
  }
}

TEST(LeafSampler, BlocksGiveTheBitsOfTheGeneralWay) {
  Uniforms random(1);
  for (const char* name : kNested) {
    compareWithAny<1>(std::vector<const char*>(1, name), random);
    compareWithAny<2>({name, name}, random);
    compareWithAny<3>({name, name, name}, random);
    compareWithAny<4>({name, name, name, name}, random);
  }
  compareWithAny<2>({"f2", "haar"}, random);
  compareWithAny<2>({"m3", "f2"}, random);
}

/// A density in which each leaf may be drawn, to the smallest.
TEST(LeafSampler, ASampleTellsThePdfOfItsPointInAnyBatch) {
  constexpr std::size_t kSamples = 1000;
  Uniforms random(2);
  std::vector<std::vector<const char*>> products = {{"m2", "haar"}};
  for (const char* name : kNested) products.push_back({name, name});
  for (const auto& names : products) {
    // Coefficients that make up for the volumes, which go down to 2^-50.
    Leaves leaves(names, 50, random);
    const std::size_t size = leaves.coefficients.size() / leaves.tree.leaves();
    leaves.tree.walk([&](uint32_t i, const TreeBox& box) {
      const TreeNode& node = leaves.tree.nodes()[i];
      if (!node.leaf()) return;
      for (std::size_t j = 0; j < size; ++j) {
        leaves.coefficients[node.child * size + j] /= box.volume(2);
      }
    });
    const Ref<TreeDensity> density = TreeDensity::make(memory(), leaves.levels, leaves.tree,
                                                       leaves.coefficients, Scale::toIntegral);
    std::vector<double> u(2 * kSamples), points(u.size()), pdfs(kSamples), again(kSamples);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = i < 10 ? kEdges[i / 2] : random();
    density->sample(kSamples, u.data(), points.data(), pdfs.data(), nullptr);
    density->pdf(kSamples, points.data(), again.data());
    EXPECT_EQ(pdfs, again) << names[0];
    for (const double p : pdfs) ASSERT_TRUE(p > 0.0 && std::isfinite(p)) << names[0] << ": " << p;
    for (const double x : points) ASSERT_TRUE(x >= 0.0 && x < 1.0) << names[0] << ": " << x;
    for (const std::size_t batch : {1u, 31u, 64u}) {
      std::vector<double> places(u.size()), values(kSamples);
      std::vector<uint32_t> components(kSamples, 0);
      for (std::size_t done = 0; done < kSamples; done += batch) {
        density->sample(std::min(batch, kSamples - done), &u[2 * done], &places[2 * done],
                        &values[done], &components[done]);
      }
      EXPECT_EQ(places, points) << names[0] << " in batches of " << batch;
      EXPECT_EQ(values, pdfs) << names[0] << " in batches of " << batch;
      EXPECT_EQ(std::count(components.begin(), components.end(), AWD_INVALID_ID), kSamples);
    }
  }
}

}  // namespace
}  // namespace awd
