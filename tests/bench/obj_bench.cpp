// How fast OBJ text becomes a mesh, in bytes per second on one core.

#include <benchmark/benchmark.h>

#include "bench/hills.h"
#include "raytracing/io/obj.h"

namespace raytracing {
namespace {

// A million triangles with normals.
void parse_hills(benchmark::State& state) {
  const std::string text = hills_obj(707);
  std::size_t faces = 0;
  for (auto _ : state) {
    LoadReport report;
    faces = parse_obj(text, "hills.obj", report).mesh.faces.size();
    benchmark::DoNotOptimize(faces);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(text.size()));
  state.counters["triangles"] = static_cast<double>(faces);
}
BENCHMARK(parse_hills)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace raytracing
