// Our pictures against those of Mitsuba 3, a renderer that we did not write.
//
// tests/data/mitsuba holds its pictures of six scenes, direct light only and all bounces, with the
// variances of their pixels; tests/validation/render_reference.py made them and tells how. They
// were made from the same scene files, which Python read, by none of our code. Mitsuba has our GGX
// model from a plugin in Python, since its own `roughconductor` takes masking and shadowing as
// separable: at roughness 0.8 that makes a difference of .2 %, which is seen here, and at 0.4 of
// .02 %.
//
// Ours are Sobol' samples in 32 replicates, whose variances are honest. The pixels that show the
// light or its edge are told apart: they are a hundred times brighter than the others, so that the
// noise of the edge alone is that of the mean of the picture, and an edge gives each group of
// samples one of few values, which no z-test is made for. They count in the mean of the whole
// picture only. All pictures together share the level of a family of tests.

#include <gtest/gtest.h>

#include <cmath>

#include "support/picture_test.h"

namespace raytracing {
namespace {

struct Case {
  std::string scene;
  bool direct;  ///< direct light only, else all bounces

  std::string name() const { return scene + (direct ? "_direct" : "_all"); }
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name(); }

std::vector<Case> cases() {
  std::vector<Case> result;
  for (const char* scene :
       {"cornell", "glossy", "sphere_r0.4", "sphere_r0.8", "teapot_diffuse", "teapot_metal"})
    for (const bool direct : {true, false}) result.push_back({scene, direct});
  return result;
}

NoisyPicture read_reference(const Case& c) {
  const auto path = kSource / "tests/data/mitsuba" / (c.name() + ".exr");
  const ReadImage image = read_with_oiio(path.string());
  EXPECT_TRUE(image.attribute("generatedBy").starts_with("Mitsuba version 3."));
  EXPECT_EQ(image.attribute("scene"), "scenes/" + c.scene + ".toml");
  EXPECT_EQ(image.attribute("max_depth"), c.direct ? "1" : "unlimited");
  return noisy_picture(image);
}

NoisyPicture render_ours(const Case& c, const NoisyPicture& reference,
                         SceneDescription description) {
  RenderOptions options;
  options.width = reference.width;
  options.height = reference.height;
  options.spp = c.direct ? 256 : 1024;
  options.replicates = 32;
  options.seed = 1;
  options.threads = 2;
  options.path.method = &direct_method("solid-angle");
  if (c.direct) options.path.max_depth = 1;
  return render_picture(std::move(description), options);
}

/// The picture, black and without variance where `reference` shows the light or its edge.
NoisyPicture without_light(NoisyPicture picture, const NoisyPicture& reference) {
  constexpr double kRadiance = 5;  // the light's is 31 to 48, and that of all else below 3
  const int width = picture.width, height = picture.height;
  const auto index = [&](int x, int y) {
    return static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width +
           std::clamp(x, 0, width - 1);
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double brightest = 0;
      for (int v = y - 1; v <= y + 1; ++v)
        for (int u = x - 1; u <= x + 1; ++u)
          brightest = std::max(brightest, reference.mean[index(u, v)].x);
      if (brightest > kRadiance)
        picture.mean[index(x, y)] = picture.variance[index(x, y)] = DVec3(0.0);
    }
  return picture;
}

struct Means {
  DVec3 ratio;      ///< of the pictures' means
  DVec3 deviation;  ///< standard deviation of the ratio
};

Means compare_means(const NoisyPicture& ours, const NoisyPicture& reference) {
  DVec3 a(0.0), b(0.0), variance(0.0);
  for (std::size_t i = 0; i < ours.mean.size(); ++i) {
    a += ours.mean[i];
    b += reference.mean[i];
    variance += ours.variance[i] + reference.variance[i];
  }
  return {a / b, glm::sqrt(variance) / b};
}

/// Half of each case's level is for the mean of the whole picture, half for all else.
double half_level() { return kFamilyLevel / (2.0 * static_cast<double>(cases().size())); }

PictureComparison compare(const NoisyPicture& ours, const NoisyPicture& reference) {
  return compare_pictures(without_light(ours, reference), without_light(reference, reference),
                          half_level());
}

class Mitsuba : public testing::TestWithParam<Case> {};

TEST_P(Mitsuba, PicturesAgree) {
  const Case& c = GetParam();
  const NoisyPicture reference = read_reference(c);
  const NoisyPicture ours = render_ours(c, reference, load_scene(c.scene));
  const PictureComparison comparison = compare(ours, reference);
  EXPECT_TRUE(comparison.same) << comparison.text();
  const Means whole = compare_means(ours, reference);
  const Means rest =
      compare_means(without_light(ours, reference), without_light(reference, reference));
  for (int i = 0; i < 3; ++i) {
    EXPECT_GE(normal_p_value((whole.ratio[i] - 1) / whole.deviation[i]),
              sidak_level(half_level(), 3));
    EXPECT_LT(rest.deviation[i], 0.0015) << "too noisy to tell anything";
  }
  RecordProperty("ratio", fmt::format("{} +- {}", rest.ratio.x, 1.96 * rest.deviation.x));
  if (HasFailure()) write_artefacts("mitsuba_" + c.name(), ours, reference, comparison);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Mitsuba, testing::ValuesIn(cases()), [](const auto& c) {
  std::string name = c.param.name();
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
});

// The comparison itself: it sees a light that is brighter by 1 per cent,
TEST(MitsubaComparison, SeesOnePerCentOfTheLight) {
  for (const Case& c : {Case{"cornell", true}, Case{"cornell", false}}) {
    const NoisyPicture reference = read_reference(c);
    SceneDescription brighter = load_scene(c.scene);
    for (Surface& surface : brighter.surfaces) surface.Le *= 1.01f;
    const NoisyPicture ours = render_ours(c, reference, std::move(brighter));
    EXPECT_FALSE(compare(ours, reference).same) << c.name();
  }
}

// and a metal that is rougher by 2 per cent.
TEST(MitsubaComparison, SeesTwoPerCentOfTheRoughness) {
  const Case c{"teapot_metal", true};
  const NoisyPicture reference = read_reference(c);
  SceneDescription rougher = load_scene(c.scene);
  int found = 0;
  for (Surface& surface : rougher.surfaces)
    if (auto* metal = std::get_if<GgxConductor>(&surface.material)) {
      metal->alpha *= 1.02f * 1.02f;
      ++found;
    }
  ASSERT_EQ(found, 1);
  const NoisyPicture ours = render_ours(c, reference, std::move(rougher));
  EXPECT_FALSE(compare(ours, reference).same);
}

}  // namespace
}  // namespace raytracing
