#pragma once
// The one place that knows which Embree this is: 3 (Debian 12) or 4 (Debian 13, Ubuntu 24.04).
// Embree 4 replaced the intersect context by optional query arguments; the rest used here is equal.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace raytracing::embree {

#if RTC_VERSION_MAJOR >= 4

inline void intersect1(RTCScene scene, RTCRayHit& ray) { rtcIntersect1(scene, &ray, nullptr); }
inline void occluded1(RTCScene scene, RTCRay& ray) { rtcOccluded1(scene, &ray, nullptr); }

inline void occluded8(const int* valid, RTCScene scene, RTCRay8& rays) {
  rtcOccluded8(valid, scene, &rays, nullptr);
}

#else

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
