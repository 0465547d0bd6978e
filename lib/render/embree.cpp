// SPDX-License-Identifier: Apache-2.0
#include "render/embree.h"

#ifdef AWD_EMBREE4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <limits>
#include <numeric>

#include "util/error.h"

namespace awd {

namespace {

RTCRay makeRay(Vec3f o, Vec3f d, float tnear, float tfar) {
  RTCRay ray = {};
  ray.org_x = o.x;
  ray.org_y = o.y;
  ray.org_z = o.z;
  ray.tnear = tnear;
  ray.dir_x = d.x;
  ray.dir_y = d.y;
  ray.dir_z = d.z;
  ray.tfar = tfar;
  ray.mask = 0xFFFFFFFFu;
  return ray;
}

/// Distance from a point to a triangle (Ericson, Real-Time Collision Detection, section 5.1.5).
float distanceToTriangle(Vec3f p, const Vec3f* corner) {
  const Vec3f a = corner[0], b = corner[1], c = corner[2];
  const Vec3f ab = b - a, ac = c - a, ap = p - a;
  const float d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return length(ap);
  const Vec3f bp = p - b;
  const float d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return length(bp);
  const float vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return length(ap - ab * (d1 / (d1 - d3)));
  const Vec3f cp = p - c;
  const float d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return length(cp);
  const float vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return length(ap - ac * (d2 / (d2 - d6)));
  const float va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    return length(bp - (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))));
  }
  const float scale = 1.0f / (va + vb + vc);
  return length(ap - ab * (vb * scale) - ac * (vc * scale));
}

struct Nearest {
  const Embree* embree;
  Vec3f point;
  float distance;
  uint32_t triangle;
};

bool visitNearest(RTCPointQueryFunctionArguments* arguments) {
  auto& best = *static_cast<Nearest*>(arguments->userPtr);
  const float distance = distanceToTriangle(best.point, best.embree->corners(arguments->primID));
  // Of triangles at one distance the lowest number wins, whatever the order of traversal.
  if (distance < best.distance ||
      (distance == best.distance && arguments->primID < best.triangle)) {
    best.distance = distance;
    best.triangle = arguments->primID;
    arguments->query->radius = distance;
    return true;
  }
  return false;
}

bool reportProgress(void* progress, double fraction) {
  auto& known = *static_cast<Progress*>(progress);
  known.report(Embree::kProgressBegins + (1.0 - Embree::kProgressBegins) * fraction);
  return !known.cancelled();
}

}  // namespace

Embree::Embree(Context& context, std::pmr::vector<Vec3f> corners, Progress& progress)
    : corners_(std::move(corners)), indices_(context.memory()) {
  const std::size_t count = corners_.size();
  // Embree reads whole vectors of four floats: room behind the last vertex.
  corners_.resize(count + 2);
  indices_.resize(count);
  std::iota(indices_.begin(), indices_.end(), 0u);
  try {
    build(context, count, progress);
  } catch (...) {
    close();
    throw;
  }
}

void Embree::build(Context& context, std::size_t count, Progress& progress) {
  const auto check = [&] {
    const RTCError error = rtcGetDeviceError(device_);
    if (error == RTC_ERROR_NONE) return;
    progress.throwIfCancelled();
    if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
    fail(AWD_ERROR_UNKNOWN, "Embree failed with error %d", static_cast<int>(error));
  };
  device_ = rtcNewDevice(nullptr);
  if (!device_ && rtcGetDeviceError(nullptr) == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (!device_) fail(AWD_ERROR_UNKNOWN, "Embree can't be started on this machine");
  scene_ = rtcNewScene(device_);
  check();
  // Robust: no ray slips through the edge that two triangles share.
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneProgressMonitorFunction(scene_, reportProgress, &progress);
  if (count > 0) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               corners_.data(), 0, sizeof(Vec3f), count);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                               indices_.data(), 0, 3 * sizeof(uint32_t), count / 3);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    check();
  }
  context.parallel().within([&] { rtcCommitScene(scene_); });
  check();
  rtcSetSceneProgressMonitorFunction(scene_, nullptr, nullptr);
}

Embree::~Embree() { close(); }

void Embree::close() noexcept {
  if (scene_) rtcReleaseScene(scene_);
  if (device_) rtcReleaseDevice(device_);
  scene_ = nullptr;
  device_ = nullptr;
}

bool Embree::intersect(Vec3f origin, Vec3f direction, float tnear, float tfar, RayHit& hit) const {
  RTCRayHit query = {};
  query.ray = makeRay(origin, direction, tnear, tfar);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#ifdef AWD_EMBREE4
  rtcIntersect1(scene_, &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_, &context, &query);
#endif
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = {query.ray.tfar, query.hit.u, query.hit.v, query.hit.primID};
  return true;
}

bool Embree::occluded(Vec3f origin, Vec3f direction, float tnear, float tfar) const {
  RTCRay ray = makeRay(origin, direction, tnear, tfar);
#ifdef AWD_EMBREE4
  rtcOccluded1(scene_, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_, &context, &ray);
#endif
  return ray.tfar < 0.0f;
}

uint32_t Embree::nearest(Vec3f point) const {
  Nearest best = {this, point, std::numeric_limits<float>::infinity(), 0xFFFFFFFFu};
  RTCPointQuery query = {};
  query.x = point.x;
  query.y = point.y;
  query.z = point.z;
  query.radius = best.distance;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_, &query, &context, visitNearest, &best);
  return best.triangle;
}

}  // namespace awd
