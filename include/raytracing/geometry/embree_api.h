#pragma once
// Wrappers for Embree 3 (Debian 12) and Embree 4 (Debian 13, Ubuntu 24.04). Only this file depends
// on the version: Embree 4 replaced the intersect context by optional query arguments.

#include <cstring>

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "raytracing/math/vec.h"

namespace raytracing::embree {

using Float4 [[gnu::vector_size(16)]] = float;

/// The first 32 bytes of a ray. They are written as two vectors because Embree reads them as two: a
/// load that spans several stores has to wait until all of these have reached the cache.
struct RayHead {
  Float4 origin_and_near, direction_and_time;
};

/// Makes a ray from `origin` to origin + far * direction.
inline RTCRay ray(const Vec3& origin, const Vec3& direction, float far) {
  RTCRay ray;
  const RayHead head{{origin.x, origin.y, origin.z, 0}, {direction.x, direction.y, direction.z, 0}};
  std::memcpy(&ray, &head, sizeof head);
  ray.tfar = far;
  ray.mask = ~0u;
  ray.id = 0;
  ray.flags = 0;
  return ray;
}

#if RTC_VERSION_MAJOR >= 4

inline void intersect1(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray, nullptr); }
inline void occluded1(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray, nullptr); }

inline void occluded8(const int* valid, RTCScene scene, RTCRay8& rays) {
  rtcOccluded8(valid, scene, &rays, nullptr);
}

inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8& rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &rays, &arguments);
}

#else

inline void intersect8(const int* valid, RTCScene scene, RTCRayHit8& rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, scene, &context, &rays);
}

inline void intersect1(RTCScene scene, RTCRayHit& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &ray);
}

inline void occluded1(RTCScene scene, RTCRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
}

inline void occluded8(const int* valid, RTCScene scene, RTCRay8& rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded8(valid, scene, &context, &rays);
}

#endif

}  // namespace raytracing::embree
