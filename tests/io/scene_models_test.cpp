// Models of scene files: their transforms, materials and errors.

#include <gtest/gtest.h>

#include "raytracing/geometry/polygon_mesh.h"
#include "support/scene_folder.h"

namespace raytracing {
namespace {

using Lines = std::vector<std::string>;

/// A triangle in the plane z = 0 whose normal is +z, by its winding and as stated.
const std::string kTriangle = "v 1 0 0\nv 0 1 0\nv 0 0 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";

const std::string kModel = kCamera + "[[models]]\nobj = 'm.obj'\n";

std::vector<Vec3> corners_of(const PolygonMesh& mesh, const PolygonMesh::Face& face) {
  std::vector<Vec3> corners;
  for (std::uint32_t i = 0; i < face.corner_count; ++i) {
    corners.push_back(mesh.positions[mesh.corners[face.first_corner + i].position]);
  }
  return corners;
}

Vec3 normal_by_winding(const PolygonMesh& mesh, const PolygonMesh::Face& face) {
  const std::vector<Vec3> c = corners_of(mesh, face);
  return normalize(cross(c[1] - c[0], c[2] - c[0]));
}

/// The surface of the only face of m.obj, with `mtl` as its material `a`.
Surface only_surface(SceneFolder& scene, const std::string& mtl) {
  scene.folder.write("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangle);
  scene.folder.write("m.mtl", "newmtl a\n" + mtl);
  const SceneFile file = scene.load(kModel);
  return file.scene.surfaces.at(file.scene.meshes.at(0).faces.at(0).material);
}

TEST(SceneTransform, ScalesThenRotatesThenTranslates) {
  SceneFolder scene;
  scene.folder.write("m.obj", kTriangle);
  // (1,0,0) -> scale (2,0,0) -> about x (2,0,0) -> about y (0,0,-2) -> about z (0,0,-2).
  // (0,1,0) -> scale (0,3,0) -> about x (0,0,3) -> about y (3,0,0) -> about z (0,3,0).
  const SceneFile file =
      scene.load(kModel + "scale = [2, 3, 4]\nrotate = [90, 90, 90]\ntranslate = [10, 20, 30]\n");
  const PolygonMesh& mesh = file.scene.meshes.at(0);
  EXPECT_EQ(mesh.positions[0], Vec3(10, 20, 28));
  EXPECT_EQ(mesh.positions[1], Vec3(10, 23, 30));
  EXPECT_EQ(mesh.positions[2], Vec3(10, 20, 30));
}

TEST(SceneTransform, TurnsRightHanded) {
  SceneFolder scene;
  scene.folder.write("m.obj", kTriangle);
  const SceneFile file = scene.load(kModel + "rotate = [0, 0, 30]\n");
  const PolygonMesh& mesh = file.scene.meshes.at(0);
  EXPECT_NEAR(length(mesh.positions[0] - Vec3(std::sqrt(0.75f), 0.5f, 0)), 0, 1e-7);
  EXPECT_NEAR(length(mesh.positions[1] - Vec3(-0.5f, std::sqrt(0.75f), 0)), 0, 1e-7);
}

TEST(SceneTransform, IsExactForMultiplesOfARightAngle) {
  SceneFolder scene;
  scene.folder.write("m.obj", "v 555.3 0.1 -7\nv 0 1 0\nv 0 0 0\nf 1 2 3\n");
  const auto turned = [&](const std::string& degrees) {
    return scene.load(kModel + "rotate = [0, 0, " + degrees + "]\n")
        .scene.meshes.at(0)
        .positions[0];
  };
  EXPECT_EQ(turned("0"), Vec3(555.3f, 0.1f, -7));
  EXPECT_EQ(turned("90"), Vec3(-0.1f, 555.3f, -7));
  EXPECT_EQ(turned("180"), Vec3(-555.3f, -0.1f, -7));
  EXPECT_EQ(turned("-90"), Vec3(0.1f, -555.3f, -7));
  EXPECT_EQ(turned("-720"), Vec3(555.3f, 0.1f, -7));
  EXPECT_EQ(turned("270"), turned("-90"));
}

TEST(SceneTransform, KeepsNormalsPerpendicular) {
  SceneFolder scene;
  scene.folder.write("m.obj", "v 1 0 0\nv 0 1 0\nv 0 0 1\nvn 2 2 2\nf 1//1 2//1 3//1\n");
  for (const char* transform :
       {"", "scale = [1, 2, 3]", "scale = [1, 2, 3]\nrotate = [10, 20, 30]", "scale = -2",
        "scale = [-1, 2, 3]\nrotate = [10, 20, 30]", "scale = [-1, -2, 3]"}) {
    const SceneFile file = scene.load(kModel + transform);
    const PolygonMesh& mesh = file.scene.meshes.at(0);
    ASSERT_EQ(mesh.normals.size(), 1u);
    // The winding and the normal still agree, mirrored or not: the emitting side is unchanged.
    EXPECT_NEAR(length(normal_by_winding(mesh, mesh.faces[0]) - mesh.normals[0]), 0, 1e-6)
        << transform;
  }
}

TEST(SceneTransform, MirrorsTheSideOfAFlatFace) {
  SceneFolder scene;
  scene.folder.write("m.obj", "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 2 3 4\n");
  const auto normal = [&](const std::string& scale) {
    const SceneFile file = scene.load(kModel + "scale = " + scale);
    return normal_by_winding(file.scene.meshes[0], file.scene.meshes[0].faces.at(0));
  };
  EXPECT_EQ(normal("[1, 1, 1]"), Vec3(0, 0, 1));
  EXPECT_EQ(normal("[-1, 1, 1]"), Vec3(0, 0, 1));
  EXPECT_EQ(normal("[1, -1, 1]"), Vec3(0, 0, 1));
  EXPECT_EQ(normal("[1, 1, -1]"), Vec3(0, 0, -1));
  EXPECT_EQ(normal("[-1, -1, 1]"), Vec3(0, 0, 1));
  EXPECT_EQ(normal("[-1, 1, -1]"), Vec3(0, 0, -1));
  EXPECT_EQ(normal("-1"), Vec3(0, 0, -1));
}

TEST(SceneTransform, RefusesOverflow) {
  SceneFolder scene;
  scene.folder.write("m.obj", "v 1e30 0 0\nv 0 1 0\nv 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(scene.error(kModel + "scale = 1e30"),
            "scene.toml:5:7: the transform moves vertices beyond the range of a float");
}

TEST(SceneMtl, MakesDiffuseSurfaces) {
  SceneFolder scene;
  const Surface surface =
      only_surface(scene, "Kd 0.1 0.2 0.3\nKe 0 5 0\nKs 0 0 0\nPm 0\nillum 2\n");
  EXPECT_EQ(surface.name, "a");
  EXPECT_EQ(std::get<Diffuse>(surface.material).reflectance, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_EQ(surface.Le, Rgb(0, 5, 0));
  EXPECT_EQ(scene.told(), Lines{});
}

TEST(SceneMtl, MakesConductors) {
  SceneFolder scene;
  const Surface surface = only_surface(scene, "Kd 0.9 0.8 0.7\nPm 1\nPr 0.5\nKs 1 1 1\nillum 3\n");
  const auto& ggx = std::get<GgxConductor>(surface.material);
  EXPECT_EQ(ggx.reflectance, Rgb(0.9f, 0.8f, 0.7f));
  EXPECT_EQ(ggx.alpha, 0.25f);
  EXPECT_EQ(ggx.fresnel, Fresnel::none);
  EXPECT_EQ(scene.told(), Lines{});
}

TEST(SceneMtl, TellsWhatItMakesUpAndLeavesOut) {
  SceneFolder scene;
  const Surface grey = only_surface(scene, "");
  EXPECT_EQ(std::get<Diffuse>(grey.material).reflectance, Rgb(0.5f));
  EXPECT_EQ(scene.told(), Lines{"warning material without Kd, 0.5 grey is used m.mtl:1 1"});
  const Surface metal = only_surface(scene, "Kd 1 1 1\nPm 1\n");
  EXPECT_EQ(std::get<GgxConductor>(metal.material).alpha, 0.25f);
  EXPECT_EQ(scene.told(), Lines{"repaired material with Pm but without Pr, 0.5 is used m.mtl:1 1"});
  only_surface(scene, "Kd 1 1 1\nKs 0.5 0 0\nPr 0.5\nd 0.5\nillum 7\n");
  EXPECT_EQ(scene.told(), (Lines{"ignored Ks (specular reflectance without Pm) m.mtl:1 1",
                                 "ignored Pr (roughness without Pm) m.mtl:1 1",
                                 "ignored d or Tr (transparency) m.mtl:1 1",
                                 "ignored illum (mirrors and glass) m.mtl:1 1"}));
}

TEST(SceneMtl, RefusesWhatIsNotModelled) {
  SceneFolder scene;
  const auto error = [&](const std::string& mtl) {
    try {
      only_surface(scene, mtl);
      return std::string();
    } catch (const InputError& caught) {
      return scene.without_folder(caught.what());
    }
  };
  EXPECT_EQ(error("Kd 1 1.01 1\n"),
            "m.mtl:1:1: material 'a': no component of Kd may exceed 1, or the surface would "
            "reflect more than it receives");
  EXPECT_EQ(error("Kd 1 1 1\nPm 0.5\n"),
            "m.mtl:1:1: material 'a': Pm is 0.5, but must be 0 or 1: blends of metal and non-metal "
            "are not supported");
  EXPECT_EQ(error("Kd 1 1 1\nPm 1\nPr 0\n"),
            "m.mtl:1:1: material 'a': Pr is 0, but a rough conductor needs a roughness in (0,1]");
  EXPECT_EQ(error("Kd 1 1 1\nPm 1\nPr 1.5\n").substr(0, 10), "m.mtl:1:1:");
}

TEST(SceneMaterials, FallBackToGrey) {
  SceneFolder scene;
  scene.folder.write("m.obj",
                     kTriangle + "mtllib none.mtl\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
  const SceneFile file = scene.load(kModel);
  EXPECT_EQ(scene.told(), (Lines{"repaired material library missing m.obj:6 1",
                                 "repaired material not defined m.obj:7 2"}));
  ASSERT_EQ(file.scene.meshes.at(0).faces.size(), 3u);
  for (const PolygonMesh::Face& face : file.scene.meshes[0].faces) {
    const Surface& surface = file.scene.surfaces.at(face.material);
    EXPECT_EQ(surface.name, "default");
    EXPECT_EQ(std::get<Diffuse>(surface.material).reflectance, Rgb(0.5f));
    EXPECT_EQ(surface.Le, Rgb(0.0f));
  }
}

TEST(SceneMaterials, OverrideEverythingOfTheModel) {
  SceneFolder scene;
  scene.folder.write("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangle + "usemtl b\nf 1 2 3\n");
  scene.folder.write("m.mtl", "newmtl a\nKd 7 7 7\nKe 9 9 9\n");  // an error if it were used
  const SceneFile file = scene.load(kModel + "material = 'x'\n[materials.x]\ntype = 'ggx'\n");
  ASSERT_EQ(file.scene.surfaces.size(), 1u);
  EXPECT_EQ(file.scene.surfaces[0].name, "x");
  for (const PolygonMesh::Face& face : file.scene.meshes.at(0).faces) EXPECT_EQ(face.material, 0u);
  EXPECT_EQ(file.assets, Lines{scene.folder / "m.obj"});
  EXPECT_EQ(scene.told(), Lines{});
}

TEST(SceneMaterials, BelongToTheirLibrary) {
  SceneFolder scene;
  scene.folder.write("one/m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangle);
  scene.folder.write("one/m.mtl", "newmtl a\nKd 0.1 0.1 0.1\n");
  scene.folder.write("two/m.obj", "mtllib ../one/n.mtl m.mtl\nusemtl a\n" + kTriangle);
  scene.folder.write("two/m.mtl", "newmtl a\nKd 0.2 0.2 0.2\n");
  scene.folder.write("two/n.obj", "mtllib ../one/m.mtl\nmtllib m.mtl\nusemtl a\n" + kTriangle);
  scene.folder.write("one/n.mtl", "newmtl b\nKd 1 1 1\n");
  const SceneFile file = scene.load(kCamera +
                                    "[[models]]\nobj = 'one/m.obj'\n[[models]]\nobj = 'two/m.obj'\n"
                                    "[[models]]\nobj = 'two/n.obj'\n[[models]]\nobj = 'one/m.obj'\n"
                                    "translate = [1, 0, 0]\n");
  ASSERT_EQ(file.scene.meshes.size(), 4u);
  const auto reflectance = [&](std::size_t mesh) {
    const Surface& surface = file.scene.surfaces.at(file.scene.meshes[mesh].faces[0].material);
    return std::get<Diffuse>(surface.material).reflectance.x;
  };
  EXPECT_EQ(reflectance(0), 0.1f);
  EXPECT_EQ(reflectance(1), 0.2f);
  EXPECT_EQ(reflectance(2), 0.1f);
  EXPECT_EQ(reflectance(3), 0.1f);
  EXPECT_EQ(file.scene.surfaces.size(), 2u);
  EXPECT_EQ(file.scene.meshes[3].positions[2], Vec3(1, 0, 0));
  // Each file is read once, when it is first needed.
  Lines assets;
  for (const std::string& path : file.assets) assets.push_back(scene.without_folder(path));
  EXPECT_EQ(assets,
            (Lines{"one/m.obj", "one/m.mtl", "two/m.obj", "one/n.mtl", "two/m.mtl", "two/n.obj"}));
}

TEST(SceneModels, LocateErrors) {
  SceneFolder scene;
  const std::string error = scene.error(kModel);
  EXPECT_EQ(error.substr(0, 22), "scene.toml:5:7: m.obj:");
  EXPECT_EQ(error.find('\n'), std::string::npos);
  scene.folder.write("m.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_EQ(scene.error(kModel).substr(0, 8), "m.obj:2:");
}

TEST(SceneHash, ChangesWithEveryFileAndOnlyThen) {
  SceneFolder scene;
  const auto hash = [&](char last_of_scene, char last_of_obj, char last_of_mtl) {
    scene.folder.write("m.obj", "mtllib m.mtl\nusemtl a\n" + kTriangle + "#" + last_of_obj);
    scene.folder.write("m.mtl", std::string("newmtl a\nKd 1 1 1\n#") + last_of_mtl);
    scene.folder.write("other.txt", std::string(1, last_of_mtl));
    return scene.load(kModel + "#" + last_of_scene).hash;
  };
  const std::uint64_t first = hash('x', 'x', 'x');
  EXPECT_EQ(hash('x', 'x', 'x'), first);
  EXPECT_NE(hash('y', 'x', 'x'), first);
  EXPECT_NE(hash('x', 'y', 'x'), first);
  EXPECT_NE(hash('x', 'x', 'y'), first);
  scene.folder.write("other.txt", "something else");
  EXPECT_EQ(hash('x', 'x', 'x'), first);

  const SceneFolder elsewhere;  // the folder's name does not count
  for (const char* name : {"m.obj", "m.mtl", "scene.toml"}) {
    std::filesystem::copy_file(scene.folder / name, elsewhere.folder / name);
  }
  LoadReport report;
  EXPECT_EQ(load_scene_file(elsewhere.folder / "scene.toml", {}, report).hash, first);
}

}  // namespace
}  // namespace raytracing
