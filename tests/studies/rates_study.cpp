// How fast the error of direct light falls with the number of samples, at single receivers.

#include <array>
#include <functional>

#include "raytracing/math/numeric.h"
#include "raytracing/study/metrics/statistics.h"
#include "studies/study.h"
#include "support/direct_light.h"

namespace raytracing {
namespace {

constexpr int kVariations = 16;      // of each case: the light and the shadow edge moved a little
constexpr int kRandomisations = 16;  // of each variation
constexpr int kLargestLog = 10;      // of the number of samples
constexpr int kFirstLog = 2;
constexpr int kFirstFittedLog = 4;

// What theory expects of the exponents; for points, of stratified ones. A shadow edge that runs
// along an axis of the sample's square is a jump in one number alone: -2 where it else is -1.5.
struct Expected {
  double points, line, line_direction0, line_direction1;
};

struct Case {
  std::string name, file;
  Expected expected;
  std::function<DirectCase(TestRandom&)> make;
};

// A light of 1 x 0.7 at height 1; its chords of direction 0 run along x.
std::vector<Vec3> ceiling_light(TestRandom& random) {
  const Vec3 center(random.between(-0.2f, 0.2f), random.between(-0.2f, 0.2f), 1.0f);
  return parallelogram(center, Vec3(0.5f, 0.0f, 0.0f), Vec3(0.0f, 0.35f, 0.0f));
}

// A big square at height 0.5. Its edge, at `angle` to the x axis, throws its shadow near the
// middle of the light.
DirectCase penumbra(TestRandom& random, float angle) {
  DirectCase c;
  c.light = ceiling_light(random);
  const Vec3 middle = 0.25f * (c.light[0] + c.light[2]);
  const Vec3 along(std::cos(angle), std::sin(angle), 0.0f);
  const Vec3 across(-along.y, along.x, 0.0f);
  const float size = 4;
  const float offset = random.between(-0.06f, 0.06f);
  c.occluder = parallelogram(middle + (size + offset) * across, size * along, size * across);
  return c;
}

std::vector<Case> cases() {
  return {
      {"penumbra, edge oblique",
       "oblique",
       {-1.5, -3, -3, -3},
       [](TestRandom& r) { return penumbra(r, r.between(0.4f, 0.7f)); }},
      {"penumbra, edge across the chords of direction 0",
       "across",
       {-2, -2, -3, -2},
       [](TestRandom& r) { return penumbra(r, kPi / 2); }},
      {"penumbra, edge along the chords of direction 0",
       "along",
       {-2, -2, -2, -3},
       [](TestRandom& r) { return penumbra(r, 0.0f); }},
      {"fully lit",
       "lit",
       {-2, -3, -3, -3},
       [](TestRandom& r) {
         return DirectCase{"", ceiling_light(r), {}};
       }},
      {"near the light, at 0.1 of its length",
       "near",
       {-2, -3, -3, -3},
       [](TestRandom& r) {
         const Vec3 center(r.between(-0.4f, 0.4f), r.between(-0.3f, 0.3f), 0.1f);
         return DirectCase{
             "", parallelogram(center, Vec3(0.5f, 0.0f, 0.0f), Vec3(0.0f, 0.35f, 0.0f)), {}};
       }},
      {"grazing: upright light, 3 to 9 degrees above the horizon",
       "grazing",
       {-2, -3, -3, -3},
       [](TestRandom& r) {
         const Vec3 center(2.0f, r.between(-0.4f, 0.4f), r.between(0.2f, 0.22f));
         return DirectCase{
             "", parallelogram(center, Vec3(0.0f, 0.5f, 0.0f), Vec3(0.0f, 0.0f, 0.1f)), {}};
       }},
  };
}

constexpr std::uint32_t kPair = 1;  // the pair of the first vertex

// A method with its sampler.
struct Variant {
  std::string name;
  const char* method;
  SamplerKind kind = SamplerKind::sobol;
  double (*expected)(const Expected&);
  // Only pixels where the method line takes chords of this direction.
  std::optional<int> direction = {};
};

std::vector<Variant> variants() {
  const auto points = [](const Expected& e) { return e.points; };
  const auto random = [](const Expected&) { return -1.0; };
  const auto sobol = SamplerKind::sobol;
  return {
      {"point, independent", "point", SamplerKind::independent, random},
      {"point", "point", sobol, points},
      {"solid-angle", "solid-angle", sobol, points},
      // Its points along the chord are stratified among themselves only.
      {"line-rays", "line-rays", sobol, random},
      {"line", "line", sobol, [](const Expected& e) { return e.line; }},
      {"line, direction 0 only", "line", sobol, [](const Expected& e) { return e.line_direction0; },
       0},
      {"line, direction 1 only", "line", sobol, [](const Expected& e) { return e.line_direction1; },
       1},
  };
}

using Errors = std::array<double, kLargestLog + 1>;  // by the logarithm of the number of samples

// The pixel whose numbers are randomisation `i` of the variant.
std::uint32_t pixel_of(const Variant& variant, std::uint32_t i) {
  std::uint32_t x = 64 * i;
  const auto direction = [&] {
    return PathSampler(variant.kind, 7, x, 0, 0).coin_of_pixel(kPair) ? 1 : 0;
  };
  while (variant.direction && direction() != *variant.direction) ++x;
  return x;
}

// Adds the squared relative errors of the means of the first 1, 2, 4, ... samples.
void add_errors(const DirectScene& scene, double truth, const Variant& variant, std::uint32_t x,
                Errors& errors) {
  const DirectMethod& method = direct_method(variant.method);
  const AreaLight& light = scene.scene().lights()[0];
  RayQueries visibility(scene.scene());
  double sum = 0;
  int log = 0;
  for (int i = 1; i <= 1 << kLargestLog; ++i) {
    PathSampler sampler(variant.kind, 7, x, 0, static_cast<std::uint64_t>(i - 1));
    const DirectQuery query{scene.vertex(), light, 1.0f, sampler.pair(kPair), sampler, kPair, 4};
    sum += estimate_direct(method, query, visibility).x;
    if (i != 1 << log) continue;
    const double error = sum / i / truth - 1;
    errors[log++] += error * error / (kVariations * kRandomisations);
  }
}

std::vector<Errors> measure_case(const Case& c, std::span<const Variant> all) {
  std::vector<Errors> errors(all.size(), Errors{});
  TestRandom random(5);
  for (int variation = 0; variation < kVariations; ++variation) {
    const DirectScene scene(c.make(random), Diffuse{Rgb(0.5f)});
    const double truth = scene.lambert_radiance();
    for (std::size_t k = 0; k < all.size(); ++k)
      for (int r = 0; r < kRandomisations; ++r)
        add_errors(scene, truth, all[k],
                   pixel_of(all[k], static_cast<std::uint32_t>(variation * kRandomisations + r)),
                   errors[k]);
  }
  return errors;
}

PowerLaw fit(const Errors& errors) {
  std::vector<double> n, e;
  for (int log = kFirstFittedLog; log <= kLargestLog; ++log) {
    n.push_back(1 << log);
    e.push_back(errors[log]);
  }
  return *fit_power_law(n, e);
}

std::string csv(std::span<const Variant> all, std::span<const Errors> errors) {
  std::string text = "N";
  for (const Variant& v : all) text += ";" + v.name;
  for (int log = kFirstLog; log <= kLargestLog; ++log) {
    text += fmt::format("\n{}", 1 << log);
    for (const Errors& e : errors) text += fmt::format(";{:.4e}", e[log]);
  }
  return text + "\n";
}

void run(StudyReport& report) {
  report.print(
      "# Convergence at single receivers\n\n"
      "A diffuse receiver, a rectangular light, direct light only. relMSE: mean squared error of "
      "N samples over the square of the exact radiance (closed form), over {} places of light and "
      "edge with {} randomisations each. Exponent: least squares over N = {} ... {}, with its "
      "standard error. Sampler: sobol, unless another is named. Theory is asymptotic, and "
      "for points that are stratified only: scrambled Sobol' points may do better where the "
      "integrand is smooth. A star marks exponents more than 0.15 from theory.\n\n",
      kVariations, kRandomisations, 1 << kFirstFittedLog, 1 << kLargestLog);
  const std::vector<Variant> all = variants();
  for (const Case& c : cases()) {
    const std::vector<Errors> errors = measure_case(c, all);
    report.print("## {}\n\n", c.name);
    report.print("| method | relMSE, N = 16 | relMSE, N = 256 | exponent | theory | |\n");
    report.print("|---|---|---|---|---|---|\n");
    for (std::size_t k = 0; k < all.size(); ++k) {
      const PowerLaw law = fit(errors[k]);
      const double theory = all[k].expected(c.expected);
      report.print("| {} | {:.2e} | {:.2e} | {:.2f} ± {:.2f} | {:.1f} | {} |\n", all[k].name,
                   errors[k][4], errors[k][8], law.slope, law.slope_error, theory,
                   std::abs(law.slope - theory) > 0.15 ? "*" : "");
    }
    report.print("\n");
    report.write_csv(c.file, csv(all, errors));
  }
  report.write_text();
}

}  // namespace
}  // namespace raytracing

int main(int argc, char** argv) {
  raytracing::StudyReport report(argc, argv, "rates");
  raytracing::run(report);
}
