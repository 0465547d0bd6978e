// SPDX-License-Identifier: Apache-2.0
#include "radiosity.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "support/handles.h"
#include "support/random.h"
#include "support/vec.h"

namespace bench {
namespace {

using awdtest::must;
using awdtest::Vec3;

constexpr double kPi = 3.14159265358979323846;
/// Of the scene's size: above what rounding to floats moves a point by.
constexpr double kLift = 0x1p-20;

Vec3 vec(const std::array<float, 3>& v) { return {v[0], v[1], v[2]}; }
Vec3 vec(const float v[3]) { return {v[0], v[1], v[2]}; }

void store(Vec3 v, float values[3]) {
  values[0] = static_cast<float>(v.x);
  values[1] = static_cast<float>(v.y);
  values[2] = static_cast<float>(v.z);
}

struct Corners {
  Vec3 origin, edge1, edge2;
};

Corners cornersOf(const command::SceneData& data, uint32_t mesh, uint32_t triangle) {
  const command::Mesh& m = data.meshes[mesh];
  const auto& indices = m.triangles[triangle];
  const Vec3 origin = vec(m.vertices[indices[0]]);
  return {origin, vec(m.vertices[indices[1]]) - origin, vec(m.vertices[indices[2]]) - origin};
}

/// Row i of n has 2 (n - i) - 1 parts, upright and upside down in turns.
uint32_t partAt(uint32_t n, double u, double v) {
  const uint32_t i = std::min(static_cast<uint32_t>(u * n), n - 1);
  const uint32_t k = std::min(static_cast<uint32_t>(v * n), n - 1 - i);
  const bool flipped = (u * n - i) + (v * n - k) > 1.0 && k < n - 1 - i;
  return 2 * n * i - i * i + 2 * k + (flipped ? 1 : 0);
}

/// Barycentric coordinates of a point of a part.
std::array<double, 2> pointOf(uint32_t n, uint32_t part, double u, double v) {
  uint32_t i = 0;
  while (2 * n * (i + 1) - (i + 1) * (i + 1) <= part) ++i;
  const uint32_t within = part - (2 * n * i - i * i), k = within / 2;
  if (within % 2 != 0) return {(i + 1 - u) / n, (k + 1 - v) / n};
  return {(i + u) / n, (k + v) / n};
}

}  // namespace

Radiosity::Radiosity(AWDScene scene, const command::SceneData& data,
                     const RadiosityOptions& options)
    : scene_(scene), data_(data) {
  AWDSceneInfo info = AWD_SCENE_INFO_INIT;
  must(awdGetSceneInfo(scene, &info));
  const Vec3 size = vec(info.upper) - vec(info.lower);
  lift_ = kLift * std::max({size.x, size.y, size.z});
  cut(options.edge);
  countFactors(options.rays, options.seed);
  solve();
}

void Radiosity::cut(double edge) {
  for (uint32_t m = 0; m < data_.meshes.size(); ++m) {
    cuts_.emplace_back();
    firsts_.emplace_back();
    for (uint32_t t = 0; t < data_.meshes[m].triangles.size(); ++t) {
      const auto [origin, edge1, edge2] = cornersOf(data_, m, t);
      const double longest = std::max({length(edge1), length(edge2), length(edge2 - edge1)});
      const auto n = std::max(1u, static_cast<uint32_t>(std::ceil(longest / edge)));
      const double area = 0.5 * length(cross(edge1, edge2)) / (double{1} * n * n);
      cuts_[m].push_back(n);
      firsts_[m].push_back(elements_.size());
      for (const bool back : {false, true}) {
        for (uint32_t part = 0; part < n * n; ++part) {
          elements_.push_back({m, t, part, back, area});
        }
      }
    }
  }
}

AWDRay Radiosity::rayFrom(const Element& element, const std::array<double, 4>& uniforms) const {
  const auto [origin, edge1, edge2] = cornersOf(data_, element.mesh, element.triangle);
  const double root = std::sqrt(uniforms[0]);
  const auto [u, v] = pointOf(cuts_[element.mesh][element.triangle], element.part,
                              root * (1.0 - uniforms[1]), root * uniforms[1]);
  const double side = element.back ? -1.0 : 1.0;
  const Vec3 normal = side * normalise(cross(edge1, edge2));
  const awdtest::Frame frame(normal);
  const Vec3 direction =
      frame.direction(std::asin(std::sqrt(uniforms[2])), 2.0 * kPi * uniforms[3]);
  AWDRay ray = {};
  store(origin + u * edge1 + v * edge2 + lift_ * normal, ray.origin);
  store(direction, ray.direction);
  ray.tfar = std::numeric_limits<float>::infinity();
  return ray;
}

std::size_t Radiosity::elementAt(const AWDHit& hit, const float direction[3]) const {
  const uint32_t n = cuts_[hit.mesh][hit.triangle];
  const bool back = dot(vec(hit.normal), vec(direction)) > 0.0;
  return firsts_[hit.mesh][hit.triangle] + (back ? n * n : 0) + partAt(n, hit.u, hit.v);
}

void Radiosity::countFactors(uint32_t rays, uint64_t seed) {
  awdtest::Random random(seed);
  std::vector<AWDRay> batch(rays);
  std::vector<AWDHit> hits(rays);
  factors_.resize(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    if (!(elements_[e].area > 0.0)) continue;
    for (uint32_t r = 0; r < rays; ++r) {
      // Directions in strata of the angle from the normal.
      batch[r] = rayFrom(elements_[e], {random.uniform(), random.uniform(),
                                        (r + random.uniform()) / rays, random.uniform()});
    }
    must(awdIntersect(scene_, batch.data(), rays, hits.data()));
    std::map<std::size_t, uint32_t> counts;
    for (uint32_t r = 0; r < rays; ++r) {
      if (hits[r].mesh != AWD_INVALID_ID) ++counts[elementAt(hits[r], batch[r].direction)];
    }
    for (const auto& [element, count] : counts) {
      factors_[e].push_back({static_cast<uint32_t>(element), double{1} * count / rays});
    }
  }
}

void Radiosity::solve() {
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  const auto n = static_cast<Eigen::Index>(elements_.size());
  radiance_.resize(elements_.size());
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd emission(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Element& element = elements_[static_cast<std::size_t>(i)];
      const command::Material& material = data_.materials[data_.meshes[element.mesh].material];
      emission[i] = element.back ? 0.0 : material.emission[c];
      entries.emplace_back(i, i, 1.0);
      for (const Factor& factor : factors_[static_cast<std::size_t>(i)]) {
        entries.emplace_back(i, factor.element, -material.albedo[c] * factor.value);
      }
    }
    Matrix system(n, n);
    system.setFromTriplets(entries.begin(), entries.end());
    Eigen::BiCGSTAB<Matrix> solver;
    solver.setTolerance(1e-10);
    solver.compute(system);
    const Eigen::VectorXd solution = solver.solve(emission);
    if (solver.info() != Eigen::Success) throw std::runtime_error("radiosity: no solution");
    for (Eigen::Index i = 0; i < n; ++i) radiance_[static_cast<std::size_t>(i)][c] = solution[i];
  }
}

