#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/parse_obj_text.h"

namespace raytracing {
namespace {

using namespace std::string_literals;

TEST(Obj, EmptyFiles) {
  for (const std::string text : {"", "\n", "# only\n", "\xef\xbb\xbf", "  ", "\\\n", "\r", "\\"}) {
    const Parsed parsed = parse(text);
    EXPECT_EQ(parsed.faces(), 0u);
    EXPECT_TRUE(parsed.model.materials.empty());
  }
}

TEST(Obj, LineEndsTabsAndMissingFinalNewline) {
  const std::string lines = "v 0 0 0|v 1 0 0|v 1 1 0|v 0 1 0|f 1 2 3 4";
  for (const std::string& end :
       {"\n"s, "\r\n"s, "\r"s, " \t\n"s, "\n\n\r\r\n"s, "# note\n"s, " # note\r"s}) {
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
    const std::string text =
        kSquare + "f 1 2 \\" + end + "3 \\" + end + "\\" + end + " 4\nf 1 2 3\\" + end + "\n";
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

TEST(Obj, WeightsAndColoursAreCounted) {
  const Parsed parsed =
      parse("v 0 0 0 1\nv 1 2 3 1.0\nv 4 5 6 2\nv 1 0 0 .1 .2 .3\nv 7 8 9 0 0 0 1\n");
  EXPECT_EQ(parsed.told(), "ignored vertex weight x1 at 3:1; ignored vertex colour x2 at 4:1");
  EXPECT_EQ(parsed.mesh().positions[2], Vec3(4, 5, 6));
  EXPECT_EQ(parsed.mesh().positions[4], Vec3(7, 8, 9));
}

TEST(Obj, WhatIsOfNoUseIsCounted) {
  const Parsed parsed = parse(
      "g\no\ns off\ng a b\ns 1\nvp 0 1\nvt 0\nvt 0 1\nl 1 2\np 1\nl 1 2\ncurv 0 1\nfoo\ncurv\nV 1 "
      "2 3\n");
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

TEST(Obj, Materials) {
  const Parsed parsed =
      parse(kSquare + "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl Dark  wood \t\nf 1 2 3\n" +
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
      "mtllib a.mtl\nmtllib  b.mtl\tc.MTL # two\r\nmtllib my colours.mtl\nmtllib d.mtl "
      "e\\\nf.mtl\nmtllib\n"
      "mtllib one.mtl \\\ntwo.mtl\n");
  std::string all;
  for (const auto& library : parsed.model.libraries)
    all += library.name + "@" + to_string(library.where) + "|";
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
    vertices +=
        "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    corners += ' ';
    corners += std::to_string(i + 1);
  }
  const Parsed parsed =
      parse(comment + "\n" + vertices + comment + "\nf" + corners + comment + "\nf 1 5000 10000");
  ASSERT_EQ(parsed.faces(), 2u);
  EXPECT_GT(parsed.mesh().faces[0].corner_count, 19'000u);
  EXPECT_EQ(parse(std::string(200'000, 'k') + "\nv 0 0 0").mesh().positions.size(), 1u);
}

// For a damaged file, the parser returns a valid mesh or throws InputError.
TEST(Obj, SurvivesRandomDamage) {
  const std::string good =
      "\xef\xbb\xbf# note\nmtllib a b.mtl\n" + kSquare +
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
        case 0:
          text[at] = bytes[below(bytes.size())];
          break;
        case 1:
          text.insert(at, 1, bytes[below(bytes.size())]);
          break;
        case 2:
          text.erase(at, 1 + below(8));
          break;
        case 3:
          text.insert(at, text.substr(below(text.size()), below(30)));
          break;
        default:
          text[at] = static_cast<char>(below(256));
          break;
      }
    }
    if (below(10) == 0) text.resize(below(text.size() + 1));
    try {
      const Parsed parsed = parse(text);
      for (std::size_t i = 0; i < parsed.faces(); ++i) {
        ASSERT_GE(parsed.mesh().faces[i].corner_count, 3u);
        parsed.material(i);
        for (const auto v : parsed.vertices(i)) ASSERT_LT(v, parsed.mesh().positions.size());
        for (const auto n : parsed.normals(i))
          ASSERT_TRUE(n == kNone || n < parsed.mesh().normals.size());
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
