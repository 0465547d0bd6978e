// SPDX-License-Identifier: Apache-2.0
// The pinhole camera of awd/render.h, in the normalised frame of a geometry.
#pragma once

#include "awd/render.h"
#include "render/geometry.h"
#include "util/vec.h"

namespace awd {

class Camera {
 public:
  /// Checks the description: finite, tanHalfFovX > 0, lookDir and up neither zero nor parallel,
  /// 1 to 65536 pixels a side.
  Camera(const AWDCamera& desc, const Geometry& geometry);

  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  Vec3f eye() const { return eye_; }
  /// Unit direction through the point (x, y) of the image, in pixels from the top left corner.
  Vec3f direction(double x, double y) const;

 private:
  uint32_t width_, height_;
  Vec3f eye_;
  Vec3d forward_, right_, down_;  ///< forward_ to the middle; right_ and down_ span one pixel
};

}  // namespace awd