double Radiosity::rowSum(std::size_t element) const {
  double sum = 0.0;
  for (const Factor& factor : factors_[element]) sum += factor.value;
  return sum;
}

double Radiosity::formFactor(uint32_t from, uint32_t to) const {
  double sum = 0.0, area = 0.0;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    if (elements_[e].mesh != from || elements_[e].back) continue;
    area += elements_[e].area;
    for (const Factor& factor : factors_[e]) {
      if (elements_[factor.element].mesh == to) sum += elements_[e].area * factor.value;
    }
  }
  return sum / area;
}

command::RgbImage Radiosity::image(const AWDCamera& camera, uint32_t side) const {
  const Vec3 forward = normalise(vec(camera.lookDir));
  const Vec3 right = normalise(cross(forward, vec(camera.up)));
  const Vec3 up = double{1} * camera.height / camera.width * cross(right, forward);
  command::RgbImage image = {camera.width, camera.height, {}};
  image.values.resize(std::size_t{3} * camera.width * camera.height);
  std::vector<AWDRay> rays(std::size_t{side} * side);
  std::vector<AWDHit> hits(rays.size());
  for (uint32_t j = 0; j < camera.height; ++j) {
    for (uint32_t i = 0; i < camera.width; ++i) {
      for (uint32_t s = 0; s < rays.size(); ++s) {
        const double x = i + (s % side + 0.5) / side, y = j + (s / side + 0.5) / side;
        rays[s] = {};
        rays[s].tfar = std::numeric_limits<float>::infinity();
        store(vec(camera.eye), rays[s].origin);
        store(forward + camera.tanHalfFovX * ((2.0 * x / camera.width - 1.0) * right +
                                              (1.0 - 2.0 * y / camera.height) * up),
              rays[s].direction);
      }
      must(awdIntersect(scene_, rays.data(), rays.size(), hits.data()));
      for (std::size_t s = 0; s < rays.size(); ++s) {
        if (hits[s].mesh == AWD_INVALID_ID) continue;
        const auto& radiance = radiance_[elementAt(hits[s], rays[s].direction)];
        for (std::size_t c = 0; c < 3; ++c) {
          image.values[3 * (std::size_t{j} * camera.width + i) + c] +=
              static_cast<float>(radiance[c] / static_cast<double>(rays.size()));
        }
      }
    }
  }
  return image;
}

}  // namespace bench
