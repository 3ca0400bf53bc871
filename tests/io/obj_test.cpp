#include "raytracing/io/obj.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>

#include "raytracing/geometry/triangulate.h"

namespace raytracing {
namespace {

using Severity = LoadReport::Severity;
using namespace std::string_literals;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

struct Parsed {
  ObjModel model;
  LoadReport report;

  const PolygonMesh& mesh() const { return model.mesh; }
  std::size_t faces() const { return model.mesh.faces.size(); }
  /// "severity kind xcount at line:column; ..." of all that was counted.
  std::string told() const {
    std::string text;
    for (const LoadReport::Entry& e : report.entries()) {
      if (!text.empty()) text += "; ";
      text += to_string(e.severity) + " "s + e.kind + " x" + std::to_string(e.count) + " at " +
              std::to_string(e.first.line) + ":" + std::to_string(e.first.column);
    }
    return text;
  }
  /// Vertices of a face, from 0.
  std::vector<std::uint32_t> vertices(std::size_t face) const {
    std::vector<std::uint32_t> result;
    const auto& f = mesh().faces.at(face);
    for (std::uint32_t i = 0; i < f.corner_count; ++i) {
      result.push_back(mesh().corners.at(f.first_corner + i).position);
    }
    return result;
  }
  std::vector<std::uint32_t> normals(std::size_t face) const {
    std::vector<std::uint32_t> result;
    const auto& f = mesh().faces.at(face);
    for (std::uint32_t i = 0; i < f.corner_count; ++i) {
      result.push_back(mesh().corners.at(f.first_corner + i).normal);
    }
    return result;
  }
  std::string material(std::size_t face) const {
    return model.materials.at(mesh().faces.at(face).material).name;
  }
};

Parsed parse(const std::string& text) {
  Parsed parsed;
  parsed.model = parse_obj(text, "x.obj", parsed.report);
  return parsed;
}

std::string error_of(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find_first_of("\r\n"), std::string::npos) << "more than one line";
    return what;
  }
  return "no error";
}

using Indices = std::vector<std::uint32_t>;
const Indices kQuad{0, 1, 2, 3};

TEST(Obj, EmptyFiles) {
  for (const std::string text : {"", "\n", "# only\n", "\xef\xbb\xbf", "  ", "\\\n", "\r", "\\"}) {
    const Parsed parsed = parse(text);
    EXPECT_EQ(parsed.faces(), 0u);
    EXPECT_TRUE(parsed.model.materials.empty());
  }
}

TEST(Obj, EveryFormOfCorner) {
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
  for (const std::string corners : {"1//1 2//2 3//1 4//2", "1/1/1 2/2/2 3/0/1 4/1/2",
                                    "-4//-2 -3//-1 -2/-1/-2 -1//+2"}) {
    const Parsed parsed = parse(data + "f " + corners + "\n");
    EXPECT_EQ(parsed.vertices(0), kQuad) << corners;
    EXPECT_EQ(parsed.normals(0), (Indices{0, 1, 0, 1})) << corners;
  }
  EXPECT_EQ(parse(data + "f 1//1 2 3/1 4//2").normals(0), (Indices{0, kNone, kNone, 1}));
}

TEST(Obj, NegativeIndicesCountFromWhereTheyStand) {
  const Parsed parsed = parse(kSquare + "f -4 -3 -2\n" + "v 0 0 1\nv 1 0 1\nv 1 1 1\n" + "f -3 -2 -1\n");
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(1), (Indices{4, 5, 6}));
}

