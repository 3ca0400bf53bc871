// Direct light at one point, by every method and sampler, against closed forms and quadrature.

#include "support/direct_light.h"

#include <gtest/gtest.h>

#include "support/p_values.h"

namespace raytracing {
namespace {

constexpr SamplerKind kSamplers[]{SamplerKind::independent, SamplerKind::sobol};
constexpr int kSamples = 40'000;
// What float arithmetic may add to a mean, relative to it: a solid angle of 0.03 or more is known
// to 3e-7 in absolute terms.
constexpr double kRounding = 2e-5;

const Diffuse kMatt{Rgb(0.7f, 0.5f, 0.3f)};

/// Points of the plane through `origin` along `x` and `y`.
std::vector<Vec3> in_plane(const Vec3& origin, const Vec3& x, const Vec3& y,
                           const std::vector<Vec2>& points) {
  std::vector<Vec3> polygon;
  for (const Vec2& p : points) polygon.push_back(origin + p.x * x + p.y * y);
  return polygon;
}

const std::vector<Vec2> kPentagon{
    {-0.5f, -0.4f}, {0.3f, -0.6f}, {0.7f, 0.1f}, {0.2f, 0.6f}, {-0.4f, 0.3f}};

std::vector<DirectCase> unoccluded_cases() {
  const Vec3 tilted_x(0.8f, 0.0f, -0.6f), tilted_y(0.0f, 1.0f, 0.0f);
  return {
      {"rectangle", parallelogram({0.2f, 0.1f, 1.5f}, {0.5f, 0, 0}, {0, 0.4f, 0}), {}},
      {"oblique rectangle",
       parallelogram({0.8f, 0.3f, 0.9f}, 0.5f * tilted_x, 0.4f * tilted_y),
       {}},
      {"parallelogram", parallelogram({0.3f, 0, 0.8f}, {0.4f, 0.1f, 0}, {0.2f, 0.5f, 0.1f}), {}},
      {"triangle", {{-0.9f, 0.2f, 0.8f}, {0.1f, 0.9f, 1.2f}, {-0.2f, -0.5f, 0.7f}}, {}},
      {"pentagon", in_plane({0.4f, 0, 1}, tilted_x, tilted_y, kPentagon), {}},
      {"near rectangle", parallelogram({0.3f, 0.2f, 0.1f}, {0.5f, 0, 0}, {0, 0.5f, 0}), {}},
      {"near triangle", {{-0.5f, -0.3f, 0.1f}, {0.6f, -0.2f, 0.2f}, {0, 0.5f, 0.1f}}, {}},
      {"far rectangle", parallelogram({9, 3, 40}, {0.5f, 0, 0}, {0, 0.4f, 0.1f}), {}},
      {"far pentagon", in_plane({-20, 5, 30}, tilted_x, tilted_y, kPentagon), {}},
      {"rectangle partly below", parallelogram({0.6f, 0, 0.1f}, {0, 0.5f, 0}, {0, 0, 0.6f}), {}},
      {"triangle partly below", {{0.7f, -0.4f, -0.3f}, {0.8f, 0.5f, -0.2f}, {0.6f, 0, 0.9f}}, {}},
      {"pentagon partly below",
       in_plane({0.1f, 0.8f, 0}, {1, 0, 0}, {0, 0.6f, 0.8f}, kPentagon),
       {}},
  };
}

std::vector<DirectCase> occluded_cases() {
  const auto light = parallelogram({0.2f, 0.1f, 1}, {0.5f, 0, 0}, {0, 0.4f, 0});
  const Vec3 x(0.8f, 0.0f, -0.6f), y(0.0f, 1.0f, 0.0f);
  return {
      {"rectangle behind a quad", light, parallelogram({0.3f, 0, 0.5f}, {0.2f, 0, 0}, {0, 1, 0})},
      {"rectangle behind a triangle",
       light,
       {{-0.2f, -0.1f, 0.4f}, {0.25f, 0, 0.6f}, {0, 0.3f, 0.5f}}},
      {"rectangle with a hole of shadow",
       light,
       {{0.05f, 0, 0.5f}, {0.2f, 0.02f, 0.55f}, {0.1f, 0.15f, 0.5f}}},
      {"triangle behind a quad",
       {{-0.9f, 0.2f, 0.8f}, {0.1f, 0.9f, 1.2f}, {-0.2f, -0.5f, 0.7f}},
       parallelogram({-0.3f, 0.1f, 0.5f}, {0.3f, 0.1f, 0}, {0, 0.15f, 0.1f})},
      {"pentagon behind a triangle",
       in_plane({0.4f, 0, 1}, x, y, kPentagon),
       {{0.1f, -0.4f, 0.5f}, {0.6f, 0, 0.4f}, {0, 0.4f, 0.5f}}},
      {"near rectangle behind a quad", parallelogram({0, 0, 0.3f}, {0.6f, 0, 0}, {0, 0.4f, 0}),
       parallelogram({0.2f, 0, 0.15f}, {0.2f, 0, 0.02f}, {0, 0.3f, 0})},
  };
}

/// Whether the method must be right here. The known bias of line-ratio comes with occlusion alone,
/// be it by the receiver itself.
bool must_hold(const DirectMethod& method, const DirectScene& scene) {
  if (method.unbiased) return true;
  const LVec3 p(scene.vertex().position), n(scene.vertex().ng);
  return method.name == "line-ratio" && scene.dark().empty() && clip(scene.light(), p, -n).empty();
}

void test_methods(const DirectScene& scene, double truth, const std::string& name,
                  PValues& p_values) {
  ASSERT_GT(truth, 0) << name;
  for (const DirectMethod& method : direct_methods()) {
    if (!must_hold(method, scene)) continue;
    for (const SamplerKind kind : kSamplers)
      p_values.add(name + ", " + std::string(method.name) + ", " + std::string(to_string(kind)),
                   mean_p_value(measure(scene, method, kind, kSamples), truth, kRounding * truth));
  }
}

TEST(DirectLight, OfAnUnoccludedPolygonIsLamberts) {
  PValues p_values;
  for (const DirectCase& c : unoccluded_cases()) {
    const DirectScene scene(c, kMatt);
    test_methods(scene, scene.lambert_radiance(), c.name, p_values);
  }
  p_values.expect_all();
}

TEST(DirectLight, OfAnOccludedPolygonIsLambertsOfTheVisiblePart) {
  PValues p_values;
  for (const DirectCase& c : occluded_cases()) {
    const DirectScene scene(c, kMatt);
    const double lit =
        scene.lambert_radiance() / DirectScene({"", c.light, {}}, kMatt).lambert_radiance();
    EXPECT_GT(lit, 0.2) << c.name;
    EXPECT_LT(lit, 0.95) << c.name;
    test_methods(scene, scene.lambert_radiance(), c.name, p_values);
  }
  p_values.expect_all();
}

TEST(DirectLight, OfAHiddenLightIsNothing) {
  const DirectCase c{"", parallelogram({0, 0, 1}, {0.5f, 0, 0}, {0, 0.5f, 0}),
                     parallelogram({0, 0, 0.5f}, {0.5f, 0, 0}, {0, 0.5f, 0})};
  for (const Material& material : {Material(kMatt), Material(GgxConductor{Rgb(0.9f), 0.1f})}) {
    const DirectScene scene(c, material);
    for (const DirectMethod& method : direct_methods())
      for (const SamplerKind kind : kSamplers)
        EXPECT_EQ(measure(scene, method, kind, 2000).mean(), 0) << method.name;
  }
}

// The quadrature of the tests below, where a closed form can judge it.
TEST(DirectLight, QuadratureAgreesWithLambert) {
  for (const auto& cases : {unoccluded_cases(), occluded_cases()})
    for (const DirectCase& c : cases) {
      const DirectScene scene(c, kMatt);
      EXPECT_NEAR(scene.quadrature_radiance() / scene.lambert_radiance(), 1, 2e-6) << c.name;
    }
}

// The viewer stands at 37 degrees from the normal; mirror reflection leaves along
// (-0.48, 0.36, 0.8). The lights lie in the lobe, across its edge, and beside it.
std::vector<DirectCase> glossy_cases() {
  const Vec3 x(0.8f, 0.0f, -0.6f), y(0.0f, 1.0f, 0.0f);
  const auto in_lobe = parallelogram({-0.5f, 0.4f, 0.8f}, {0.2f, 0, 0.1f}, {0, 0.2f, 0});
  return {
      {"in the lobe", in_lobe, {}},
      {"small in the lobe", parallelogram({-0.9f, 0.7f, 1.6f}, {0.1f, 0, 0}, {0, 0.1f, 0}), {}},
      {"large", parallelogram({0, 0, 0.4f}, {0.9f, 0, 0}, {0, 0.7f, 0}), {}},
      {"pentagon at the edge", in_plane({-0.3f, 0.1f, 0.6f}, 0.4f * x, 0.4f * y, kPentagon), {}},
      {"triangle beside the lobe", {{0.2f, 0, 0.9f}, {0.5f, -0.3f, 0.8f}, {0.3f, 0.4f, 1}}, {}},
      {"half hidden", in_lobe, parallelogram({-0.35f, 0.2f, 0.4f}, {0.1f, 0, 0}, {0, 0.2f, 0})},
      {"large, half hidden",
       parallelogram({0, 0, 0.4f}, {0.9f, 0, 0}, {0, 0.7f, 0}),
       {{-0.3f, -0.2f, 0.2f}, {-0.1f, 0.4f, 0.25f}, {-0.6f, 0.5f, 0.2f}}},
  };
}

TEST(DirectLight, OfAGlossyReceiverEqualsQuadrature) {
  PValues p_values;
  for (const GgxConductor& material : {GgxConductor{Rgb(0.7f), 0.3f}, GgxConductor{Rgb(0.7f), 0.1f},
                                       GgxConductor{Rgb(0.2f), 0.2f, Fresnel::schlick}})
    for (const DirectCase& c : glossy_cases()) {
      const DirectScene scene(c, material);
      test_methods(scene, scene.quadrature_radiance(),
                   c.name + ", alpha " + std::to_string(material.alpha), p_values);
    }
  p_values.expect_all();
}

}  // namespace
}  // namespace raytracing
