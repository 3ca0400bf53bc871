#include <gtest/gtest.h>

#include "io/parse_obj_text.h"
#include "raytracing/geometry/polygon_mesh.h"

namespace raytracing {
namespace {

TEST(ObjFaces, EveryFormOfCorner) {
  const std::string data = kSquare + "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 1 0 0\n";
  const Indices none(4, kNone);
  for (const std::string corners :
       {"1 2 3 4", "1/1 2/2 3/1 4/2", "1// 2// 3// 4//", "1/ 2/ 3/ 4/", "1/2/0 2/2/0 3/2/0 4/0/0",
        "-4 -3 -2 -1", "-4/-2 -3/-1 -2/0 -1", "+1 +2 +3 +4", "01 002 3 4"}) {
    const Parsed parsed = parse(data + "f " + corners + "\n");
    ASSERT_EQ(parsed.faces(), 1u) << corners;
    EXPECT_EQ(parsed.vertices(0), kQuad) << corners;
    EXPECT_EQ(parsed.normals(0), none) << corners;
    EXPECT_EQ(parsed.told(), "ignored texture coordinate x2 at 5:1") << corners;
  }
  for (const std::string corners :
       {"1//1 2//2 3//1 4//2", "1/1/1 2/2/2 3/0/1 4/1/2", "-4//-2 -3//-1 -2/-1/-2 -1//+2"}) {
    const Parsed parsed = parse(data + "f " + corners + "\n");
    EXPECT_EQ(parsed.vertices(0), kQuad) << corners;
    EXPECT_EQ(parsed.normals(0), (Indices{0, 1, 0, 1})) << corners;
  }
  EXPECT_EQ(parse(data + "f 1//1 2 3/1 4//2").normals(0), (Indices{0, kNone, kNone, 1}));
}

TEST(ObjFaces, NegativeIndicesCountFromWhereTheyStand) {
  const Parsed parsed =
      parse(kSquare + "f -4 -3 -2\n" + "v 0 0 1\nv 1 0 1\nv 1 1 1\n" + "f -3 -2 -1\n");
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(1), (Indices{4, 5, 6}));
}

TEST(ObjFaces, IndicesOutOfRangeAreRefused) {
  EXPECT_EQ(error_of(kSquare + "f 1 2 0"),
            "x.obj:5:7: vertex index 0 is invalid; the first vertex has index 1");
  EXPECT_EQ(error_of(kSquare + "f 1 2 5"),
            "x.obj:5:7: vertex index 5 is out of range; the file has 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 -5"),
            "x.obj:5:7: vertex index -5 is out of range; only 4 precede it");
  EXPECT_EQ(error_of(kSquare + "f 1 2 99999999999999999999999"),
            "x.obj:5:7: vertex index 9999999999999 is out of range; the file has 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 4294967296 3"),
            "x.obj:5:7: vertex index 4294967296 is out of range; the file has 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 4294967295\nf 0"),
            "x.obj:6:3: vertex index 0 is invalid; the first vertex has index 1");
  EXPECT_EQ(error_of(kSquare + "f 1 2/1 3"),
            "x.obj:5:7: texture coordinate index 1 is out of range; the file has 0");
  EXPECT_EQ(error_of(kSquare + "vt 0 0\nf 1 2/-2 3"),
            "x.obj:6:7: texture coordinate index -2 is out of range; only 1 precede it");
  EXPECT_EQ(error_of(kSquare + "f 1 2//1 3"),
            "x.obj:5:8: normal index 1 is out of range; the file has 0");
  EXPECT_EQ(error_of(kSquare + "vn 0 0 1\nf 1 2//-2 3"),
            "x.obj:6:8: normal index -2 is out of range; only 1 precede it");
}

TEST(ObjFaces, BadCornersAreRefused) {
  EXPECT_EQ(error_of(kSquare + "f 1 x 3"), "x.obj:5:5: expected a vertex index, found 'x'");
  EXPECT_EQ(error_of(kSquare + "f 1 2.5 3"), "x.obj:5:6: unexpected '.5' in a face corner");
  EXPECT_EQ(error_of(kSquare + "f 1 /2 3"), "x.obj:5:5: expected a vertex index, found '/2'");
  EXPECT_EQ(error_of(kSquare + "f 1/x 2 3"),
            "x.obj:5:5: expected a texture coordinate index, found 'x'");
  EXPECT_EQ(error_of(kSquare + "f 1//x 2 3"), "x.obj:5:6: expected a normal index, found 'x'");
  EXPECT_EQ(error_of(kSquare + "vt 0\nvn 0 0 1\nf 1/1/1/1 2 3"),
            "x.obj:7:8: unexpected '/1' in a face corner");
  EXPECT_EQ(error_of(kSquare + "f 1,2,3"), "x.obj:5:4: unexpected ',2,3' in a face corner");
  EXPECT_EQ(error_of(kSquare + "f 1 2 - 3"), "x.obj:5:7: expected a vertex index, found '-'");
}