TEST(Obj, LineEndsTabsAndMissingFinalNewline) {
  const std::string lines = "v 0 0 0|v 1 0 0|v 1 1 0|v 0 1 0|f 1 2 3 4";
  for (const std::string& end : {"\n"s, "\r\n"s, "\r"s, " \t\n"s, "\n\n\r\r\n"s, "# note\n"s, " # note\r"s}) {
    std::string text;
    for (const char c : lines) text += c == '|' ? end : std::string(1, c);
    for (const std::string& final_end : {""s, end}) {
      const Parsed parsed = parse(text + final_end);
      ASSERT_EQ(parsed.faces(), 1u) << testing::PrintToString(end);
      EXPECT_EQ(parsed.vertices(0), kQuad);
      EXPECT_EQ(parsed.told(), "");
    }
  }
  std::string tabs = kSquare + "f 1 2 3 4";
  for (char& c : tabs) c = c == ' ' ? '\t' : c;
  EXPECT_EQ(parse(tabs).vertices(0), kQuad);
  EXPECT_EQ(parse("  v 0 0 0\n\t v 1 0 0\n v\t1  1 \t 0\n f 1 2\t3 ").faces(), 1u);
}

TEST(Obj, ByteOrderMarkDoesNotCostTheFirstVertex) {
  const Parsed parsed = parse("\xef\xbb\xbf" + kSquare + "f 1 2 3 4\n");
  EXPECT_EQ(parsed.vertices(0), kQuad);
  EXPECT_EQ(parsed.told(), "");
  EXPECT_EQ(error_of("\xef\xbb\xbfv 0 x 0"), "x.obj:1:5: expected y, found 'x'");
  EXPECT_EQ(error_of("\xff\xfev\0 \0"s), "x.obj:1:1: UTF-16 text is not supported");
}

TEST(Obj, CommentsAfterData) {
  EXPECT_EQ(parse(kSquare + "f 1 2 3 # note").vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parse(kSquare + "f 1 2 3#note\n# f 1 2 4\n#\n").faces(), 1u);
  EXPECT_EQ(parse("v 0 0 0 # note 1 2 3\n").told(), "");
  // A path in a comment must not swallow the next line.
  EXPECT_EQ(parse("# C:\\models\\\n" + kSquare).mesh().positions.size(), 4u);
}

TEST(Obj, ContinuedLines) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const std::string text = kSquare + "f 1 2 \\" + end + "3 \\" + end + "\\" + end + " 4\nf 1 2 3\\" + end + "\n";
    const Parsed parsed = parse(text);
    ASSERT_EQ(parsed.faces(), 2u);
    EXPECT_EQ(parsed.vertices(0), kQuad);
    EXPECT_EQ(error_of(kSquare + "f 1 2 \\" + end + " 3 9\n"),
              "x.obj:6:4: vertex index 9 is out of range; the file has 4");
  }
  EXPECT_EQ(parse("v 0 \\\n0 \\\n0\nl 1 \\\nv 1\n").told(), "ignored line x1 at 4:1");
  EXPECT_EQ(parse("usemtl a \\\nb\n" + kSquare + "f 1 2 3").material(0), "a  b");
  EXPECT_EQ(parse(kSquare + "f 1 2 3\\").faces(), 1u);
}

TEST(Obj, NumberForms) {
  const Parsed parsed = parse("v +2 .5 1.E-1\nv -1. -.25e+1 1e2\nv 1E-50 -0 00012.5\nv 5. 0.0e99999 1e-46\n");
  const auto& p = parsed.mesh().positions;
  EXPECT_EQ(p[0], Vec3(2.0f, 0.5f, 0.1f));
  EXPECT_EQ(p[1], Vec3(-1.0f, -2.5f, 100.0f));
  EXPECT_EQ(p[2], Vec3(0.0f, 0.0f, 12.5f));
  EXPECT_EQ(p[3], Vec3(5.0f, 0.0f, 0.0f));
  const std::string zeros(400, '0');
  EXPECT_EQ(parse("v 0." + zeros + "1 " + zeros + "3 1" + zeros + "e-400").mesh().positions[0],
            Vec3(0.0f, 3.0f, 1.0f));
  EXPECT_EQ(parse("v 1e-40 -1e-44 1.17549435e-38").mesh().positions[0],
            Vec3(1e-40f, -1e-44f, 1.17549435e-38f));
  EXPECT_EQ(parse("v 3.4028235e38 -3.4028235e38 3.40282350000000000000001e38").mesh().positions[0],
            Vec3(3.4028235e38f, -3.4028235e38f, 3.4028235e38f));
}

