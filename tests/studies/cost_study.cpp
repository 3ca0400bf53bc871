// What the exact visibility of a chord costs, in shadow rays.

#include <optional>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/io/scene_file.h"
#include "raytracing/lights/chord.h"
#include "raytracing/render/threads.h"
#include "raytracing/scene/description.h"
#include "raytracing/study/metrics/statistics.h"
#include "studies/study.h"
#include "support/scenes.h"
#include "support/statistics.h"

namespace raytracing {
namespace {

constexpr int kReceivers = 512;
constexpr int kSamples = 16;  // of each receiver, one after the other, as in a render's pass
constexpr int kRepetitions = 11;

// One sample of a receiver: a point of the light and a full chord.
struct Question {
  Vertex vertex;
  const AreaLight* light;
  Vec3 point;
  Chord chord;
  Vec2 u;
};

std::optional<Question> ask(const Scene& scene, const Vertex& v, TestRandom& random) {
  const AreaLight& light = scene.lights()[scene.choose_light(random.unit()).index];
  const Vec2 u = random.unit2();
  const auto sample = sample_chord(light, v.position, random.unit() < 0.5f ? 0 : 1, u.x);
  const auto point = sample_solid_angle(light, v.position, u);
  if (!sample || !point || v.light != kNone) return std::nullopt;
  // Wholly above the horizon, so that the whole chord is asked for.
  for (const Vec3& corner : light.corners)
    if (dot(corner - v.position, v.ng) <= 0) return std::nullopt;
  return Question{v, &light, point->point, sample->chord, u};
}

// The samples of receivers where rays from `make_ray` arrive.
template <class F>
std::vector<Question> ask_all(const Scene& scene, TestRandom& random, const F& make_ray) {
  std::vector<Question> questions;
  while (questions.size() < kReceivers * kSamples) {
    const Ray ray = make_ray();
    const std::optional<Hit> hit = scene.geometry().closest_hit(ray);
    if (!hit) continue;
    const Vertex v = scene.vertex(ray, *hit);
    for (int i = 0; i < kSamples; ++i)
      if (const auto question = ask(scene, v, random)) questions.push_back(*question);
  }
  return questions;
}

// In random order, as after a bounce.
std::vector<Question> scattered(std::vector<Question> questions, TestRandom& random) {
  for (std::size_t i = questions.size(); i > 1; --i)
    std::swap(questions[i - 1], questions[random.bits() % i]);
  return questions;
}

struct Cost {
  double ray = 0, segment = 0;                      // seconds per query; medians
  double ratio = 0, ratio_low = 0, ratio_high = 0;  // of the queries: median and quartiles
  double scattered_ratio = 0;                       // of the queries in random order; median
  double estimate_ratio = 0;  // of whole estimates, line to solid-angle; median
  double lit = 0, dark = 0;   // shares of the chords
};

// Seconds per question of one block.
template <class F>
double time_block(const std::vector<Question>& questions, const F& query) {
  const double start = thread_cpu_seconds();
  for (const Question& q : questions) query(q);
  return (thread_cpu_seconds() - start) / static_cast<double>(questions.size());
}

Cost measure_cost(const Scene& scene, const std::vector<Question>& questions, TestRandom& random) {
  const std::vector<Question> mixed = scattered(questions, random);
  RayQueries visibility(scene);
  const PathSampler sampler(SamplerKind::sobol, 1, 0, 0, 0);
  const DirectMethod& points = direct_method("solid-angle");
  const DirectMethod& lines = direct_method("line");
  volatile float sink = 0;  // keeps the work from being left out
  const auto ray = [&](const Question& q) {
    sink = static_cast<float>(visibility.occluded(q.vertex, q.point, *q.light));
  };
  const auto segment = [&](const Question& q) {
    sink = static_cast<float>(
        visibility.visible_part(q.vertex, q.chord, Interval{0, 1}, *q.light).empty());
  };
  const auto estimate = [&](const DirectMethod& method) {
    return [&](const Question& q) {
      sink = estimate_direct(method, {q.vertex, *q.light, 1.0f, q.u, sampler, 1, 1}, visibility).x;
    };
  };
  Cost cost;
  std::vector<double> rays, segments, ratios, scattered_ratios, estimate_ratios;
  for (int i = -1; i < kRepetitions; ++i) {
    const double r = time_block(questions, ray), s = time_block(questions, segment);
    const double p = time_block(questions, estimate(points));
    const double l = time_block(questions, estimate(lines));
    const double mr = time_block(mixed, ray), ms = time_block(mixed, segment);
    if (i < 0) continue;  // the caches are warm now
    rays.push_back(r);
    segments.push_back(s);
    ratios.push_back(s / r);
    scattered_ratios.push_back(ms / mr);
    estimate_ratios.push_back(l / p);
  }
  for (const Question& q : questions) {
    float length = 0;
    const IntervalSet parts = visibility.visible_part(q.vertex, q.chord, Interval{0, 1}, *q.light);
    for (const Interval& part : parts.intervals()) length += part.length();
    cost.lit += (length > 0.9999f) / static_cast<double>(questions.size());
    cost.dark += (length == 0) / static_cast<double>(questions.size());
  }
  cost.ray = median(rays);
  cost.segment = median(segments);
  cost.ratio = median(ratios);
  cost.ratio_low = quantile(ratios, 0.25);
  cost.ratio_high = quantile(ratios, 0.75);
  cost.scattered_ratio = median(scattered_ratios);
  cost.estimate_ratio = median(estimate_ratios);
  return cost;
}

// Break-even: how many solid-angle points a line may cost, at N samples of a rectangular light in
// penumbra. Linear in between.
constexpr struct {
  double samples, points;
} kBreakEven[] = {{1, 1.6}, {4, 3.9}, {16, 13.5}, {64, 48}};

// From how many samples on the line wins at this cost.
std::string winning_samples(double cost) {
  if (cost <= kBreakEven[0].points) return "1";
  for (std::size_t i = 1; i < std::size(kBreakEven); ++i) {
    const auto [n0, p0] = kBreakEven[i - 1];
    const auto [n1, p1] = kBreakEven[i];
    if (cost > p1) continue;
    return fmt::format("{:.0f}", std::ceil(n0 + (n1 - n0) * (cost - p0) / (p1 - p0)));
  }
  return "more than 64";
}

void print_row(StudyReport& report, const std::string& name, const Cost& c) {
  report.print(
      "| {} | {:.0f} | {:.0f} | {:.1f} ({:.1f} ... {:.1f}) | {:.1f} | {:.1f} | "
      "{:.0f} / {:.0f} / {:.0f} | {} |\n",
      name, c.ray * 1e9, c.segment * 1e9, c.ratio, c.ratio_low, c.ratio_high, c.scattered_ratio,
      c.estimate_ratio, 100 * c.lit, 100 * (1 - c.lit - c.dark), 100 * c.dark,
      winning_samples(c.estimate_ratio));
}

void print_head(StudyReport& report, const char* first) {
  report.print(
      "| {} | ray, ns | segment, ns | segment / ray (quartiles) | the same, scattered | "
      "estimate, line / solid-angle | chords lit / partly / dark, % | line wins from N |\n"
      "|---|---|---|---|---|---|---|---|\n",
      first);
}

Cost scene_cost(const std::string& name) {
  LoadReport notes;
  SceneFile file = load_scene_file(fmt::format("{}/scenes/{}.toml", RAYTRACING_SOURCE_DIR, name),
                                   direct_method_names(), notes);
  const Scene scene(std::move(file.scene), 1);
  const Camera camera(scene.camera(), 1024, 1024);
  TestRandom random(3);
  const auto questions = ask_all(scene, random, [&] {
    const float x = random.between(0.0f, 1024.0f);
    return camera.ray(x, random.between(0.0f, 1024.0f));
  });
  return measure_cost(scene, questions, random);
}

// A wavy sheet of 2 k^2 triangles over [-size, size]^2 at height 1.5.
PolygonMesh wavy_sheet(std::uint32_t k, float size, std::uint32_t surface) {
  PolygonMesh mesh;
  for (std::uint32_t j = 0; j <= k; ++j)
    for (std::uint32_t i = 0; i <= k; ++i) {
      const float x = size * (2 * static_cast<float>(i) / static_cast<float>(k) - 1);
      const float y = size * (2 * static_cast<float>(j) / static_cast<float>(k) - 1);
      mesh.positions.emplace_back(x, y, 1.5f + 0.1f * std::sin(5 * x) * std::cos(4 * y));
    }
  for (std::uint32_t j = 0; j < k; ++j)
    for (std::uint32_t i = 0; i < k; ++i) {
      const std::uint32_t a = j * (k + 1) + i, b = a + 1, c = a + k + 1, d = c + 1;
      for (const auto& t : {std::array{a, b, d}, std::array{a, d, c}}) {
        mesh.faces.push_back({static_cast<std::uint32_t>(mesh.corners.size()), 3, surface});
        for (const std::uint32_t corner : t) mesh.corners.push_back({corner});
      }
    }
  return mesh;
}

Cost sheet_cost(std::uint32_t k) {
  SceneMaker maker;
  const auto grey = maker.add_surface(Diffuse{});
  const auto light = maker.add_surface(Diffuse{Rgb(0.0f)}, Rgb(1.0f));
  maker.add_polygon(parallelogram(Vec3(0.0f), Vec3(2.0f, 0.0f, 0.0f), Vec3(0.0f, 2.0f, 0.0f)),
                    grey);
  maker.add_polygon(
      parallelogram({0.0f, 0.0f, 3.0f}, Vec3(0.0f, 0.4f, 0.0f), Vec3(0.5f, 0.0f, 0.0f)), light);
  maker.description.meshes.push_back(wavy_sheet(k, 0.7f, grey));
  const Scene scene = maker.build();
  TestRandom random(4);
  const auto questions = ask_all(scene, random, [&] {
    const float x = random.between(-1.8f, 1.8f);
    return Ray{Vec3(x, random.between(-1.8f, 1.8f), 0.05f), Vec3(0.0f, 0.0f, -1.0f)};
  });
  return measure_cost(scene, questions, random);
}

void run(StudyReport& report) {
  report.print(
      "# Cost of a chord's exact visibility\n\n"
      "One segment query over a full random chord against one shadow ray to a random point of the "
      "light, from the same {} random visible points, {} each, in blocks by turns; medians of {} "
      "repetitions on one thread. Ratios are of neighbouring blocks. \"Scattered\": the queries in "
      "random order. \"Estimate\" is the whole direct-light estimate. "
      "The last column compares it to the break-even costs of a rectangular light in penumbra: "
      "1.6, 3.9, 13.5 and 48 points at 1, 4, 16 and 64 samples.\n\n",
      kReceivers, kSamples, kRepetitions);
  print_head(report, "scene");
  for (const char* name : {"cornell", "teapot_metal", "glossy"})
    print_row(report, name, scene_cost(name));
  report.print(
      "\n## Under a wavy sheet\n\nA sheet of more and more triangles hangs between the "
      "receivers and the light.\n\n");
  print_head(report, "triangles");
  std::vector<double> triangles, rays, segments;
  std::string csv = "triangles;ray;segment;ratio;estimate_ratio;scattered_ratio\n";
  for (const std::uint32_t k : {7u, 22u, 71u, 224u, 707u}) {
    const Cost c = sheet_cost(k);
    triangles.push_back(2.0 * k * k);
    rays.push_back(c.ray);
    segments.push_back(c.segment);
    print_row(report, std::to_string(2 * k * k), c);
    csv += fmt::format("{};{:.1f};{:.1f};{:.3f};{:.3f};{:.3f}\n", 2 * k * k, c.ray * 1e9,
                       c.segment * 1e9, c.ratio, c.estimate_ratio, c.scattered_ratio);
  }
  const PowerLaw ray_law = *fit_power_law(triangles, rays);
  const PowerLaw segment_law = *fit_power_law(triangles, segments);
  report.print(
      "\nTime grows with the triangles to the power {:.2f} ± {:.2f} (segment) and {:.2f} "
      "± {:.2f} (ray).\n",
      segment_law.slope, segment_law.slope_error, ray_law.slope, ray_law.slope_error);
  report.write_csv("sheet", csv);
  report.write_text();
}

}  // namespace
}  // namespace raytracing

int main(int argc, char** argv) {
  raytracing::StudyReport report(argc, argv, "cost");
  raytracing::run(report);
}
