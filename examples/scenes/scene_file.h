// SPDX-License-Identifier: Apache-2.0
// A scene under construction: quads and boxes of named materials, a camera, and the three text
// files they become.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace scenes {

struct Vec {
  double x, y, z;
};
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }

/// The direction (cos, sin) of a rotation about the vertical, from a Pythagorean triple, so that
/// the files come out the same with every mathematics library.
struct Turn {
  double cos, sin;
};
constexpr Turn kNoTurn = {1.0, 0.0};

/// A rectangle to be panelled: corner, the directions of its sides (unit vectors), and the lines
/// that divide it along each. Its front is u x v.
struct Wall {
  Vec corner, u, v;
  std::vector<double> uLines, vLines;  ///< ascending, from 0
};

class SceneFile {
 public:
  explicit SceneFile(std::string name) : name_(std::move(name)) {}

  /// Diffuse; emits `radiance` on the front side.
  void material(const std::string& name, Vec albedo, Vec radiance = {0, 0, 0});
  void camera(Vec eye, Vec target, double tanHalfFov);

  /// Everything that follows belongs to this object and material.
  void object(const std::string& name, const std::string& material);
  /// Counter-clockwise seen from the front.
  void quad(Vec a, Vec b, Vec c, Vec d);
  /// A block of that size standing on `foot`, the middle of its bottom; faces look outward.
  void block(Vec foot, Vec size, Turn turn = kNoTurn);
  /// The six faces of a box, looking inward.
  void room(Vec lower, Vec upper);
  /// A wall of panels that stand out from its plane by 5, 10, 15 or 20 mm, so that no two panels
  /// that touch lie in one plane; joints between them are closed. `hole` tells which to leave out.
  void panels(const Wall& wall,
              const std::function<bool(std::size_t, std::size_t)>& hole = nullptr);

  /// Writes FOLDER/<name>/scene.obj, scene.mtl and scene.camera.json; whether that worked.
  bool write(const std::string& folder) const;

 private:
  struct Material {
    std::string name;
    Vec albedo, radiance;
  };
  struct Object {
    std::string name, material;
    std::vector<std::array<Vec, 4>> quads;
  };

  std::string obj() const;
  std::string mtl() const;
  std::string cameraJson() const;

  std::string name_;
  std::vector<Material> materials_;
  std::vector<Object> objects_;
  Vec eye_ = {0, 0, 0}, target_ = {0, 0, -1};
  double tanHalfFov_ = 0.5;
};

/// Lines that divide [0, length] into `count` equal parts.
std::vector<double> divide(double length, int count);

}  // namespace scenes
