// SPDX-License-Identifier: Apache-2.0
#include "scene_file.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace scenes {

namespace {

constexpr int kImageSize = 128;

Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

Vec normalised(Vec a) { return (1.0 / std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z)) * a; }

/// A number with that many digits; -0 and dust below 1e-12 are 0.
std::string text(double value, int digits) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, std::abs(value) < 1e-12 ? 0.0 : value);
  return buffer;
}

std::string text(Vec a, const char* separator, int digits) {
  return text(a.x, digits) + separator + text(a.y, digits) + separator + text(a.z, digits);
}

std::string header(const std::string& name) {
  return "# SPDX-License-Identifier: Apache-2.0\n# " + name +
         ", written by examples/scenes/make_scenes.cpp\n";
}

bool save(const std::filesystem::path& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  return static_cast<bool>(file.flush());
}

}  // namespace

void SceneFile::material(const std::string& name, Vec albedo, Vec radiance) {
  materials_.push_back({name, albedo, radiance});
}

void SceneFile::camera(Vec eye, Vec target, double tanHalfFov) {
  eye_ = eye;
  target_ = target;
  tanHalfFov_ = tanHalfFov;
}

void SceneFile::object(const std::string& name, const std::string& material) {
  objects_.push_back({name, material, {}});
}

void SceneFile::quad(Vec a, Vec b, Vec c, Vec d) { objects_.back().quads.push_back({a, b, c, d}); }

void SceneFile::block(Vec foot, Vec size, Turn turn) {
  const auto corner = [&](int x, int y, int z) {
    const double dx = (x - 0.5) * size.x, dz = (z - 0.5) * size.z;
    return foot + Vec{turn.cos * dx + turn.sin * dz, y * size.y, turn.cos * dz - turn.sin * dx};
  };
  quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1));
  quad(corner(1, 0, 0), corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0));
  quad(corner(1, 0, 1), corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1));
  quad(corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1), corner(0, 1, 0));
  quad(corner(0, 1, 1), corner(1, 1, 1), corner(1, 1, 0), corner(0, 1, 0));
  quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1));
}

void SceneFile::room(Vec lower, Vec upper) {
  const auto corner = [&](int x, int y, int z) {
    return Vec{x ? upper.x : lower.x, y ? upper.y : lower.y, z ? upper.z : lower.z};
  };
  quad(corner(0, 0, 1), corner(1, 0, 1), corner(1, 0, 0), corner(0, 0, 0));  // floor
  quad(corner(0, 1, 0), corner(1, 1, 0), corner(1, 1, 1), corner(0, 1, 1));  // ceiling
  quad(corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0), corner(0, 1, 0));  // far, -z
  quad(corner(1, 0, 1), corner(0, 0, 1), corner(0, 1, 1), corner(1, 1, 1));  // near, +z
  quad(corner(0, 0, 1), corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1));  // left, -x
  quad(corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 1), corner(1, 1, 0));  // right, +x
}

void SceneFile::panels(const Wall& wall,
                       const std::function<bool(std::size_t, std::size_t)>& hole) {
  const Vec normal = cross(wall.u, wall.v);
  const std::size_t columns = wall.uLines.size() - 1, rows = wall.vLines.size() - 1;
  // Neighbours differ, also across corners. A hole's edge goes down to the plane; the outer edge
  // needs no side, since panels of the next wall begin in front of it.
  const auto height = [&](std::size_t i, std::size_t j) {
    return hole && hole(i, j) ? 0.0 : 0.005 * static_cast<double>(1 + i % 2 + 2 * (j % 2));
  };
  const auto point = [&](std::size_t i, std::size_t j, double h) {
    return wall.corner + wall.uLines[i] * wall.u + wall.vLines[j] * wall.v + h * normal;
  };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      const double h = height(i, j);
      if (h > 0.0)
        quad(point(i, j, h), point(i + 1, j, h), point(i + 1, j + 1, h), point(i, j + 1, h));
      if (i + 1 < columns) {
        const double next = height(i + 1, j);
        if (next != h) {
          quad(point(i + 1, j, h), point(i + 1, j, next), point(i + 1, j + 1, next),
               point(i + 1, j + 1, h));
        }
      }
      if (j + 1 < rows) {
        const double next = height(i, j + 1);
        if (next != h) {
          quad(point(i, j + 1, next), point(i, j + 1, h), point(i + 1, j + 1, h),
               point(i + 1, j + 1, next));
        }
      }
    }
  }
}

std::string SceneFile::obj() const {
  std::string out = header(name_) + "mtllib scene.mtl\n";
  std::size_t vertex = 1;
  for (const Object& object : objects_) {
    out += "o " + object.name + "\nusemtl " + object.material + "\n";
    for (const auto& quad : object.quads) {
      for (const Vec& corner : quad) out += "v " + text(corner, " ", 7) + "\n";
      const auto index = [&](std::size_t i) { return " " + std::to_string(vertex + i); };
      out += "f" + index(0) + index(1) + index(2) + "\n";
      out += "f" + index(0) + index(2) + index(3) + "\n";
      vertex += 4;
    }
  }
  return out;
}

std::string SceneFile::mtl() const {
  std::string out = header(name_);
  for (const Material& material : materials_) {
    out += "newmtl " + material.name + "\nKd " + text(material.albedo, " ", 6) + "\nKe " +
           text(material.radiance, " ", 6) + "\nillum 1\n";
  }
  return out;
}

std::string SceneFile::cameraJson() const {
  const Vec look = normalised(target_ - eye_);
  const Vec right = normalised(cross(look, {0, 1, 0}));
  const auto vector = [](Vec a) { return "[" + text(a, ", ", 12) + "]"; };
  return "{\n  \"eye\": " + vector(eye_) + ",\n  \"look_dir\": " + vector(look) +
         ",\n  \"up\": " + vector(cross(right, look)) +
         ",\n  \"tan_half_fov_x\": " + text(tanHalfFov_, 12) +
         ",\n  \"width\": " + std::to_string(kImageSize) +
         ",\n  \"height\": " + std::to_string(kImageSize) + "\n}\n";
}

bool SceneFile::write(const std::string& folder) const {
  const std::filesystem::path path = std::filesystem::path(folder) / name_;
  std::error_code error;
  std::filesystem::create_directories(path, error);
  return !error && save(path / "scene.obj", obj()) && save(path / "scene.mtl", mtl()) &&
         save(path / "scene.camera.json", cameraJson());
}

std::vector<double> divide(double length, int count) {
  std::vector<double> lines;
  for (int i = 0; i <= count; ++i) lines.push_back(length * i / count);
  return lines;
}

}  // namespace scenes
