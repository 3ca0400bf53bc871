#include "raytracing/integrator/first_hit.h"

namespace raytracing {

FirstHit describe_first_hit(const Scene& scene, const Vertex& v, const Ray& ray) {
  const Rgb albedo = v.light != kNone ? Rgb(1.0f) : lobe_shape(*v.material).reflectance;
  return {DVec3(v.position) + DVec3(scene.origin()), v.shading.z, albedo,
          length(DVec3(v.position) - DVec3(ray.origin))};
}

}  // namespace raytracing
