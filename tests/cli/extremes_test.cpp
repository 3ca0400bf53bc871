// Degenerate scenes: each rendering ends and reports what is wrong with the scene.

#include <gtest/gtest.h>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/io/image.h"
#include "support/cli_folder.h"

namespace raytracing {
namespace {

const std::string kCamera =
    "[film]\nwidth = 6\nheight = 6\n[camera]\norigin = [0,0,0]\ntarget = [0,0.1,-1]\n";
// The cube [-1,1]^3 as seen from inside; a light hangs below its ceiling.
const std::string kRoom =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 2 3 4\nf 6 5 8 7\nf 2 6 7 3\nf 5 1 4 8\nf 5 6 2 1\nf 4 3 7 8\n";
// Both models; `place` holds further lines for each.
std::string model(const std::string& place = "") {
  return "[[models]]\nobj = 'room.obj'\nmaterial = 'wall'\n" + place +
         "[[models]]\nobj = 'light.obj'\nmaterial = 'light'\n" + place;
}
const std::string kModel = model();
const std::string kDown = "v -.5 .9 -.5\nv .5 .9 -.5\nv .5 .9 .5\nv -.5 .9 .5\nf 1 2 3 4\n";

std::string materials(const std::string& reflectance, const std::string& emission) {
  return "[materials.wall]\ntype = 'diffuse'\nreflectance = " + reflectance +
         "\n[materials.light]\ntype = 'diffuse'\nreflectance = " + reflectance +
         "\nemission = " + emission + "\n";
}

struct Extremes : ::testing::Test {
  RunResult render(const std::string& scene, std::vector<std::string> more = {}) {
    at_.folder.write("s.toml", scene);
    more.insert(more.begin(), {"s.toml", "-o", "s.exr", "--stats", "s.json", "--spp=16"});
    return at_.run(more);
  }
  double mean() const { return at_.json("s.json")["mean_g"]; }
  CliFolder at_;
};

TEST_F(Extremes, AnEmptySceneIsBlackAndSaysSo) {
  const RunResult run = render(kCamera);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("warning: the scene has no light; the image will be black\n"),
            std::string::npos)
      << run.err;
  for (const float value : read_image(at_.folder / "s.exr").values) EXPECT_EQ(value, 0);
}

// In a closed room that absorbs nothing, only Russian roulette ends a path.
TEST_F(Extremes, ARoomThatAbsorbsNothingEnds) {
  at_.folder.write("room.obj", kRoom);
  at_.folder.write("light.obj", kDown);
  for (const DirectMethod& method : direct_methods()) {
    const RunResult run = render(kCamera + materials("1", "1") + kModel,
                                 {"--light-sampling", std::string(method.name), "--strict"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_GT(mean(), 0.2);
    EXPECT_EQ(at_.json("s.json")["rays_escaped"], 0) << "lost in a closed room: " << method.name;
  }
}

// Floats lie 1/4 apart there: the room is represented exactly, but rays would have no digits left.
TEST_F(Extremes, FarFromTheOriginIsAsNear) {
  at_.folder.write("room.obj", kRoom);
  at_.folder.write("light.obj", kDown);
  ASSERT_EQ(render(kCamera + materials("0.5", "1") + kModel).exit_code, 0);
  const std::vector<float> near = read_image(at_.folder / "s.exr").values;
  const std::string camera =
      "[film]\nwidth = 6\nheight = 6\n[camera]\norigin = "
      "[2097152,0,-1048576]\ntarget = [2097152,0.1,-1048577]\n";
  const RunResult run =
      render(camera + materials("0.5", "1") + model("translate = [2097152, 0, -1048576]\n"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("warning: the scene lies so far from the origin that its coordinates are "
                         "rounded to 0.2 of half its size; move it closer to the origin\n"),
            std::string::npos)
      << run.err;
  EXPECT_EQ(read_image(at_.folder / "s.exr").values, near);
  const RunResult replay = at_.run({"s.toml", "--spp=16", "--replay=3,3,0", "--quiet"});
  EXPECT_NE(replay.out.find("vertex 1 at (209715"), std::string::npos) << replay.out;
}

TEST_F(Extremes, BrightLightsScaleAndStayFinite) {
  at_.folder.write("room.obj", kRoom);
  at_.folder.write("light.obj", kDown);
  ASSERT_EQ(render(kCamera + materials("0.5", "1") + kModel).exit_code, 0);
  const double one = mean();
  ASSERT_EQ(render(kCamera + materials("0.5", "1e9") + kModel, {"--strict"}).exit_code, 0);
  EXPECT_NEAR(mean() / 1e9, one, 1e-5 * one);
  ASSERT_EQ(render(kCamera + materials("0.5", "1e-9") + kModel, {"--strict"}).exit_code, 0);
  EXPECT_NEAR(mean() * 1e9, one, 1e-5 * one);
}

TEST_F(Extremes, ALightThatFacesAwayFromEverythingIsReported) {
  at_.folder.write("room.obj", "v -1 -1 -1\nv 1 -1 -1\nv 1 -1 1\nv -1 -1 1\nf 4 3 2 1\n");
  at_.folder.write("light.obj", kDown);
  const std::string scene = kCamera + materials("0.5", "1") + kModel;
  EXPECT_EQ(render(scene).err.find("away from everything"), std::string::npos);
  at_.folder.write("light.obj", "v -.5 .9 -.5\nv .5 .9 -.5\nv .5 .9 .5\nv -.5 .9 .5\nf 4 3 2 1\n");
  const RunResult run = render(scene, {"--quiet"});
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.err,
            "warning: lights that face away from everything: 1 of 1; a light emits to the side "
            "from which its vertices appear counter-clockwise\n");
  EXPECT_EQ(mean(), 0);
}

TEST_F(Extremes, ALightWithoutAreaIsDropped) {
  at_.folder.write("room.obj", kRoom);
  at_.folder.write("light.obj", "v 0 .9 0\nv 1 .9 0\nv .5 .9 0\nf 1 2 3\n");
  const RunResult run = render(kCamera + materials("0.5", "1") + kModel);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_NE(run.err.find("light.obj:4:1: dropped: face without area\n"), std::string::npos)
      << run.err;
  EXPECT_NE(run.err.find("warning: the scene has no light"), std::string::npos);
  EXPECT_EQ(mean(), 0);
}

// A camera inside a sphere sees darkness, and nothing worse.
TEST_F(Extremes, ACameraInsideOfGeometry) {
  at_.folder.write("room.obj", kRoom);
  at_.folder.write("light.obj", kDown);
  const RunResult run = render(kCamera + materials("0.9", "1") + kModel +
                                   "[[spheres]]\ncenter = [0,0,0]\nradius = 0.5\n"
                                   "material = 'wall'\n",
                               {"--strict"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(mean(), 0);
  EXPECT_EQ(at_.json("s.json")["rays_escaped"], 0);
}

// Rays that leave an open scene and light samples that fall back to uniform area are counted.
TEST_F(Extremes, FallbacksAndEscapedRaysAreCounted) {
  at_.folder.write("room.obj", "v -9 -1 -9\nv 9 -1 -9\nv 9 -1 9\nv -9 -1 9\nf 4 3 2 1\n");
  at_.folder.write("light.obj", kDown);
  const std::string near = kCamera + materials("0.5", "1") + kModel;
  const std::string far = near + "translate = [0, 1000, 0]\n";
  for (const char* method : {"solid-angle", "line", "point"}) {
    ASSERT_EQ(render(far, {"--light-sampling", method, "--max-depth=3"}).exit_code, 0);
    const auto stats = at_.json("s.json");
    EXPECT_GT(stats["rays_escaped"], 0);
    if (method == std::string("solid-angle")) {
      EXPECT_GT(stats["area_fallbacks"], 0);
      EXPECT_EQ(stats["area_fallbacks"], stats["rays_shadow"]);
    } else {
      EXPECT_EQ(stats["area_fallbacks"], 0) << "in closed form, or by area anyway: " << method;
    }
  }
  ASSERT_EQ(render(near, {"--max-depth=1", "--light-sampling=solid-angle"}).exit_code, 0);
  EXPECT_LT(at_.json("s.json")["area_fallbacks"], at_.json("s.json")["rays_shadow"]);
}

}  // namespace
}  // namespace raytracing