// Every number must be the float nearest to the decimal, also midway between two floats.
TEST(Obj, NumbersAreRoundedCorrectly) {
  std::mt19937_64 random(9);
  std::vector<std::string> words = {"16777217", "16777219", "16777217.0000000000000000001",
                                    "0.5000000298023223876953125", "9007199254740993",
                                    "1.00000017881393432617187499", "1.00000017881393432617187501"};
  for (int i = 0; i < 30000; ++i) {
    char digits[64];
    const auto bits = static_cast<std::uint32_t>(random());
    const float value = std::bit_cast<float>(bits);
    if (!std::isfinite(value)) continue;
    const auto midway = static_cast<double>(value) * (1 + 0x1p-24);
    words.emplace_back(digits, std::to_chars(digits, digits + 64, value).ptr);
    words.emplace_back(digits, std::to_chars(digits, digits + 64, midway).ptr);
    const auto fraction = static_cast<double>(random() % 2'000'000'000) / 1e6 - 1000;
    words.emplace_back(digits, std::to_chars(digits, digits + 64, fraction, std::chars_format::fixed, 6).ptr);
    const auto integer = static_cast<long>((random() >> 38) * 2 + 1) << (random() % 30);
    words.emplace_back(digits, std::to_chars(digits, digits + 64, integer).ptr);
  }
  for (const std::string& word : words) {
    float expected = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), expected);
    if (result.ec != std::errc()) continue;
    const float found = parse("v " + word + " 0 0").mesh().positions[0].x;
    EXPECT_EQ(std::bit_cast<std::uint32_t>(found), std::bit_cast<std::uint32_t>(expected)) << word;
  }
}

TEST(Obj, BadNumbersAreRefusedWithTheirPlace) {
  EXPECT_EQ(error_of("v 0 1,5 0"),
            "x.obj:1:5: expected y, found '1,5'; decimals are written with a point");
  EXPECT_EQ(error_of("\nv nan 0 0"), "x.obj:2:3: expected x, found 'nan'");
  EXPECT_EQ(error_of("v 0 0 -inf"), "x.obj:1:7: expected z, found '-inf'");
  EXPECT_EQ(error_of("v 1e39 0 0"), "x.obj:1:3: expected x, found '1e39', too large for a float");
  EXPECT_EQ(error_of("v 0 0 -3.5e38"),
            "x.obj:1:7: expected z, found '-3.5e38', too large for a float");
  EXPECT_EQ(error_of("v 1" + std::string(60, '0') + " 0 0"),
            "x.obj:1:3: expected x, found '1" + std::string(39, '0') + "...', too large for a float");
  EXPECT_EQ(error_of("v 1e999999999999999999999 0 0"),
            "x.obj:1:3: expected x, found '1e999999999999999999999', too large for a float");
  for (const std::string word : {"1x", "0x10", "1.2.3", "1e", "1e+", "+-1", "--1", ".", "-", "e5",
                                 "1\\", "1d5", "infinity", "1f"}) {
    EXPECT_EQ(error_of("v 0 0 0\r\n v 0  " + word + " 0"), "x.obj:2:7: expected y, found '" + word + "'");
  }
  EXPECT_EQ(error_of("v 0 0 \x01\xc3"), "x.obj:1:7: expected z, found '\\x01\\xc3'");
  EXPECT_EQ(error_of("vn 0 0 NaN"), "x.obj:1:8: expected z, found 'NaN'");
}

