#include "raytracing/io/mtl.h"

#include <gtest/gtest.h>

#include <random>

#include "io/told.h"

namespace raytracing {
namespace {

using namespace std::string_literals;

struct Parsed {
  std::vector<MtlMaterial> materials;
  LoadReport report;

  std::string told() const { return raytracing::told(report); }
};

Parsed parse(const std::string& text) {
  Parsed parsed;
  parsed.materials = parse_mtl(text, "x.mtl", parsed.report);
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

TEST(Mtl, EmptyFiles) {
  for (const std::string text : {"", "\n\n", "# nothing", "\xef\xbb\xbf", "\r\n \t"}) {
    EXPECT_TRUE(parse(text).materials.empty());
  }
}

TEST(Mtl, EveryKey) {
  const Parsed parsed = parse(
      "newmtl red\nKd 1 0.5 .25\nKs +.1 0 1.E-1\nKe 17 12 4\nNs 96.5\nNi 1.45\nd 0.75\nillum 2\n"
      "Pr .3\nPm 1\n");
  ASSERT_EQ(parsed.materials.size(), 1u);
  const MtlMaterial& m = parsed.materials[0];
  EXPECT_EQ(m.name, "red");
  EXPECT_EQ(to_string(m.where), "x.mtl:1:1");
  EXPECT_EQ(m.Kd, Rgb(1, 0.5f, 0.25f));
  EXPECT_EQ(m.Ks, Rgb(0.1f, 0, 0.1f));
  EXPECT_EQ(m.Ke, Rgb(17, 12, 4));
  EXPECT_EQ(m.Ns, 96.5f);
  EXPECT_EQ(m.Ni, 1.45f);
  EXPECT_EQ(m.d, 0.75f);
  EXPECT_EQ(m.illum, 2);
  EXPECT_EQ(m.Pr, 0.3f);
  EXPECT_EQ(m.Pm, 1.0f);
  EXPECT_EQ(parsed.told(), "");
}

TEST(Mtl, AbsentKeysStayEmpty) {
  const MtlMaterial m = parse("newmtl bare").materials.at(0);
  EXPECT_FALSE(m.Kd || m.Ks || m.Ke || m.Ns || m.Ni || m.d || m.Pr || m.Pm || m.illum);
}

TEST(Mtl, OneNumberIsAGrey) {
  const MtlMaterial m = parse("newmtl a\nKd 0.5\nKs .25 # grey\nKe \\\n2\n").materials.at(0);
  EXPECT_EQ(m.Kd, Rgb(0.5f));
  EXPECT_EQ(m.Ks, Rgb(0.25f));
  EXPECT_EQ(m.Ke, Rgb(2));
  EXPECT_EQ(error_of("newmtl a\nKd 0.5 0.5\n"), "x.mtl:2:11: truncated record: expected a number");
  EXPECT_EQ(error_of("newmtl a\nKd\n"), "x.mtl:2:3: truncated record: expected a number");
  EXPECT_EQ(error_of("newmtl a\nKd 1 1 1 1\n"),
            "x.mtl:2:10: unexpected '1' at the end of the record");
}

TEST(Mtl, ColoursAboveOneAreTheCallersAffair) {
  const MtlMaterial m = parse("newmtl a\nKd 2 2 2\nKs 1.5\n").materials.at(0);
  EXPECT_EQ(m.Kd, Rgb(2));
  EXPECT_EQ(m.Ks, Rgb(1.5f));
}

TEST(Mtl, NegativeColoursAreRefused) {
  EXPECT_EQ(error_of("newmtl a\nKd 0 -0.1 0"), "x.mtl:2:6: Kd must not be negative");
  EXPECT_EQ(error_of("newmtl a\nKs -1"), "x.mtl:2:4: Ks must not be negative");
  EXPECT_EQ(error_of("newmtl a\n  Ke 0 0 -2"), "x.mtl:2:10: Ke must not be negative");
}

TEST(Mtl, SpectralColoursAreRefused) {
  EXPECT_EQ(error_of("newmtl a\nKd spectral file.rfl 1"),
            "x.mtl:2:4: Kd spectral is not supported; give r g b");
  EXPECT_EQ(error_of("newmtl a\nKs xyz .1 .2 .3"),
            "x.mtl:2:4: Ks xyz is not supported; give r g b");
}

TEST(Mtl, BadNumbersAreRefused) {
  EXPECT_EQ(error_of("newmtl a\nNs 1,5"),
            "x.mtl:2:4: expected a number, found '1,5'; use a point as the decimal mark");
  EXPECT_EQ(error_of("newmtl a\nKd nan"), "x.mtl:2:4: expected a number, found 'nan'");
  EXPECT_EQ(error_of("newmtl a\nKe 1e39"),
            "x.mtl:2:4: expected a number, found '1e39', too large for a float");
  EXPECT_EQ(error_of("newmtl a\nd 1 2"), "x.mtl:2:5: unexpected '2' at the end of the record");
  EXPECT_EQ(error_of("newmtl a\nillum 2.5"),
            "x.mtl:2:7: illum must be a whole number from 0 to 1000");
  EXPECT_EQ(error_of("newmtl a\nillum 1e30"),
            "x.mtl:2:7: illum must be a whole number from 0 to 1000");
  EXPECT_EQ(error_of("newmtl a\nillum -1"),
            "x.mtl:2:7: illum must be a whole number from 0 to 1000");
  EXPECT_EQ(error_of("newmtl a\nTr\n"), "x.mtl:2:3: truncated record: expected a number");
}

TEST(Mtl, KeysBeforeTheFirstMaterialAreRefused) {
  EXPECT_EQ(error_of("# note\n Kd 1 1 1\nnewmtl a"), "x.mtl:2:2: 'Kd' precedes the first newmtl");
  EXPECT_EQ(error_of("map_Kd a.png"), "x.mtl:1:1: 'map_Kd' precedes the first newmtl");
}

TEST(Mtl, Names) {
  const Parsed parsed =
      parse("newmtl Dark  wood \t\nnewmtl red # note\nnewmtl Material #25\nnewmtl a\\\nb");
  ASSERT_EQ(parsed.materials.size(), 4u);
  EXPECT_EQ(parsed.materials[0].name, "Dark  wood");
  EXPECT_EQ(parsed.materials[1].name, "red");
  EXPECT_EQ(parsed.materials[2].name, "Material #25");
  EXPECT_EQ(parsed.materials[3].name, "a b");
  EXPECT_EQ(error_of("newmtl a\nnewmtl "), "x.mtl:2:8: truncated record: newmtl needs a name");
}

TEST(Mtl, TransparencyIsOneMinusDissolve) {
  EXPECT_EQ(parse("newmtl a\nTr 0.25").materials[0].d, 0.75f);
  const Parsed both = parse("newmtl a\nTr 1\nd 1\nnewmtl b\nd 0.4\nTr 0.6\nnewmtl c\n");
  EXPECT_EQ(both.materials[0].d, 1.0f);
  EXPECT_EQ(both.materials[1].d, 0.4f);
  EXPECT_FALSE(both.materials[2].d);
  EXPECT_EQ(both.told(), "warning Tr differs from 1 - d; d is used x1 at 2:1");
}

TEST(Mtl, HaloIsCounted) {
  const Parsed parsed = parse("newmtl a\nd -halo 0.5\n");
  EXPECT_EQ(parsed.materials[0].d, 0.5f);
  EXPECT_EQ(parsed.told(), "ignored MTL option d -halo x1 at 2:3");
}

TEST(Mtl, OtherKeysAreNamedOnceEach) {
  const Parsed parsed = parse(
      "newmtl a\nKa 1 1 1\nmap_Kd -s 1 1 1 wood.png\nTf spectral x\nPc 0\nnewmtl b\nKa 0 0 0\n"
      "norm n.png \\\nKd -1\nrefl -type sphere x\nfoo");
  EXPECT_EQ(parsed.told(),
            "ignored MTL key 'Ka' x2 at 2:1; ignored MTL key 'map_Kd' x1 at 3:1; "
            "ignored MTL key 'Tf' x1 at 4:1; ignored MTL key 'Pc' x1 at 5:1; "
            "ignored MTL key 'norm' x1 at 8:1; ignored MTL key 'refl' x1 at 10:1; "
            "ignored MTL key 'foo' x1 at 11:1");
  std::string garbage = "newmtl a\n";
  for (int i = 0; i < 500; ++i) garbage += std::to_string(i) + "\n";
  EXPECT_EQ(parse(garbage).report.entries().size(), 65u);
}

TEST(Mtl, RepeatedKeysAreTold) {
  const Parsed parsed = parse("newmtl a\nKd 1 1 1\nKd 0 0 0\n");
  EXPECT_EQ(parsed.materials[0].Kd, Rgb(0));
  EXPECT_EQ(parsed.told(), "warning key given twice: Kd x1 at 3:1");
}

TEST(Mtl, TheLastOfTwoMaterialsOfOneNameCounts) {
  const Parsed parsed = parse("newmtl a\nKd 1\nNs 5\nnewmtl b\nnewmtl a\nKd 0.5\nTr 0.5\n");
  ASSERT_EQ(parsed.materials.size(), 2u);
  EXPECT_EQ(parsed.materials[0].name, "a");
  EXPECT_EQ(parsed.materials[0].Kd, Rgb(0.5f));
  EXPECT_EQ(parsed.materials[0].d, 0.5f);
  EXPECT_FALSE(parsed.materials[0].Ns);
  EXPECT_EQ(to_string(parsed.materials[0].where), "x.mtl:5:1");
  EXPECT_EQ(parsed.told(), "warning material defined twice; the last definition is used x1 at 5:1");
}

TEST(Mtl, LineEndsIndentationAndByteOrderMark) {
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    const Parsed parsed = parse("\xef\xbb\xbfnewmtl a" + end + "\tKd\t.5 \\" + end + " .5 .5 # c" +
                                end + end + "  Ns 10" + end + "# C:\\" + end + "Ni 1.5");
    ASSERT_EQ(parsed.materials.size(), 1u);
    EXPECT_EQ(parsed.materials[0].name, "a");
    EXPECT_EQ(parsed.materials[0].Kd, Rgb(0.5f));
    EXPECT_EQ(parsed.materials[0].Ns, 10.0f);
    EXPECT_EQ(parsed.materials[0].Ni, 1.5f);
    EXPECT_EQ(parsed.told(), "");
    EXPECT_EQ(error_of("newmtl a" + end + "Kd .5 \\" + end + " .5 x"),
              "x.mtl:3:5: expected a number, found 'x'");
  }
}

TEST(Mtl, SurvivesRandomDamage) {
  const std::string good =
      "# note\nnewmtl red one\nKd .5 .5 \\\r\n.5\nKs 1\nNs 10\rd 1\nTr 0\nillum 2\nmap_Kd -s 1 "
      "a.png\n"
      "newmtl light\r\nKe 17 12 4\nPr .5\nPm 0\nNi 1.5\nnewmtl red one\nd -halo 1";
  const std::string bytes = "0123456789-+.eE# \t\r\n\\KdTrnewmtl,\0\xff"s;
  std::mt19937 random(23);
  const auto below = [&](std::size_t n) { return random() % n; };
  int refused = 0;
  const int rounds = 20000;
  for (int round = 0; round < rounds; ++round) {
    std::string text = good;
    for (std::size_t edits = 1 + below(6); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text[at] = bytes[below(bytes.size())];
          break;
        case 1:
          text.insert(at, text.substr(below(text.size()), below(20)));
          break;
        case 2:
          text.erase(at, 1 + below(8));
          break;
        default:
          text[at] = static_cast<char>(below(256));
          break;
      }
    }
    if (below(10) == 0) text.resize(below(text.size() + 1));
    try {
      for (const MtlMaterial& m : parse(text).materials) ASSERT_FALSE(m.name.empty());
    } catch (const InputError& error) {
      ++refused;
      EXPECT_TRUE(std::string(error.what()).starts_with("x.mtl:")) << error.what();
    }
  }
  EXPECT_GT(refused, rounds / 10);
  EXPECT_LT(refused, rounds * 9 / 10);
}

}  // namespace
}  // namespace raytracing
