#include "raytracing/io/scene_file.h"

#include <gtest/gtest.h>

#include "support/scene_folder.h"

namespace raytracing {
namespace {

constexpr const char* kEveryKey = R"(
[film]
width = 65536
height = 1
[camera]
origin = [278, 273.5, -800]
target = [278, 273, 0]
up = [0.5, 1, 0]
fov = 37.5
[render]
spp = 1099511627776
light_sampling = "line"
[materials.metal]
type = "ggx"
reflectance = [0.9, 0.85, 0.7]
roughness = 0.5
fresnel = "schlick"
[materials.lamp]
type = "diffuse"
reflectance = 0
emission = [47.5, 38, 31]
[materials."two words"]
type = "diffuse"
reflectance = [1, 0.5, 0]
[[models]]
obj = "quad.obj"
scale = 2
rotate = [0, 90, 0]
translate = [1, 2, 3]
material = "lamp"
[[spheres]]
center = [278, 120, 280]
radius = 120
material = "metal"
)";

class EveryKey : public ::testing::Test {
 protected:
  EveryKey() {
    scene_.folder.write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
    file_ = scene_.load(kEveryKey);
  }

  SceneFolder scene_;
  SceneFile file_;
};

TEST_F(EveryKey, OfTheWholePicture) {
  EXPECT_EQ(file_.width, 65536);
  EXPECT_EQ(file_.height, 1);
  EXPECT_EQ(file_.spp, 1099511627776);
  EXPECT_EQ(file_.light_sampling, "line");
  const CameraDescription& camera = file_.scene.camera;
  EXPECT_EQ(camera.origin, Vec3(278, 273.5f, -800));
  EXPECT_EQ(camera.target, Vec3(278, 273, 0));
  EXPECT_EQ(camera.up, Vec3(0.5f, 1, 0));
  EXPECT_EQ(camera.vertical_fov, 37.5f);
}

TEST_F(EveryKey, OfMaterials) {
  ASSERT_EQ(file_.scene.surfaces.size(), 3u);
  const Surface& lamp = file_.scene.surfaces[0];
  EXPECT_EQ(lamp.name, "lamp");
  EXPECT_EQ(std::get<Diffuse>(lamp.material).reflectance, Rgb(0.0f));
  EXPECT_EQ(lamp.Le, Rgb(47.5f, 38, 31));
  const Surface& metal = file_.scene.surfaces[1];
  EXPECT_EQ(metal.name, "metal");
  EXPECT_EQ(std::get<GgxConductor>(metal.material).reflectance, Rgb(0.9f, 0.85f, 0.7f));
  EXPECT_EQ(std::get<GgxConductor>(metal.material).alpha, 0.25f);
  EXPECT_EQ(std::get<GgxConductor>(metal.material).fresnel, Fresnel::schlick);
  EXPECT_EQ(metal.Le, Rgb(0.0f));
  EXPECT_EQ(std::get<Diffuse>(file_.scene.surfaces[2].material).reflectance, Rgb(1, 0.5f, 0));
}

TEST_F(EveryKey, OfShapes) {
  ASSERT_EQ(file_.scene.meshes.size(), 1u);
  EXPECT_EQ(file_.scene.meshes[0].positions[1], Vec3(1, 2, 1));
  ASSERT_EQ(file_.scene.meshes[0].faces.size(), 1u);
  EXPECT_EQ(file_.scene.meshes[0].faces[0].material, 0u);
  ASSERT_EQ(file_.scene.spheres.size(), 1u);
  EXPECT_EQ(file_.scene.spheres[0].center, Vec3(278, 120, 280));
  EXPECT_EQ(file_.scene.spheres[0].radius, 120);
  EXPECT_EQ(file_.scene.spheres[0].surface, 1u);
  EXPECT_EQ(file_.assets, std::vector<std::string>{scene_.folder / "quad.obj"});
}

TEST(SceneFile, HasDefaults) {
  SceneFolder scene;
  const SceneFile file = scene.load(kCamera +
                                    "[film]\n[render]\n[materials.d]\ntype = 'diffuse'\n"
                                    "[materials.g]\ntype = 'ggx'\n");
  EXPECT_EQ(file.width, 784);
  EXPECT_EQ(file.height, 784);
  EXPECT_EQ(file.spp, 16);
  EXPECT_EQ(file.light_sampling, "solid-angle");
  EXPECT_EQ(file.scene.camera.up, Vec3(0, 1, 0));
  EXPECT_EQ(file.scene.camera.vertical_fov, 40);
  EXPECT_TRUE(file.scene.meshes.empty());
  EXPECT_TRUE(file.scene.spheres.empty());
  EXPECT_TRUE(file.assets.empty());
  ASSERT_EQ(file.scene.surfaces.size(), 2u);
  EXPECT_EQ(std::get<Diffuse>(file.scene.surfaces[0].material).reflectance, Rgb(0.5f));
  const auto& ggx = std::get<GgxConductor>(file.scene.surfaces[1].material);
  EXPECT_EQ(ggx.reflectance, Rgb(0.9f));
  EXPECT_FLOAT_EQ(ggx.alpha, 0.16f);
  EXPECT_EQ(ggx.fresnel, Fresnel::none);
}

struct Case {
  const char* text;  ///< after kCamera, thus from line 4
  const char* error;
};

void expect_errors(std::initializer_list<Case> cases) {
  SceneFolder scene;
  for (const Case& c : cases) EXPECT_EQ(scene.error(kCamera + c.text), c.error) << c.text;
}

TEST(SceneFileErrors, NameTheNearestKey) {
  expect_errors({
      {"[flim]", "scene.toml:4:2: unknown key 'flim'; the nearest known key is 'film'"},
      {"fow = 40",
       "scene.toml:4:1: unknown key 'camera.fow'; the nearest known key is 'camera.fov'"},
      {"[film]\n  heigth = 3",
       "scene.toml:5:3: unknown key 'film.heigth'; the nearest known key is 'film.height'"},
      {"[materials.m]\ntype = 'ggx'\nrougness = 1\nalpha = 2",
       "scene.toml:6:1: unknown key 'materials.m.rougness'; the nearest known key is "
       "'materials.m.roughness'"},
      {"[[spheres]]\ncentre = [0, 0, 0]",
       "scene.toml:5:1: unknown key 'spheres.centre'; the nearest known key is 'spheres.center'"},
      {"[render]\nsamples = 3\nspp = 3",
       "scene.toml:5:1: unknown key 'render.samples'; the nearest known key is 'render.spp'"},
  });
}

TEST(SceneFileErrors, NameMissingKeys) {
  SceneFolder scene;
  EXPECT_EQ(scene.error(""), "scene.toml: 'camera' is missing");
  EXPECT_EQ(scene.error("\n[camera]\norigin = [0, 0, 0]"),
            "scene.toml:2:1: 'camera.target' is missing");
  EXPECT_EQ(scene.error("camera.target = [0, 0, 0]").substr(0, 10), "scene.toml");
  expect_errors({
      {"[[models]]", "scene.toml:4:1: 'models.obj' is missing"},
      {"[materials.m]", "scene.toml:4:1: 'materials.m.type' is missing"},
      {"[[spheres]]\ncenter = [0, 0, 0]\nradius = 1",
       "scene.toml:4:1: 'spheres.material' is missing"},
  });
}

TEST(SceneFileErrors, TellWhatIsExpectedAndWhatStandsThere) {
  expect_errors({
      {"[film]\nwidth = 0",
       "scene.toml:5:9: film.width: expected an integer from 1 to 65536, found the integer 0"},
      {"[film]\nheight = 65537",
       "scene.toml:5:10: film.height: expected an integer from 1 to 65536, found the integer "
       "65537"},
      {"[film]\nwidth = 2.5",
       "scene.toml:5:9: film.width: expected an integer from 1 to 65536, found the number 2.5"},
      {"[render]\nspp = 0",
       "scene.toml:5:7: render.spp: expected an integer from 1 to 1099511627776, found the integer "
       "0"},
      {"[render]\nlight_sampling = 3",
       "scene.toml:5:18: render.light_sampling: expected a string, found the integer 3"},
      {"fov = \"4\\n0\"",
       "scene.toml:4:7: camera.fov: expected a number, found the string \"4 0\""},
      {"fov = nan",
       "scene.toml:4:7: camera.fov: expected a finite number within the range of a 32-bit float, "
       "found the number nan"},
      {"up = [0, inf, 0]",
       "scene.toml:4:10: camera.up: expected a finite number within the range of a 32-bit float, "
       "found the number inf"},
      {"up = [0, 1e39, 0]",
       "scene.toml:4:10: camera.up: expected a finite number within the range of a 32-bit float, "
       "found the number 1e+39"},
      {"up = [0, 1]",
       "scene.toml:4:6: camera.up: expected an array of 3 numbers, found an array "
       "of 2 values"},
      {"up = 1", "scene.toml:4:6: camera.up: expected an array of 3 numbers, found the integer 1"},
      {"up = [0, true, 0]", "scene.toml:4:10: camera.up: expected a number, found true"},
      {"film = 3",
       "scene.toml:4:1: unknown key 'camera.film'; the nearest known key is "
       "'camera.fov'"},
      {"[models]\nobj = 'x'",
       "scene.toml:4:1: models: expected an array of tables, [[models]], found a table"},
      {"[[film]]", "scene.toml:4:1: film: expected a table, [film], found an array of 1 value"},
      {"[materials]\nm = 1979-05-27",
       "scene.toml:5:5: materials.m: expected a table, found a date or time"},
  });
}

TEST(SceneFileErrors, CoverCameraAndMaterials) {
  const char* up = "up must be neither zero nor parallel to the view from origin to target";
  const char* fov = "camera.fov: must be an angle in degrees between 0 and 180, both excluded";
  SceneFolder scene;
  EXPECT_EQ(scene.error("[camera]\norigin = [1, 2, 3]\ntarget = [1, 2, 3]"),
            "scene.toml:3:10: camera.target: must differ from the origin");
  EXPECT_EQ(scene.error("[camera]\norigin = [0, 9, 0]\ntarget = [0, 1, 0]"),
            std::string("scene.toml:3:10: camera.target: ") + up);
  EXPECT_EQ(scene.error(kCamera + "up = [0, 0, 7]"),
            std::string("scene.toml:4:6: camera.up: ") + up);
  EXPECT_EQ(scene.error(kCamera + "up = [0, 0, 0]"),
            std::string("scene.toml:4:6: camera.up: ") + up);
  EXPECT_EQ(scene.error(kCamera + "fov = 0"), std::string("scene.toml:4:7: ") + fov);
  EXPECT_EQ(scene.error(kCamera + "fov = 180"), std::string("scene.toml:4:7: ") + fov);
  expect_errors({
      {"[render]\nlight_sampling = 'solid-angel'",
       "scene.toml:5:18: render.light_sampling: 'solid-angel' is not one of: area, solid-angle, "
       "line; the nearest is 'solid-angle'"},
      {"[materials.m]\ntype = 'difuse'",
       "scene.toml:5:8: materials.m.type: 'difuse' is not one of: diffuse, ggx; the nearest is "
       "'diffuse'"},
      {"[materials.m]\ntype = 'ggx'\nfresnel = 'shlick'",
       "scene.toml:6:11: materials.m.fresnel: 'shlick' is not one of: none, schlick; the nearest "
       "is 'schlick'"},
      {"[materials.m]\ntype = 'diffuse'\nreflectance = [0, 1.01, 0]",
       "scene.toml:6:15: materials.m.reflectance: each component must be in [0,1]"},
      {"[materials.m]\ntype = 'diffuse'\nreflectance = -1",
       "scene.toml:6:15: materials.m.reflectance: each component must be in [0,1]"},
      {"[materials.m]\ntype = 'diffuse'\nroughness = 1",
       "scene.toml:6:13: materials.m.roughness: needs type = \"ggx\""},
      {"[materials.m]\ntype = 'ggx'\nroughness = 0",
       "scene.toml:6:13: materials.m.roughness: must be in (0,1]"},
      {"[materials.m]\ntype = 'ggx'\nroughness = -1",
       "scene.toml:6:13: materials.m.roughness: must be in (0,1]"},
      {"[materials.m]\ntype = 'ggx'\nroughness = 1.5",
       "scene.toml:6:13: materials.m.roughness: must be in (0,1]"},
      {"[materials.m]\ntype = 'ggx'\nemission = [0, -1, 0]",
       "scene.toml:6:12: materials.m.emission: no component may be negative"},
  });
}

TEST(SceneFileErrors, CoverSpheresAndModels) {
  expect_errors({
      {"[materials.metal]\ntype = 'ggx'\n[[spheres]]\ncenter = [0, 0, 0]\nradius = 0\n"
       "material = 'metal'",
       "scene.toml:8:10: spheres.radius: must be positive"},
      {"[materials.metal]\ntype = 'ggx'\n[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\n"
       "material = 'petal'",
       "scene.toml:9:12: spheres.material: [materials.petal] is not defined; the nearest is "
       "[materials.metal]"},
      {"[[spheres]]\ncenter = [0, 0, 0]\nradius = 1\nmaterial = 'petal'",
       "scene.toml:7:12: spheres.material: [materials.petal] is not defined"},
      {"[materials.lamp]\ntype = 'diffuse'\nemission = [0, 1, 0]\n[[spheres]]\n"
       "center = [0, 0, 0]\nradius = 1\nmaterial = 'lamp'",
       "scene.toml:10:12: spheres.material: a sphere must not emit; lights are polygons"},
      {"[[models]]\nobj = 'x.obj'\nscale = [1, 0, 1]",
       "scene.toml:6:9: models.scale: no component may be zero"},
      {"[[models]]\nobj = 'x.obj'\nscale = 'big'",
       "scene.toml:6:9: models.scale: expected a number or an array of 3 numbers, found the string "
       "\"big\""},
  });
}

TEST(SceneFileErrors, LocateSyntaxErrors) {
  SceneFolder scene;
  const auto starts_with = [&](const std::string& text, const std::string& start) {
    const std::string error = scene.error(text);
    EXPECT_EQ(error.substr(0, start.size()), start);
    EXPECT_EQ(error.find('\n'), std::string::npos);
  };
  starts_with("[camera\n", "scene.toml:1:8: ");
  starts_with("a = 1\na = 2\n", "scene.toml:2:");
  starts_with(kCamera + "fov = \n", "scene.toml:4:7: ");
  starts_with("a = \"\xff\"", "scene.toml:1:");
  // Columns count bytes: the three letters take two each.
  starts_with("\r\n\"\u00e4\u00f6\" = '\u00fc' x\n", "scene.toml:2:15: ");
  EXPECT_EQ(scene
                .error("camera = {origin = [0, 0, 1], target = [0, 0, 0], \"f\u00f6v\" = 1, "
                       "up = 0}")
                .substr(0, 36),
            "scene.toml:1:51: unknown key 'camera");
  EXPECT_EQ(scene.error("camera = {origin = [0, 0, 1], target = \"\u00f6\", up = 0}"),
            "scene.toml:1:40: camera.target: expected an array of 3 numbers, found the string "
            "\"\u00f6\"");
  EXPECT_EQ(scene.error("camera = {target = \"\u00f6\", origin = 0}"),
            "scene.toml:1:35: camera.origin: expected an array of 3 numbers, found the integer 0");
}

TEST(SceneFileErrors, NameAMissingSceneFile) {
  LoadReport report;
  EXPECT_THROW(load_scene_file("/nowhere/scene.toml", {}, report), InputError);
}

}  // namespace
}  // namespace raytracing