TEST(Obj, TruncatedRecordsAreRefused) {
  EXPECT_EQ(error_of("v 1 2"), "x.obj:1:6: truncated record: expected z");
  EXPECT_EQ(error_of("v\n1 2 3"), "x.obj:1:2: truncated record: expected x");
  EXPECT_EQ(error_of("v 1 2 # 3"), "x.obj:1:7: truncated record: expected z");
  EXPECT_EQ(error_of("vn 1\r\nv 0 0 0"), "x.obj:1:5: truncated record: expected y");
  EXPECT_EQ(error_of(kSquare + "f 1 2 \nv 0 0 0"),
            "x.obj:5:7: truncated record: a face needs at least 3 corners, found 2");
  EXPECT_EQ(error_of("f"), "x.obj:1:2: truncated record: a face needs at least 3 corners, found 0");
  EXPECT_EQ(error_of("v 1 2 3 4 5"), "x.obj:1:12: truncated record: expected blue");
}

TEST(Obj, TrailingTextIsRefused) {
  EXPECT_EQ(error_of("vn 1 2 3 4"), "x.obj:1:10: unexpected '4' at the end of the record");
  EXPECT_EQ(error_of("v 1 2 3 x"), "x.obj:1:9: expected a vertex weight or colour, found 'x'");
  EXPECT_EQ(error_of("v 1 2 3 1 1 1 1 1"), "x.obj:1:17: unexpected '1' at the end of the record");
}

TEST(Obj, WeightsAndColoursAreCounted) {
  const Parsed parsed = parse("v 0 0 0 1\nv 1 2 3 1.0\nv 4 5 6 2\nv 1 0 0 .1 .2 .3\nv 7 8 9 0 0 0 1\n");
  EXPECT_EQ(parsed.told(), "ignored vertex weight x1 at 3:1; ignored vertex colour x2 at 4:1");
  EXPECT_EQ(parsed.mesh().positions[2], Vec3(4, 5, 6));
  EXPECT_EQ(parsed.mesh().positions[4], Vec3(7, 8, 9));
}

TEST(Obj, WhatIsOfNoUseIsCounted) {
  const Parsed parsed = parse(
      "g\no\ns off\ng a b\ns 1\nvp 0 1\nvt 0\nvt 0 1\nl 1 2\np 1\nl 1 2\ncurv 0 1\nfoo\ncurv\nV 1 2 3\n");
  EXPECT_EQ(parsed.told(),
            "ignored parameter-space vertex x1 at 6:1; ignored texture coordinate x2 at 7:1; "
            "ignored line x2 at 9:1; ignored point x1 at 10:1; "
            "ignored unknown keyword 'curv' x2 at 12:1; ignored unknown keyword 'foo' x1 at 13:1; "
            "ignored unknown keyword 'V' x1 at 15:1");
}

TEST(Obj, UnknownKeywordsDoNotFillTheReport) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "key" + std::to_string(i) + " 1\n";
  const Parsed parsed = parse(text + "key3\n" + std::string(100, 'x') + "\n");
  ASSERT_EQ(parsed.report.entries().size(), 21u);
  EXPECT_EQ(parsed.report.entries()[3].count, 2u);
  EXPECT_EQ(parsed.report.entries()[20].kind, "other unknown keyword");
  EXPECT_EQ(parsed.report.entries()[20].count, 981u);
  EXPECT_EQ(parse("\x07\xff x").told(), "ignored unknown keyword '\\x07\\xff' x1 at 1:1");
}

