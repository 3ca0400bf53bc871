// The bias of line-ratio, known exactly.

#include <gtest/gtest.h>

#include "support/direct_light.h"
#include "support/p_values.h"

namespace raytracing {
namespace {

/// The visible share of a chord. The dark part of the light is convex, so that it takes one piece.
double visible_fraction(const DVec3& begin, const DVec3& along, const LPolygon& dark) {
  if (dark.empty()) return 1;
  long double first = 0, last = 1;
  for (std::size_t i = 0; i < dark.size(); ++i) {
    const LVec3 n = inward(dark, i);
    const long double at = dot(LVec3(begin) - dark[i], n), slope = dot(LVec3(along), n);
    if (slope == 0) {
      if (at < 0) return 1;
    } else if (slope > 0) {
      first = std::max(first, -at / slope);
    } else {
      last = std::min(last, -at / slope);
    }
  }
  return 1 - static_cast<double>(std::max(0.0L, last - first));
}

/// What no shadow ray reaches: behind the occluder, or below the horizon, where the receiver itself
/// is in the way.
LPolygon hidden_part(const DirectScene& scene) {
  if (!scene.dark().empty()) return scene.dark();
  return clip(scene.light(), LVec3(scene.vertex().position), -LVec3(scene.vertex().ng));
}

/// What line-ratio computes in the mean: over each chord, the product of the means of integrand and
/// visibility, where the truth is the mean of their product.
double expected_by_line_ratio(const DirectScene& scene) {
  const LPolygon hidden = hidden_part(scene);
  const AreaLight& light = scene.scene().lights()[0];
  const auto of_chord = [&](double u) {
    const std::optional<Chord> chord = light.chords[0].at(static_cast<float>(u));
    if (!chord) return 0.0;
    const DVec3 begin(chord->begin), along = DVec3(chord->direction) * double{chord->length};
    const double f =
        integrate([&](double t) { return scene.integrand(begin + t * along); }, 0, 1, 20);
    return length(along) * f * visible_fraction(begin, along, hidden);
  };
  return kLe * integrate(of_chord, 0, double{light.chords[0].extent()}, 300);
}

struct BiasCase {
  DirectCase scene;
  Material material;
};

std::vector<BiasCase> bias_cases() {
  const std::vector<Vec3> near = parallelogram({0.1f, 0, 0.3f}, {0.6f, 0, 0}, {0, 0.4f, 0});
  const std::vector<Vec3> triangle{{-0.5f, -0.3f, 0.4f}, {0.8f, -0.2f, 0.5f}, {0, 0.5f, 0.4f}};
  const Diffuse matt{Rgb(0.7f)};
  return {
      {{"across", near, parallelogram({0.2f, 0, 0.15f}, {0.2f, 0, 0}, {0, 0.3f, 0})}, matt},
      {{"slanted", near, {{-0.3f, -0.2f, 0.2f}, {0.1f, 0, 0.2f}, {-0.1f, 0.4f, 0.2f}}}, matt},
      {{"triangle", triangle, parallelogram({0.2f, 0, 0.2f}, {0.15f, 0, 0}, {0, 0.3f, 0})}, matt},
      {{"glossy", near, parallelogram({-0.1f, 0, 0.15f}, {0.1f, 0, 0}, {0, 0.3f, 0})},
       GgxConductor{Rgb(0.7f), 0.3f}},
      {{"below", {{0.7f, -0.4f, -0.3f}, {0.8f, 0.5f, -0.2f}, {0.6f, 0, 0.9f}}, {}}, matt},
  };
}

TEST(LineRatio, HasTheBiasOfItsFormulaAndNoOther) {
  const DirectMethod* method = &direct_method("line-ratio");
  ASSERT_NE(method, nullptr);
  ASSERT_FALSE(method->unbiased);
  PValues p_values;
  for (const auto& [c, material] : bias_cases()) {
    const DirectScene scene(c, material);
    const double truth = scene.quadrature_radiance();
    const double expected = expected_by_line_ratio(scene);
    for (const SamplerKind kind : {SamplerKind::independent, SamplerKind::sobol}) {
      const RunningStats stats = measure(scene, *method, kind, 400'000);
      p_values.add(c.name, mean_p_value(stats, expected, 2e-5 * expected));
      EXPECT_GT(std::abs(stats.mean() - truth), 10 * stats.standard_error()) << c.name;
    }
  }
  p_values.expect_all();
}

// The formula itself, where nothing is in the way: it must then give the truth.
TEST(LineRatio, IsUnbiasedByItsFormulaWhereNothingIsHidden) {
  for (const auto& [c, material] : bias_cases()) {
    const DirectScene scene({c.name, c.light, {}}, material);
    if (!hidden_part(scene).empty()) continue;
    EXPECT_NEAR(expected_by_line_ratio(scene) / scene.quadrature_radiance(), 1, 1e-5) << c.name;
  }
}

// Shadow edges parallel to the chords: each chord is lit or dark as a whole, and no bias is left.
TEST(LineRatio, IsUnbiasedWhereTheShadowEdgeRunsAlongTheChords) {
  const DirectScene scene({"", parallelogram({0.1f, 0, 0.3f}, {0.6f, 0, 0}, {0, 0.4f, 0}),
                           parallelogram({0, 0.2f, 0.15f}, {1, 0, 0}, {0, 0.15f, 0})},
                          Diffuse{Rgb(0.7f)});
  ASSERT_FALSE(scene.dark().empty());
  const RunningStats stats =
      measure(scene, direct_method("line-ratio"), SamplerKind::independent, 400'000);
  const double truth = scene.lambert_radiance();
  EXPECT_GT(mean_p_value(stats, truth, 2e-5 * truth), kFamilyLevel);
}

}  // namespace
}  // namespace raytracing
