// Samplers, reflectances, solid angles and the closed form of a chord.

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "raytracing/lights/chord_integral.h"
#include "raytracing/materials/material.h"
#include "raytracing/sampling/sampler.h"
#include "raytracing/sampling/spherical.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr std::size_t kInputs = 1024;  // a power of two; they stay in the first cache

template <class F>
auto inputs(const F& make) {
  TestRandom random(1);
  std::vector<decltype(make(random))> all;
  for (std::size_t i = 0; i < kInputs; ++i) all.push_back(make(random));
  return all;
}

// All that one sample of a pixel draws for its first five vertices.
void sampler(benchmark::State& state, SamplerKind kind) {
  std::uint32_t i = 0;
  for (auto _ : state) {
    PathSampler sampler(kind, 0, i >> 4, 7, i & 15);
    benchmark::DoNotOptimize(sampler.pair(0));
    ++i;
  }
  state.SetItemsProcessed(state.iterations() * 16);
}
BENCHMARK_CAPTURE(sampler, sobol_pairs, SamplerKind::sobol);
BENCHMARK_CAPTURE(sampler, independent_pairs, SamplerKind::independent);

Vec3 upper(TestRandom& random) {
  const Vec3 w = random.direction();
  return {w.x, w.y, std::abs(w.z)};
}

void ggx_sample(benchmark::State& state) {
  struct Input {
    Vec3 wo;
    Vec2 u;
  };
  const Material material = GgxConductor{};
  const auto all = inputs([](TestRandom& r) { return Input{upper(r), r.unit2()}; });
  std::size_t i = 0;
  for (auto _ : state) {
    const Input& in = all[i++ % kInputs];
    benchmark::DoNotOptimize(sample_bsdf(material, in.wo, in.u));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ggx_sample);

void ggx_eval(benchmark::State& state) {
  const Material material = GgxConductor{};
  const auto all = inputs([](TestRandom& r) { return std::array{upper(r), upper(r)}; });
  std::size_t i = 0;
  for (auto _ : state) {
    const auto& [wo, wi] = all[i++ % kInputs];
    benchmark::DoNotOptimize(eval_cos(material, wo, wi));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ggx_eval);

void spherical_rectangle(benchmark::State& state) {
  struct Input {
    Vec3 from;
    Vec2 u;
  };
  const Rectangle rectangle{Vec3(0), {1, 0, 0}, {0, 1, 0}, 1.3f, 1.05f};
  const auto all = inputs([](TestRandom& r) {
    return Input{2.0f * r.in_cube(1.0f) + Vec3(0, 0, 3), r.unit2()};
  });
  std::size_t i = 0;
  for (auto _ : state) {
    const Input& in = all[i++ % kInputs];
    const SphericalRectangle seen(rectangle, in.from);
    benchmark::DoNotOptimize(seen.solid_angle());
    benchmark::DoNotOptimize(seen.sample(in.u));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(spherical_rectangle);

void chord_closed_form(benchmark::State& state) {
  const Vec3 normal(0, 0, 1);  // of the light; its chord runs along x
  const Chord chord{Vec3(0), {1, 0, 0}, 1.3f};
  const auto all = inputs([](TestRandom& r) { return 2.0f * r.in_cube(1.0f) + Vec3(0, 0, 3); });
  std::size_t i = 0;
  for (auto _ : state) {
    const SeenChord seen(chord, all[i++ % kInputs], normal);
    benchmark::DoNotOptimize(seen.irradiance(Vec3(0, 0, -1), Interval{0, 1}));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(chord_closed_form);

}  // namespace
}  // namespace raytracing