TEST(Obj, IndicesOutOfRangeAreRefused) {
  EXPECT_EQ(error_of(kSquare + "f 1 2 0"), "x.obj:5:7: vertex index 0; the first vertex is number 1");
  EXPECT_EQ(error_of(kSquare + "f 1 2 5"), "x.obj:5:7: vertex index 5 is out of range; the file has 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 -5"),
            "x.obj:5:7: vertex index -5 is out of range; 4 stand before it");
  EXPECT_EQ(error_of(kSquare + "f 1 2 99999999999999999999999"),
            "x.obj:5:7: vertex index 9999999999999 is out of range; the file has 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 4294967296 3"),
            "x.obj:5:7: vertex index 4294967296 is out of range; the file has 4");
  EXPECT_EQ(error_of(kSquare + "f 1 2 4294967295\nf 0"),
            "x.obj:6:3: vertex index 0; the first vertex is number 1");
  EXPECT_EQ(error_of(kSquare + "f 1 2/1 3"),
            "x.obj:5:7: texture coordinate index 1 is out of range; the file has 0");
  EXPECT_EQ(error_of(kSquare + "vt 0 0\nf 1 2/-2 3"),
            "x.obj:6:7: texture coordinate index -2 is out of range; 1 stand before it");
  EXPECT_EQ(error_of(kSquare + "f 1 2//1 3"),
            "x.obj:5:8: normal index 1 is out of range; the file has 0");
  EXPECT_EQ(error_of(kSquare + "vn 0 0 1\nf 1 2//-2 3"),
            "x.obj:6:8: normal index -2 is out of range; 1 stand before it");
}

TEST(Obj, BadCornersAreRefused) {
  EXPECT_EQ(error_of(kSquare + "f 1 x 3"), "x.obj:5:5: expected a vertex index, found 'x'");
  EXPECT_EQ(error_of(kSquare + "f 1 2.5 3"), "x.obj:5:6: unexpected '.5' in a face corner");
  EXPECT_EQ(error_of(kSquare + "f 1 /2 3"), "x.obj:5:5: expected a vertex index, found '/2'");
  EXPECT_EQ(error_of(kSquare + "f 1/x 2 3"), "x.obj:5:5: expected a texture coordinate index, found 'x'");
  EXPECT_EQ(error_of(kSquare + "f 1//x 2 3"), "x.obj:5:6: expected a normal index, found 'x'");
  EXPECT_EQ(error_of(kSquare + "vt 0\nvn 0 0 1\nf 1/1/1/1 2 3"), "x.obj:7:8: unexpected '/1' in a face corner");
  EXPECT_EQ(error_of(kSquare + "f 1,2,3"), "x.obj:5:4: unexpected ',2,3' in a face corner");
  EXPECT_EQ(error_of(kSquare + "f 1 2 - 3"), "x.obj:5:7: expected a vertex index, found '-'");
}

TEST(Obj, FacesMayStandBeforeTheirVertices) {
  const Parsed parsed = parse("f 1//1 2//1 3//2\nf 1 1 2 3\nf 1 2 2\n" + kSquare + "vn 0 0 1\nvn 0 0 0\n" +
                              "f 1 2 5\nf 1 3 4\nv 2 0 0\n");
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

TEST(Obj, FirstBadForwardIndexIsNamed) {
  EXPECT_EQ(error_of("f 1 2 3\nf 1 2 4\nf 1 6 7\nf 1 9 9\n" + kSquare),
            "x.obj:3:5: vertex index 6 is out of range; the file has 4");
}

TEST(Obj, RepeatedCornersAreRepaired) {
  const std::string faces = "f 1 1 2 3\nf 1 2 2 3 3 3 4\nf 1 2 3 1\nf 1 1 2 3 3 1 1\n";
  const Parsed parsed = parse(kSquare + faces);
  ASSERT_EQ(parsed.faces(), 4u);
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(1), kQuad);
  EXPECT_EQ(parsed.vertices(2), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.vertices(3), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.told(), "repaired face with a repeated corner x4 at 5:1");
}

TEST(Obj, FacesThatCannotShowAreDropped) {
  const Parsed parsed = parse(kSquare + "v .5 0 0\nv 0 0 0\nf 1 1 2\nf 1 2 5\nf 1 2 6\nf 1 2 1 2\nf 2 2 2\nf 1 2 3\n");
  ASSERT_EQ(parsed.faces(), 1u);
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2}));
  EXPECT_EQ(parsed.mesh().corners.size(), 3u);
  EXPECT_EQ(parsed.told(),
            "dropped face with fewer than 3 different corners x2 at 7:1; "
            "dropped face without area x3 at 8:1");
}

