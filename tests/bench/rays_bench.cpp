// Rays and segment queries from points all over a scene, in random order as after a bounce.

#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/integrator/ray_queries.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/lights/chord.h"
#include "raytracing/sampling/warp.h"
#include "raytracing/scene/description.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr std::size_t kVertices = 1 << 14;

struct Query {
  Vertex vertex;
  Vec3 wi;     // world, cosine-distributed
  Vec3 point;  // of the first light
  Chord chord;
};

struct Setting {
  std::unique_ptr<Scene> scene;
  std::vector<Query> queries;

  explicit Setting(const std::string& name) {
    LoadReport report;
    const std::string path = std::string(RAYTRACING_SOURCE_DIR) + "/scenes/" + name + ".toml";
    SceneFile file = load_scene_file(path, direct_method_names(), report);
    scene = std::make_unique<Scene>(std::move(file.scene), 1);
    const Camera camera(scene->camera(), 1, 1);
    TestRandom random(1);
    while (queries.size() < kVertices) {
      Ray ray = camera.ray(random.unit(), random.unit());
      // The second vertex of a path, where there is one, the others being too alike.
      for (int bounce = 0; bounce < 2; ++bounce) {
        const auto hit = scene->geometry().closest_hit(ray);
        if (!hit) break;
        const Vertex v = scene->vertex(ray, *hit);
        const Vec3 wi = v.shading.to_world(square_to_cosine_hemisphere(random.unit2()));
        ray = {v.ray_origin(), wi};
        if (bounce == 1) add(v, wi, random);
      }
    }
  }

  void add(const Vertex& v, const Vec3& wi, TestRandom& random) {
    const AreaLight& light = scene->lights()[0];
    const auto chord = sample_whole_chord(light, v.position, 0, random.unit());
    if (chord) queries.push_back({v, wi, sample_area(light, random.unit2()), chord->chord});
  }
};

// One of each scene, made when it is first asked for.
const Setting& setting(const std::string& name) {
  static const Setting cornell("cornell"), teapot("teapot_diffuse");
  return name == "cornell" ? cornell : teapot;
}

template <class F>
void ask(benchmark::State& state, const char* name, const F& question) {
  const Setting& s = setting(name);
  RayQueries visibility(*s.scene);
  const AreaLight& light = s.scene->lights()[0];
  std::size_t i = 0;
  for (auto _ : state) {
    const Query& q = s.queries[i++ % s.queries.size()];
    benchmark::DoNotOptimize(question(visibility, q, light));
  }
  state.SetItemsProcessed(state.iterations());
}

void closest_hit(benchmark::State& state, const char* name) {
  ask(state, name, [](RayQueries& visibility, const Query& q, const AreaLight&) {
    return visibility.closest_hit({q.vertex.ray_origin(), q.wi});
  });
}
BENCHMARK_CAPTURE(closest_hit, cornell, "cornell");
BENCHMARK_CAPTURE(closest_hit, teapot, "teapot");

void occlusion(benchmark::State& state, const char* name) {
  ask(state, name, [](RayQueries& visibility, const Query& q, const AreaLight& light) {
    return visibility.occluded(q.vertex, q.point, light);
  });
}
BENCHMARK_CAPTURE(occlusion, cornell, "cornell");
BENCHMARK_CAPTURE(occlusion, teapot, "teapot");

void segment(benchmark::State& state, const char* name) {
  ask(state, name, [](RayQueries& visibility, const Query& q, const AreaLight& light) {
    return visibility.visible_part(q.vertex, q.chord, Interval{0, 1}, light).length();
  });
}
BENCHMARK_CAPTURE(segment, cornell, "cornell");
BENCHMARK_CAPTURE(segment, teapot, "teapot");

}  // namespace
}  // namespace raytracing
