// SPDX-License-Identifier: Apache-2.0
// A scene as a host has it that traces paths itself: its own triangles and lights; rays are queries
// of the C interface.
#pragma once

#include <vector>

#include "render_shots.h"
#include "scene_data.h"
#include "support/vec.h"

namespace bench::host {

using Vec = awdtest::Vec3;

/// A point of a surface.
struct Place {
  Vec position, normal;  ///< the normal on the side of the ray
  Vec albedo;
  Vec emission;              ///< towards where the ray came from
  double emissionPdf = 0.0;  ///< with which shadow rays choose this point, by area; 0: never
};

/// A point of a light, with the pdf by area.
struct LightPoint {
  Vec position, normal, emission;
  double pdf;
};

class Scene {
 public:
  explicit Scene(const LoadedScene& loaded);

  /// Unit direction through (x, y) in pixels, y downwards.
  Vec lookThrough(double x, double y) const;
  Vec eye() const { return eye_; }
  /// False: nothing is there. Rays leave surfaces from `lifted` points.
  bool intersect(Vec origin, Vec direction, Place& place) const;
  /// Of both ends.
  bool isHidden(const Place& from, const LightPoint& light) const;
  Vec lifted(Vec position, Vec normal) const { return position + lift_ * normal; }

  bool hasLights() const { return !lights_.empty(); }
  /// A triangle by its power, and a point of it.
  LightPoint sampleLight(double choice, double u, double v) const;
  double brightest() const { return brightest_; }
  const AWDSceneInfo& info() const { return info_; }

 private:
  struct Light {
    Vec origin, edge1, edge2, normal, emission;
  };
  AWDScene scene_;
  command::SceneData data_;
  AWDSceneInfo info_ = AWD_SCENE_INFO_INIT;
  Vec eye_, forward_, right_, up_;
  double width_, height_;
  double lift_;
  std::vector<Light> lights_;
  std::vector<double> cumulative_;  ///< power of the lights up to each
  double brightest_ = 0.0;
};

double luminance(Vec color);
Vec operator*(Vec a, Vec b);
Vec toVec(const float values[3]);
void store(Vec v, float values[3]);

}  // namespace bench::host