TEST(Obj, VerticesMetTwiceApartStay) {
  const std::string hole = "v .2 .2 0\nv .2 .4 0\nv .4 .4 0\n";
  const Parsed parsed = parse(kSquare + hole + "f 1 2 3 4 1 5 6 7 5\n");
  EXPECT_EQ(parsed.vertices(0), (Indices{0, 1, 2, 3, 0, 4, 5, 6, 4}));
  EXPECT_EQ(parsed.told(), "");
}

TEST(Obj, NormalsOfLengthZeroCountAsAbsent) {
  const Parsed parsed = parse(kSquare + "vn 0 0 0\nvn 0 0 2\nvn -0 0 1e-60\nf 1//1 2//2 3//3 4//2\n");
  EXPECT_EQ(parsed.normals(0), (Indices{kNone, 1, kNone, 1}));
  EXPECT_EQ(parsed.told(), "repaired normal of length zero x2 at 5:1");
}

TEST(Obj, NormalsCanBeNormalized) {
  const Parsed parsed = parse("vn 1e-30 0 0\nvn 0 -1e30 1e30\nvn 1e-45 1e-45 0\n");
  for (const Vec3& normal : parsed.mesh().normals) EXPECT_NEAR(length(normalize(normal)), 1, 1e-6);
}

TEST(Obj, ConcavePolygonsStayWhole) {
  const Parsed parsed = parse("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n");
  ASSERT_EQ(parsed.faces(), 1u);
  double area = 0;
  const auto& p = parsed.mesh().positions;
  for (const auto& t : triangulate(p)) area += length(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])) / 2;
  EXPECT_NEAR(area, 4, 1e-6);
}

TEST(Obj, Materials) {
  const Parsed parsed = parse(kSquare + "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl Dark  wood \t\nf 1 2 3\n" +
                              "g x\nusemtl red # again\nf 1 2 3\nusemtl Material #25\nf 1 2 3\nusemtl\nf 1 2 3\n");
  const std::vector<std::string> expected = {"", "red", "Dark  wood", "red", "Material #25", ""};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(parsed.material(i), expected[i]) << i;
  ASSERT_EQ(parsed.model.materials.size(), 4u);
  EXPECT_EQ(to_string(parsed.model.materials[0].where), "x.obj:5:1");
  EXPECT_EQ(to_string(parsed.model.materials[1].where), "x.obj:6:1");
  EXPECT_EQ(parsed.told(), "warning usemtl without a name x1 at 15:1");
}

TEST(Obj, Libraries) {
  const Parsed parsed = parse(
      "mtllib a.mtl\nmtllib  b.mtl\tc.MTL # two\r\nmtllib my colours.mtl\nmtllib d.mtl e\\\nf.mtl\nmtllib\n"
      "mtllib one.mtl \\\ntwo.mtl\n");
  std::string all;
  for (const auto& library : parsed.model.libraries) all += library.name + "@" + to_string(library.where) + "|";
  EXPECT_EQ(all,
            "a.mtl@x.obj:1:8|b.mtl@x.obj:2:9|c.MTL@x.obj:2:15|my colours.mtl@x.obj:3:8|"
            "d.mtl e f.mtl@x.obj:4:8|one.mtl@x.obj:7:8|two.mtl@x.obj:8:1|");
  EXPECT_EQ(parsed.told(), "warning mtllib without a name x1 at 6:1");
}

