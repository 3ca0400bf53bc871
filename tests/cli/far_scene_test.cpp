// A scene far from the origin of coordinates, as users see it: pictures, replays, warnings.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "raytracing/integrator/direct_method.h"
#include "raytracing/io/image.h"
#include "support/cli_folder.h"

namespace raytracing {
namespace {

// A floor, a wall, a roof and a lamp, whose coordinates are multiples of 1/4. `offset` is added to
// all vertices but the first, which belongs to no face.
std::string model(const DVec3& offset) {
  std::string text = "mtllib m.mtl\nv 0 0 0\n";
  for (const DVec3& p : {DVec3(-2, 0, -2), DVec3(2, 0, -2), DVec3(2, 0, 2), DVec3(-2, 0, 2),
                         DVec3(-2, 4, -2), DVec3(2, 4, -2), DVec3(-1, 1, -1), DVec3(0.75, 1, -1),
                         DVec3(0.75, 1.25, 0.5), DVec3(-1, 1, 0.5), DVec3(-0.5, 3.75, -0.5),
                         DVec3(0.5, 3.75, -0.5), DVec3(0.5, 3.75, 0.5), DVec3(-0.5, 3.75, 0.5)})
    text += fmt::format("v {} {} {}\n", p.x + offset.x, p.y + offset.y, p.z + offset.z);
  return text +
         "usemtl grey\nf 5 4 3 2\nf 2 3 7 6\nf 8 9 10\nf 8 10 11\n"
         "usemtl lamp\nf 12 13 14 15\n";
}
const std::string kLibrary = "newmtl grey\nKd .6 .5 .4\nnewmtl lamp\nKd 0 0 0\nKe 6 6 6\n";
const std::string kNarrow = "warning: a pixel is";

// The same scene with `offset` added to all positions.
std::string scene(const DVec3& offset) {
  const auto place = [&](double x, double y, double z) {
    return fmt::format("[{}, {}, {}]", x + offset.x, y + offset.y, z + offset.z);
  };
  return "[film]\nwidth = 24\nheight = 24\n[camera]\norigin = " + place(0.25, 2.5, 6) +
         "\ntarget = " + place(0, 1.5, 0) +
         "\n[[models]]\nobj = 'm.obj'\n"
         "[materials.shiny]\ntype = 'ggx'\nroughness = 0.5\n[[spheres]]\n"
         "center = " +
         place(1, 0.5, 1) + "\nradius = 0.5\nmaterial = 'shiny'\n";
}

struct FarScene : ::testing::Test {
  void SetUp() override { at.folder.write("m.mtl", kLibrary); }
  RunResult run(const DVec3& offset, std::vector<std::string> more) {
    at.folder.write("m.obj", model(offset));
    at.folder.write("s.toml", scene(offset));
    more.insert(more.begin(), {"s.toml", "--spp=4"});
    const RunResult result = at.run(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return result;
  }
  std::vector<float> picture(const DVec3& offset, const std::string& method) {
    run(offset, {"--light-sampling", method, "-o", "s.exr"});
    return read_image(at.folder / "s.exr").values;
  }
  CliFolder at;
};

// Offsets to which multiples of 1/4 are added without rounding.
const DVec3 kOffsets[] = {{1e6, 0, 0}, {-1e6, 2e6, 3e6}, {0, 0, -4194304}, {1000, -500, 250}};

// The middle of the scene's bounds is (0, 2, 0). A far scene is moved there, a near one is not, so
// that their positions differ by that much and their rays are rounded differently. The values
// differ by less than a thousandth, except for one in a hundred, where a ray passes an edge on its
// other side.
TEST_F(FarScene, LooksLikeTheNearOne) {
  for (const DirectMethod& method : direct_methods()) {
    const std::vector<float> near = picture(DVec3(0.0), std::string(method.name));
    for (const DVec3& offset : kOffsets) {
      const std::vector<float> far = picture(offset, std::string(method.name));
      ASSERT_EQ(far.size(), near.size());
      double sum = 0, difference = 0;
      std::size_t differ = 0;
      for (std::size_t i = 0; i < far.size(); ++i) {
        sum += near[i];
        difference += far[i] - near[i];
        differ += std::abs(far[i] - near[i]) > 1e-3f * near[i];
      }
      EXPECT_GT(sum / static_cast<double>(near.size()), 0.02);
      EXPECT_LE(std::abs(difference), 1e-4 * sum) << method.name << " " << offset.x;
      EXPECT_LE(differ, far.size() / 100) << method.name << " " << offset.x;
    }
  }
}

// A far scene is moved to the same place wherever it lies.
TEST_F(FarScene, LooksTheSameFromAllFarPlaces) {
  const std::vector<float> first = picture({16, 1024, -512}, "line");
  EXPECT_NE(first, picture(DVec3(0.0), "line")) << "the near one is not moved";
  for (const DVec3& offset : {DVec3(1e6, -1e6, 5e5), DVec3(-4194304, 2e6, 3e6)})
    EXPECT_EQ(picture(offset, "line"), first);
}

struct Replay {
  std::vector<DVec3> places;
  std::string rest;  // all but those
};
Replay parse(const std::string& text) {
  Replay replay;
  std::size_t at = 0;
  const std::string begin = " at (";
  for (std::size_t found; (found = text.find(begin, at)) != std::string::npos;) {
    DVec3 p;
    const std::size_t place = found + begin.size();
    EXPECT_EQ(std::sscanf(text.c_str() + place, "%lf, %lf, %lf", &p.x, &p.y, &p.z), 3);
    replay.places.push_back(p);
    replay.rest += text.substr(at, place - at);
    at = text.find(')', place);
  }
  replay.rest += text.substr(at);
  return replay;
}

// The positions agree to the nine digits that are printed.
TEST_F(FarScene, ReplaysInTheUsersCoordinates) {
  const DVec3 here(16, 1024, -512), there(1e6, 2e6, -3e6);
  std::size_t vertices = 0;
  for (const char* sample : {"12,12,0", "3,20,1", "14,18,2", "20,5,3"}) {
    const auto replay = [&](const DVec3& offset) {
      return parse(run(offset, {"--quiet", "--replay", sample}).out);
    };
    const Replay first = replay(here), second = replay(there);
    EXPECT_EQ(first.rest, second.rest);
    ASSERT_EQ(first.places.size(), second.places.size());
    vertices += first.places.size();
    for (std::size_t i = 0; i < first.places.size(); ++i)
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(first.places[i][k] - here[k], second.places[i][k] - there[k], 0.0051);
  }
  EXPECT_GT(vertices, 8u);
}

TEST_F(FarScene, WarnsWhereItsOwnCoordinatesAreRounded) {
  const auto warnings = [&](const DVec3& offset) { return run(offset, {"-o", "s.png"}).err; };
  for (const DVec3& offset : {DVec3(0.0), DVec3(1000, 0, 0)})
    EXPECT_EQ(warnings(offset).find("warning"), std::string::npos) << warnings(offset);
  EXPECT_NE(warnings({1e6, 0, 0})
                .find("warning: the scene lies so far from the origin that its coordinates are "
                      "rounded to 0.03 of half its size; move it closer to the origin\n"),
            std::string::npos)
      << warnings({1e6, 0, 0});
}

// A triangle seen from `distance` times half its size.
std::string seen_from(double distance) {
  const double fov = 2 * std::atan(1.5 / distance) * 180 / std::acos(-1.0);
  return fmt::format(
      "[film]\nwidth = 24\nheight = 24\n[camera]\norigin = [{}, {}, {}]\n"
      "target = [0, 0, 0]\nfov = {}\n[[models]]\nobj = 'm.obj'\n",
      0.48 * distance, 0.36 * distance, 0.8 * distance, fov);
}

TEST_F(FarScene, WarnsOfACameraSoFarThatItsRaysAreRounded) {
  // The scene is a single emitting triangle.
  at.folder.write("m.obj",
                  "mtllib m.mtl\nv -.9 -.2 -.8\nv .6 -.9 .1\nv .3 .8 .2\nusemtl lamp\n"
                  "f 1 2 3\n");
  const auto seen = [&](double distance, bool warns) {
    at.folder.write("s.toml", seen_from(distance));
    const RunResult run = at.run({"s.toml", "--spp=16", "--max-depth=1", "-o", "s.exr"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err.find(kNarrow) != std::string::npos, warns) << run.err;
    return read_image(at.folder / "s.exr").values;
  };
  const std::vector<float> near = seen(1e3, false);
  for (const double distance : {3e3, 1e4, 3e4, 1e5}) {
    const std::vector<float> far = seen(distance, false);
    double sum = 0, difference = 0;
    for (std::size_t i = 0; i < near.size(); ++i) {
      sum += near[i];
      difference += std::abs(far[i] - near[i]);
    }
    EXPECT_LE(difference, 0.05 * sum) << distance;
  }
  seen(3e5, true);
  seen(1e7, true);
}

}  // namespace
}  // namespace raytracing
