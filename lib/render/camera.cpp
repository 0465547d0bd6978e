// SPDX-License-Identifier: Apache-2.0
#include "render/camera.h"

#include "util/error.h"

namespace awd {

namespace {

constexpr uint32_t kMostPixels = 65536;

Vec3d checked(const float v[3], const char* name) {
  const Vec3f vector = load(v);
  if (!isFinite(vector)) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "camera->%s is (%g, %g, %g): it must be finite", name,
         vector.x, vector.y, vector.z);
  }
  return convert<double>(vector);
}

}  // namespace

Camera::Camera(const AWDCamera& desc, const Geometry& geometry)
    : width_(desc.width), height_(desc.height) {
  if (width_ < 1 || width_ > kMostPixels || height_ < 1 || height_ > kMostPixels) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "camera is %u x %u pixels: 1 to %u a side are allowed", width_,
         height_, kMostPixels);
  }
  if (!(desc.tanHalfFovX > 0.0f && std::isfinite(desc.tanHalfFovX))) {
    fail(AWD_ERROR_INVALID_ARGUMENT, "camera->tanHalfFovX is %g: it must be positive and finite",
         desc.tanHalfFovX);
  }
  checked(desc.eye, "eye");
  eye_ = geometry.toFrame(load(desc.eye));
  if (!Embree::takes(eye_)) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "camera->eye is (%g, %g, %g): more than 1e18 times the size of the scene away from it",
         desc.eye[0], desc.eye[1], desc.eye[2]);
  }
  const Vec3d look = checked(desc.lookDir, "lookDir");
  const Vec3d up = checked(desc.up, "up");
  const Vec3d right = cross(look, up);
  if (!(length(right) > 1e-6 * length(look) * length(up))) {
    fail(AWD_ERROR_INVALID_ARGUMENT,
         "camera->lookDir (%g, %g, %g) and camera->up (%g, %g, %g) must neither be zero nor "
         "parallel",
         look.x, look.y, look.z, up.x, up.y, up.z);
  }
  const Vec3d forward = normalized(look);
  const Vec3d x = normalized(right) * static_cast<double>(desc.tanHalfFovX);
  const Vec3d y = cross(normalized(right), forward) *
                  (static_cast<double>(desc.tanHalfFovX) * height_ / width_);
  forward_ = forward;
  right_ = x * (2.0 / width_);
  down_ = y * (-2.0 / height_);
}

Vec3f Camera::direction(double x, double y) const {
  // From the middle on: of a corner first, nothing of `forward_` would be left in a wide view.
  return convert<float>(
      normalized(forward_ + right_ * (x - 0.5 * width_) + down_ * (y - 0.5 * height_)));
}

}  // namespace awd