TEST(ObjFaces, FacesMayStandBeforeTheirVertices) {
  const Parsed parsed = parse("f 1//1 2//1 3//2\nf 1 1 2 3\nf 1 2 2\n" + kSquare +
                              "vn 0 0 1\nvn 0 0 0\n" + "f 1 2 5\nf 1 3 4\nv 2 0 0\n");
  ASSERT_EQ(parsed.faces(), 3u);
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.normals(0), (Indices{0, 0, kNone}));
  EXPECT_EQ(parsed.vertices(1), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(2), (Indices{0, 2, 3}));
  EXPECT_EQ(parsed.told(),
            "repaired face with a repeated corner x1 at 2:1; "
            "dropped face with fewer than 3 different corners x1 at 3:1; "
            "repaired normal of length zero x1 at 9:1; dropped face without area x1 at 10:1");
}

TEST(ObjFaces, FirstBadForwardIndexIsNamed) {
  EXPECT_EQ(error_of("f 1 2 3\nf 1 2 4\nf 1 6 7\nf 1 9 9\n" + kSquare),
            "x.obj:3:5: vertex index 6 is out of range; the file has 4");
}

TEST(ObjFaces, RepeatedCornersAreRepaired) {
  const std::string faces = "f 1 1 2 3\nf 1 2 2 3 3 3 4\nf 1 2 3 1\nf 1 1 2 3 3 1 1\n";
  const Parsed parsed = parse(kSquare + faces);
  ASSERT_EQ(parsed.faces(), 4u);
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(1), kQuad);
  EXPECT_EQ(parsed.vertices(2), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(3), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.told(), "repaired face with a repeated corner x4 at 5:1");
}

TEST(ObjFaces, FacesThatCannotShowAreDropped) {
  const Parsed parsed = parse(
      kSquare + "v .5 0 0\nv 0 0 0\nf 1 1 2\nf 1 2 5\nf 1 2 6\nf 1 2 1 2\nf 2 2 2\nf 1 2 3\n");
  ASSERT_EQ(parsed.faces(), 1u);
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.mesh().corners.size(), 3u);
  EXPECT_EQ(parsed.told(),
            "dropped face with fewer than 3 different corners x2 at 7:1; "
            "dropped face without area x3 at 8:1");
}

TEST(ObjFaces, VerticesMetTwiceApartStay) {
  const std::string hole = "v .2 .2 0\nv .2 .4 0\nv .4 .4 0\n";
  const Parsed parsed = parse(kSquare + hole + "f 1 2 3 4 1 5 6 7 5\n");
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2, 3, 0, 4, 5, 6, 4}));
  EXPECT_EQ(parsed.told(), "");
}

TEST(ObjFaces, NormalsOfLengthZeroCountAsAbsent) {
  const Parsed parsed =
      parse(kSquare + "vn 0 0 0\nvn 0 0 2\nvn -0 0 1e-60\nf 1//1 2//2 3//3 4//2\n");
  EXPECT_EQ(parsed.normals(0), (Indices{kNone, 1, kNone, 1}));
  EXPECT_EQ(parsed.told(), "repaired normal of length zero x2 at 5:1");
}

TEST(ObjFaces, NormalsCanBeNormalized) {
  const Parsed parsed = parse("vn 1e-30 0 0\nvn 0 -1e30 1e30\nvn 1e-45 1e-45 0\n");
  for (const Vec3& normal : parsed.mesh().normals) EXPECT_NEAR(length(normalize(normal)), 1, 1e-6);
}

TEST(ObjFaces, ConcavePolygonsStayWhole) {
  const Parsed parsed = parse("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n");
  ASSERT_EQ(parsed.faces(), 1u);
  double area = 0;
  const auto& p = parsed.mesh().positions;
  for (const auto& t : triangulate(p))
    area += length(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
  EXPECT_NEAR(area, 4, 1e-6);
}

TEST(ObjFaces, ArraysAreAllocatedAtTheirSize) {
  std::string text;
  for (int i = 0; i < 3000; ++i)
    text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\nvn 0 0 1\n";
  for (int i = 1; i < 2900; ++i) {
    const std::string n = std::to_string(i);
    text += "f " + n + "//" + n + " " + std::to_string(i + 1) + "//1 " + std::to_string(i + 50) +
            "//1\n";
  }
  const PolygonMesh mesh = parse(text).model.mesh;
  EXPECT_LE(mesh.positions.capacity(), mesh.positions.size() + mesh.positions.size() / 50);
  EXPECT_LE(mesh.normals.capacity(), mesh.normals.size() + mesh.normals.size() / 50);
  EXPECT_LE(mesh.faces.capacity(), mesh.faces.size() + mesh.faces.size() / 50);
  EXPECT_LE(mesh.corners.capacity(), mesh.corners.size() + mesh.corners.size() / 50);
}

}  // namespace
}  // namespace raytracing
