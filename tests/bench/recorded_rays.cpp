#include "bench/recorded_rays.h"

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

namespace raytracing {
namespace {

constexpr std::size_t kPart = 4096;  // rays that a thread takes at once

std::unique_ptr<RecordedRays> recording;  // a seam of the linker has no object to hold it

void begin_query(RTCScene scene) {
  recording->scene = scene;
  if (recording->rays.size() - recording->parts.back() >= kPart)
    recording->parts.push_back(recording->rays.size());
}

void record(RTCScene scene, const RTCRay& r, RecordedRay::Kind kind) {
  if (!recording) return;
  begin_query(scene);
  recording->rays.push_back(
      {{r.org_x, r.org_y, r.org_z}, kind, {r.dir_x, r.dir_y, r.dir_z}, r.tfar});
}

void record(RTCScene scene, const RTCRay8& r, const int* valid, RecordedRay::Kind packet) {
  if (!recording) return;
  begin_query(scene);
  for (int k = 0; k < 8; ++k) {
    auto kind = k == 0 ? packet : RecordedRay::Kind::member;
    float far = r.tfar[k];
    if (valid[k] == 0) {
      if (k == 0)
        far = -1;
      else
        kind = RecordedRay::Kind::absent;
    }
    recording->rays.push_back(
        {{r.org_x[k], r.org_y[k], r.org_z[k]}, kind, {r.dir_x[k], r.dir_y[k], r.dir_z[k]}, far});
  }
}

// Returns which of them were asked.
std::array<int, 8> to_packet(const RecordedRay* ray, RTCRay8& packet) {
  std::array<int, 8> valid{};
  for (int k = 0; k < 8; ++k) {
    const RecordedRay& r = ray[k];
    valid[k] = r.kind == RecordedRay::Kind::absent || r.far < 0 ? 0 : -1;
    packet.org_x[k] = r.origin.x;
    packet.org_y[k] = r.origin.y;
    packet.org_z[k] = r.origin.z;
    packet.tnear[k] = 0;
    packet.dir_x[k] = r.direction.x;
    packet.dir_y[k] = r.direction.y;
    packet.dir_z[k] = r.direction.z;
    packet.time[k] = 0;
    packet.tfar[k] = r.far;
    packet.mask[k] = ~0u;
    packet.id[k] = 0;
    packet.flags[k] = 0;
  }
  return valid;
}

void ask_packet(RTCScene scene, const RecordedRay* ray) {
  RTCRayHit8 query;
  alignas(32) const std::array<int, 8> valid = to_packet(ray, query.ray);
  if (ray->kind == RecordedRay::Kind::shadow_packet) {
    embree::occluded8(valid.data(), scene, query.ray);
    return;
  }
  for (int k = 0; k < 8; ++k) {
    query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  embree::intersect8(valid.data(), scene, query);
}

void ask(RTCScene scene, const RecordedRay& r) {
  if (r.kind == RecordedRay::Kind::shadow) {
    RTCRay query = embree::ray(r.origin, r.direction, r.far);
    embree::occluded1(scene, query);
    return;
  }
  RTCRayHit query;
  query.ray = embree::ray(r.origin, r.direction, r.far);
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect1(scene, query);
}

// Pointers of the wrapped calls: the ray comes before Embree 4's arguments and after Embree 3's.
template <class Ray>
Ray& ray_of(void* second, void* third) {
  return *static_cast<Ray*>(RTC_VERSION_MAJOR >= 4 ? second : third);
}

}  // namespace

void start_recording() { recording = std::make_unique<RecordedRays>(); }

RecordedRays stop_recording() {
  RecordedRays result = std::move(*recording);
  recording.reset();
  result.parts.push_back(result.rays.size());
  return result;
}

double RecordedRays::replay(int threads) const {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
#if defined(__SSE__)
    _mm_setcsr(_mm_getcsr() | 0x8040);  // as in rendering
#endif
    for (std::size_t part = next++; part + 1 < parts.size(); part = next++)
      for (std::size_t i = parts[part]; i < parts[part + 1];) {
        const bool packet = rays[i].kind == RecordedRay::Kind::closest_packet ||
                            rays[i].kind == RecordedRay::Kind::shadow_packet;
        packet ? ask_packet(scene, &rays[i]) : ask(scene, rays[i]);
        i += packet ? 8 : 1;
      }
  };
  const auto start = std::chrono::steady_clock::now();
  {
    std::vector<std::jthread> workers;
    for (int i = 0; i < threads; ++i) workers.emplace_back(work);
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace raytracing

using raytracing::RecordedRay;

extern "C" {

void __real_rtcIntersect1(RTCScene scene, void* second, void* third);
void __real_rtcOccluded1(RTCScene scene, void* second, void* third);
void __real_rtcIntersect8(const int* valid, RTCScene scene, void* second, void* third);
void __real_rtcOccluded8(const int* valid, RTCScene scene, void* second, void* third);
void __wrap_rtcIntersect1(RTCScene scene, void* second, void* third);
void __wrap_rtcOccluded1(RTCScene scene, void* second, void* third);
void __wrap_rtcIntersect8(const int* valid, RTCScene scene, void* second, void* third);
void __wrap_rtcOccluded8(const int* valid, RTCScene scene, void* second, void* third);

void __wrap_rtcIntersect1(RTCScene scene, void* second, void* third) {
  const RTCRay& ray = raytracing::ray_of<RTCRayHit>(second, third).ray;
  raytracing::record(scene, ray, RecordedRay::Kind::closest);
  __real_rtcIntersect1(scene, second, third);
}

void __wrap_rtcOccluded1(RTCScene scene, void* second, void* third) {
  const RTCRay& ray = raytracing::ray_of<RTCRay>(second, third);
  raytracing::record(scene, ray, RecordedRay::Kind::shadow);
  __real_rtcOccluded1(scene, second, third);
}

void __wrap_rtcIntersect8(const int* valid, RTCScene scene, void* second, void* third) {
  raytracing::record(scene, raytracing::ray_of<RTCRayHit8>(second, third).ray, valid,
                     RecordedRay::Kind::closest_packet);
  __real_rtcIntersect8(valid, scene, second, third);
}

void __wrap_rtcOccluded8(const int* valid, RTCScene scene, void* second, void* third) {
  raytracing::record(scene, raytracing::ray_of<RTCRay8>(second, third), valid,
                     RecordedRay::Kind::shadow_packet);
  __real_rtcOccluded8(valid, scene, second, third);
}
}
