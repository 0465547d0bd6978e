// SPDX-License-Identifier: Apache-2.0
// What the reference by radiosity must find where the answer is known.
#include <gtest/gtest.h>

#include <cmath>

#include "radiosity.h"
#include "support/handles.h"

namespace {

using awdtest::must;

using Corner = std::array<float, 3>;

command::Mesh quad(Corner a, Corner b, Corner c, Corner d) {
  command::Mesh mesh;
  mesh.vertices = {a, b, c, d};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Six walls whose fronts look inside, of 1 x 2 x 1.
command::SceneData box(float albedo, float emission) {
  command::SceneData data;
  command::Material material;
  material.albedo.fill(albedo);
  material.emission.fill(emission);
  data.materials = {material};
  data.meshes = {quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}),
                 quad({0, 2, 0}, {1, 2, 0}, {1, 2, 1}, {0, 2, 1}),
                 quad({0, 0, 0}, {0, 2, 0}, {0, 2, 1}, {0, 0, 1}),
                 quad({1, 0, 0}, {1, 0, 1}, {1, 2, 1}, {1, 2, 0}),
                 quad({0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}),
                 quad({0, 0, 1}, {0, 2, 1}, {1, 2, 1}, {1, 0, 1})};
  return data;
}

class Committed {
 public:
  explicit Committed(const command::SceneData& data) : device_(awdtest::newDevice(1u)) {
    must(awdNewScene(device_, scene_.out()));
    for (const command::Material& material : data.materials) {
      AWDMaterialDesc desc = AWD_MATERIAL_DESC_INIT;
      std::copy(material.albedo.begin(), material.albedo.end(), desc.albedo);
      std::copy(material.emission.begin(), material.emission.end(), desc.emission);
      must(awdAddMaterial(scene_, &desc, nullptr));
    }
    for (const command::Mesh& mesh : data.meshes) {
      AWDMeshDesc desc = AWD_MESH_DESC_INIT;
      desc.vertices = {mesh.vertices.data(), 0, 0, mesh.vertices.size(), AWD_FORMAT_FLOAT3, 0};
      desc.indices = {mesh.triangles.data(), 0, 0, mesh.triangles.size(), AWD_FORMAT_UINT3, 0};
      desc.material = mesh.material;
      must(awdAddMesh(scene_, &desc, nullptr));
    }
    must(awdCommitScene(scene_));
  }
  AWDScene scene() const { return scene_; }

 private:
  awdtest::Device device_;
  awdtest::Scene scene_;
};

/// radiance = e + albedo radiance, where all rows sum to 1.
TEST(Radiosity, OfAClosedFurnaceIsExact) {
  const command::SceneData data = box(0.75f, 0.5f);
  const Committed committed(data);
  bench::RadiosityOptions options;
  options.rays = 64;
  const bench::Radiosity radiosity(committed.scene(), data, options);
  std::size_t inside = 0;
  for (std::size_t e = 0; e < radiosity.elements(); ++e) {
    if (radiosity.rowSum(e) == 0.0) continue;  // the outer side
    ++inside;
    EXPECT_NEAR(radiosity.rowSum(e), 1.0, 1e-12) << e;
    for (const double value : radiosity.radiance(e)) EXPECT_NEAR(value, 0.5 / 0.25, 1e-8) << e;
  }
  EXPECT_EQ(inside, radiosity.elements() / 2);
}

/// Two squares at a distance of their side: the form factor is known in closed form.
TEST(Radiosity, FormFactorsOfFacingSquares) {
  command::SceneData data;
  data.materials.resize(1);
  data.meshes = {quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}),
                 quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1})};
  const Committed committed(data);
  bench::RadiosityOptions options;
  options.rays = 2048;
  const bench::Radiosity radiosity(committed.scene(), data, options);
  const double root = std::sqrt(2.0), pi = std::acos(-1.0);
  const double exact =
      2.0 / pi * (std::log(2.0 / std::sqrt(3.0)) + 2.0 * root * std::atan(1.0 / root) - pi / 2.0);
  // 72 elements or more of 2048 rays: a standard deviation below 0.0011.
  EXPECT_NEAR(radiosity.formFactor(0, 1), exact, 0.005);
  EXPECT_NEAR(radiosity.formFactor(1, 0), exact, 0.005);
  EXPECT_EQ(radiosity.formFactor(0, 0), 0.0);
}

/// One square lights the other, which reflects: the mean radiance follows from the form factor.
TEST(Radiosity, OneReflection) {
  command::SceneData data;
  data.materials.resize(2);
  data.materials[0].albedo.fill(0.8f);
  data.materials[1].emission.fill(10.0f);
  data.meshes = {quad({0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}),
                 quad({0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1})};
  data.meshes[1].material = 1;
  const Committed committed(data);
  const bench::Radiosity radiosity(committed.scene(), data, {});
  double sum = 0.0;
  std::size_t lit = 0;
  for (std::size_t e = 0; e < radiosity.elements(); ++e) {
    const double value = radiosity.radiance(e)[0];
    if (value > 0.0 && value < 9.0) sum += value, ++lit;
  }
  ASSERT_GT(lit, 0u);
  EXPECT_NEAR(sum / static_cast<double>(lit), 0.8 * 10.0 * radiosity.formFactor(0, 1), 1e-6);
}

}  // namespace
