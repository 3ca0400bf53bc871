// The pictures of scenes/ against references that were rendered once (data/reference/make.sh).
//
// The tests render with another seed and independent samples, so that the variances are true ones.
// 256 samples per pixel: the mean of a block of 64 pixels is then one of 16384 samples, which is
// normal enough for z-tests although single samples are skewed; for single pixels see
// support/compare_pictures.h. Seeds are fixed: a test that passed passes again until the code
// changes.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "support/picture_test.h"

namespace raytracing {
namespace {

constexpr int kSize = 64;
constexpr std::uint64_t kSpp = 256;

std::filesystem::path reference_path(const std::string& scene) {
  return kSource / "tests/data/reference" / (scene + ".exr");
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "scenes"))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

NoisyPicture render_picture(SceneDescription description, std::string_view method,
                            std::uint64_t seed) {
  RenderOptions options;
  options.width = options.height = kSize;
  options.spp = kSpp;
  options.seed = seed;
  options.threads = 2;
  options.sampler = SamplerKind::independent;
  options.path.method = &direct_method(method);
  return render_picture(std::move(description), options);
}

NoisyPicture read_reference(const std::string& scene) {
  const ReadImage image = read_with_oiio(reference_path(scene).string());
  EXPECT_EQ(image.attribute("sampler"), "independent");
  EXPECT_EQ(image.attribute("complete"), "true");
  EXPECT_EQ(image.spec.width, kSize);
  EXPECT_EQ(image.spec.height, kSize);
  return noisy_picture(image);
}

void expect_same(const std::string& scene, std::string_view method, std::uint64_t seed) {
  const NoisyPicture reference = read_reference(scene);
  const NoisyPicture test = render_picture(load_scene(scene), method, seed);
  const PictureComparison comparison = compare_pictures(test, reference);
  EXPECT_TRUE(comparison.same) << comparison.text();
  if (!comparison.same)
    write_artefacts(scene + "_" + std::string(method), test, reference, comparison);
}

class Regression : public testing::TestWithParam<std::string> {};

TEST_P(Regression, PictureIsTheReference) { expect_same(GetParam(), "solid-angle", 2); }

INSTANTIATE_TEST_SUITE_P(Scenes, Regression, testing::ValuesIn(scene_names()),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

TEST(RegressionMethods, EachUnbiasedMethodGivesTheSamePicture) {
  for (const DirectMethod& method : direct_methods()) {
    if (!method.unbiased || method.name == "solid-angle") continue;
    SCOPED_TRACE(method.name);
    expect_same("cornell", method.name, 3);
    expect_same("glossy", method.name, 3);
  }
}

TEST(RegressionReferences, ThereIsOneForEachSceneAndNoOther) {
  std::set<std::string> references;
  for (const auto& entry : std::filesystem::directory_iterator(kSource / "tests/data/reference"))
    if (entry.path().extension() == ".exr") references.insert(entry.path().stem().string());
  const std::vector<std::string> scenes = scene_names();
  EXPECT_EQ(references, std::set<std::string>(scenes.begin(), scenes.end()));
}

// The comparison itself: it sees one reflectance changed by 2 per cent.
TEST(RegressionComparison, SeesTwoPerCentOfOneReflectance) {
  const NoisyPicture reference = read_reference("cornell");
  const SceneDescription original = load_scene("cornell");
  for (const char* name : {"white", "red", "green"}) {
    SceneDescription changed = original;
    int found = 0;
    for (Surface& surface : changed.surfaces)
      if (surface.name == name) {
        std::get<Diffuse>(surface.material).reflectance *= 1.02f;
        ++found;
      }
    ASSERT_EQ(found, 1) << name;
    const NoisyPicture test = render_picture(std::move(changed), "solid-angle", 2);
    const PictureComparison comparison = compare_pictures(test, reference);
    EXPECT_FALSE(comparison.same) << name << "\n" << comparison.text();
  }
}

}  // namespace
}  // namespace raytracing
