#include "raytracing/geometry/embree_scene.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "raytracing/geometry/embree_api.h"

namespace raytracing {
namespace {

// Limits Embree to AVX2: it would choose AVX-512 where it can, which is slower on small scenes.
std::string device_options(int threads) {
  std::string options = "threads=" + std::to_string(threads);
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) options += ",isa=avx2";
#endif
  return options;
}

void keep_first_error(void* error, RTCError /*code*/, const char* message) {
  auto& text = *static_cast<std::string*>(error);
  if (text.empty()) text = std::string("Embree: ") + message;
}

const Sphere& sphere_of(void* spheres, unsigned index) {
  return static_cast<const Sphere*>(spheres)[index];
}

void sphere_bounds(const RTCBoundsFunctionArguments* args) {
  const Sphere& s = sphere_of(args->geometryUserPtr, args->primID);
  const float r = s.radius + position_error(s.max_coordinate());
  *args->bounds_o = {s.center.x - r, s.center.y - r, s.center.z - r, 0,
                     s.center.x + r, s.center.y + r, s.center.z + r, 0};
}

// Returns the first intersection in (tnear, tfar), or nothing.
std::optional<float> sphere_crossing(const Sphere& sphere, RTCRayN* rays, unsigned n, unsigned i) {
  const Ray ray{{RTCRayN_org_x(rays, n, i), RTCRayN_org_y(rays, n, i), RTCRayN_org_z(rays, n, i)},
                {RTCRayN_dir_x(rays, n, i), RTCRayN_dir_y(rays, n, i), RTCRayN_dir_z(rays, n, i)}};
  const auto crossings = intersect_line(sphere, ray);
  if (!crossings) return std::nullopt;
  const float near = RTCRayN_tnear(rays, n, i), far = RTCRayN_tfar(rays, n, i);
  for (float t : {crossings->first, crossings->second})
    if (t > near && t < far) return t;
  return std::nullopt;
}

void sphere_intersect(const RTCIntersectFunctionNArguments* args) {
  const Sphere& sphere = sphere_of(args->geometryUserPtr, args->primID);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  RTCHitN* hits = RTCRayHitN_HitN(args->rayhit, args->N);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const auto t = sphere_crossing(sphere, rays, args->N, i);
    if (!t) continue;
    RTCRayN_tfar(rays, args->N, i) = *t;
    RTCHitN_u(hits, args->N, i) = 0;
    RTCHitN_v(hits, args->N, i) = 0;
    RTCHitN_geomID(hits, args->N, i) = args->geomID;
    RTCHitN_primID(hits, args->N, i) = args->primID;
  }
}

void sphere_occluded(const RTCOccludedFunctionNArguments* args) {
  const Sphere& sphere = sphere_of(args->geometryUserPtr, args->primID);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0 || !sphere_crossing(sphere, args->ray, args->N, i)) continue;
    RTCRayN_tfar(args->ray, args->N, i) = -std::numeric_limits<float>::infinity();
  }
}

void set_ray(RTCRay8& rays, unsigned k, const Vec3& origin, const Vec3& direction, float far) {
  rays.org_x[k] = origin.x;
  rays.org_y[k] = origin.y;
  rays.org_z[k] = origin.z;
  rays.tnear[k] = 0;
  rays.dir_x[k] = direction.x;
  rays.dir_y[k] = direction.y;
  rays.dir_z[k] = direction.z;
  rays.time[k] = 0;
  rays.tfar[k] = far;
  rays.mask[k] = ~0u;
  rays.id[k] = k;
  rays.flags[k] = 0;
}

}  // namespace

const char* embree_version() { return "Embree " RTC_VERSION_STRING; }

void EmbreeScene::Release::operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }
void EmbreeScene::Release::operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }

EmbreeScene::EmbreeScene(std::vector<Vec3> positions, std::vector<Triangle> triangles,
                         std::vector<Sphere> spheres, int threads)
    : positions_(std::move(positions)),
      position_count_(positions_.size()),
      triangles_(std::move(triangles)),
      spheres_(std::move(spheres)) {
  positions_.emplace_back(0.0f);
  std::string error;
  device_.reset(rtcNewDevice(device_options(threads).c_str()));
  if (!device_) throw std::runtime_error("Embree: no device");
  rtcSetDeviceErrorFunction(device_.get(), keep_first_error, &error);
  scene_.reset(rtcNewScene(device_.get()));
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  if (!triangles_.empty()) add_triangles();
  if (!spheres_.empty()) add_spheres();
  rtcCommitScene(scene_.get());
  rtcSetDeviceErrorFunction(device_.get(), nullptr, nullptr);
  if (!error.empty()) throw std::runtime_error(error);
}

void EmbreeScene::add_triangles() {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             positions_.data(), 0, sizeof(Vec3), position_count_);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             triangles_.data(), 0, sizeof(Triangle), triangles_.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_.get(), geometry, kTriangles);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::add_spheres() {
  RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(spheres_.size()));
  rtcSetGeometryUserData(geometry, spheres_.data());
  rtcSetGeometryBoundsFunction(geometry, sphere_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, sphere_intersect);
  rtcSetGeometryOccludedFunction(geometry, sphere_occluded);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene_.get(), geometry, kSpheres);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::closest_hits8(std::span<const Ray> rays, std::optional<Hit>* hits) const {
  RTCRayHit8 query;
  alignas(32) int valid[8];
  for (unsigned k = 0; k < 8; ++k) {
    const Ray& ray = rays[k < rays.size() ? k : 0];
    valid[k] = k < rays.size() ? -1 : 0;
    set_ray(query.ray, k, ray.origin, ray.direction, std::numeric_limits<float>::infinity());
    query.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0][k] = RTC_INVALID_GEOMETRY_ID;
  }
  embree::intersect8(valid, scene_.get(), query);
  for (unsigned k = 0; k < rays.size(); ++k)
    hits[k] = found(query.hit.geomID[k], query.hit.primID[k], query.ray.tfar[k], query.hit.u[k],
                    query.hit.v[k]);
}

unsigned EmbreeScene::occluded8(const Vec3& from, const float* x, const float* y, const float* z,
                                unsigned wanted) const {
  RTCRay8 query;
  alignas(32) int valid[8];
  for (unsigned k = 0; k < 8; ++k) {
    valid[k] = (wanted >> k) & 1 ? -1 : 0;
    set_ray(query, k, from, Vec3(x[k], y[k], z[k]) - from, 1);
  }
  embree::occluded8(valid, scene_.get(), query);
  unsigned occluded = 0;
  for (unsigned k = 0; k < 8; ++k) occluded |= (query.tfar[k] < 0 ? 1u : 0u) << k;
  return occluded & wanted;
}

}  // namespace raytracing