TEST(Obj, LinesOfAnyLength) {
  const std::string comment = "# " + std::string(200'000, 'c');
  std::string corners;
  std::string vertices;
  for (int i = 0; i < 20'000; ++i) {
    const double angle = i * 6.283185307 / 20'000;
    vertices += "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    corners += ' ';
    corners += std::to_string(i + 1);
  }
  const Parsed parsed = parse(comment + "\n" + vertices + comment + "\nf" + corners + comment + "\nf 1 5000 10000");
  ASSERT_EQ(parsed.faces(), 2u);
  EXPECT_GT(parsed.mesh().faces[0].corner_count, 19'000u);
  EXPECT_EQ(parse(std::string(200'000, 'k') + "\nv 0 0 0").mesh().positions.size(), 1u);
}

TEST(Obj, ArraysAreAllocatedAtTheirSize) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += "v " + std::to_string(i) + " " + std::to_string(i * i) + " 0\nvn 0 0 1\n";
  for (int i = 1; i < 2900; ++i) {
    const std::string n = std::to_string(i);
    text += "f " + n + "//" + n + " " + std::to_string(i + 1) + "//1 " + std::to_string(i + 50) + "//1\n";
  }
  const PolygonMesh mesh = parse(text).model.mesh;
  EXPECT_LE(mesh.positions.capacity(), mesh.positions.size() + mesh.positions.size() / 50);
  EXPECT_LE(mesh.normals.capacity(), mesh.normals.size() + mesh.normals.size() / 50);
  EXPECT_LE(mesh.faces.capacity(), mesh.faces.size() + mesh.faces.size() / 50);
  EXPECT_LE(mesh.corners.capacity(), mesh.corners.size() + mesh.corners.size() / 50);
}

TEST(Obj, MissingFile) {
  LoadReport report;
  EXPECT_THROW(load_obj("/nonexistent/x.obj", report), InputError);
}

// Whatever is done to a file, the parser returns a sound mesh or throws InputError.
TEST(Obj, SurvivesRandomDamage) {
  const std::string good = "\xef\xbb\xbf# note\nmtllib a b.mtl\n" + kSquare +
                           "vt 0 1\nvn 0 0 1\nvn 0 1 0\ng a\nusemtl red one\nf 1/1/1 2//2 -2 4 \\\r\n-4\r"
                           "f 1 2 3\nl 1 2\ncurv 1 2\nv 1.5e3 -.5 +2. 1 1 1\nf 5 1 2";
  const std::string bytes = "0123456789-+.eE/# \t\r\n\\vfn,\0\xff\xef"s;
  std::mt19937 random(17);
  const auto below = [&](std::size_t n) { return random() % n; };
  int refused = 0;
  const int rounds = 20000;
  for (int round = 0; round < rounds; ++round) {
    std::string text = good;
    for (std::size_t edits = 1 + below(6); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      switch (below(5)) {
        case 0: text[at] = bytes[below(bytes.size())]; break;
        case 1: text.insert(at, 1, bytes[below(bytes.size())]); break;
        case 2: text.erase(at, 1 + below(8)); break;
        case 3: text.insert(at, text.substr(below(text.size()), below(30))); break;
        default: text[at] = static_cast<char>(below(256)); break;
      }
    }
    if (below(10) == 0) text.resize(below(text.size() + 1));
    try {
      const Parsed parsed = parse(text);
      for (std::size_t i = 0; i < parsed.faces(); ++i) {
        ASSERT_GE(parsed.mesh().faces[i].corner_count, 3u);
        parsed.material(i);
        for (const auto v : parsed.vertices(i)) ASSERT_LT(v, parsed.mesh().positions.size());
        for (const auto n : parsed.normals(i)) ASSERT_TRUE(n == kNone || n < parsed.mesh().normals.size());
      }
    } catch (const InputError& error) {
      ++refused;
      EXPECT_TRUE(std::string(error.what()).starts_with("x.obj:")) << error.what();
    }
  }
  EXPECT_GT(refused, rounds / 10);
  EXPECT_LT(refused, rounds * 9 / 10);
}

}  // namespace
}  // namespace raytracing
