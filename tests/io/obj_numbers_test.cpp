#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <random>

#include "io/parse_obj_text.h"

namespace raytracing {
namespace {

using namespace std::string_literals;

TEST(ObjNumbers, NumberForms) {
  const Parsed parsed =
      parse("v +2 .5 1.E-1\nv -1. -.25e+1 1e2\nv 1E-50 -0 00012.5\nv 5. 0.0e99999 1e-46\n");
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

// Every number must be the float nearest to the decimal, even midway between two floats.
TEST(ObjNumbers, NumbersAreRoundedCorrectly) {
  std::mt19937_64 random(9);
  std::vector<std::string> words = {"16777217",
                                    "16777219",
                                    "16777217.0000000000000000001",
                                    "0.5000000298023223876953125",
                                    "9007199254740993",
                                    "1.00000017881393432617187499",
                                    "1.00000017881393432617187501"};
  for (int i = 0; i < 30000; ++i) {
    char digits[64];
    const auto bits = static_cast<std::uint32_t>(random());
    const float value = std::bit_cast<float>(bits);
    if (!std::isfinite(value)) continue;
    const double midway = (double{value} + double{std::nextafter(value, 0.0f)}) / 2;
    words.emplace_back(digits, std::to_chars(digits, digits + 64, value).ptr);
    words.emplace_back(digits, std::to_chars(digits, digits + 64, midway).ptr);
    // 16 digits round to the double midway between two floats without being equal to it.
    const double small = std::ldexp(midway, -std::ilogb(midway) + static_cast<int>(random() % 20));
    words.emplace_back(
        digits, std::to_chars(digits, digits + 64, small, std::chars_format::scientific, 15).ptr);
    const auto fraction = static_cast<double>(random() % 2'000'000'000) / 1e6 - 1000;
    words.emplace_back(
        digits, std::to_chars(digits, digits + 64, fraction, std::chars_format::fixed, 6).ptr);
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

// A random unsigned number: up to 25 digits, with or without point and exponent.
std::string random_number(std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<int>(random() % n); };
  const int most = below(3) == 0 ? 25 : 9;
  const int digits = 1 + below(static_cast<std::size_t>(most));
  const int point = below(static_cast<std::size_t>(digits + 8));
  std::string word;
  for (int i = 0; i < digits; ++i) {
    if (i == point) word += '.';
    word += static_cast<char>('0' + (below(6) == 0 ? 0 : below(10)));
  }
  if (digits == point) word += '.';
  if (below(3) == 0) {
    word += below(2) == 0 ? "e" : "E-";
    word += std::to_string(below(below(2) == 0 ? 60 : 12));
  }
  return word;
}

// Three million numbers agree with the standard library.
TEST(ObjNumbers, NumbersOfAnyFormAreRoundedCorrectly) {
  std::mt19937_64 random(11);
  std::string text, word;
  std::vector<float> expected;
  while (expected.size() < 3'000'000) {
    word = random_number(random);
    float value = 0;
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    if (result.ec != std::errc()) continue;  // out of range
    ASSERT_EQ(result.ptr, word.data() + word.size()) << word;
    const bool negative = random() % 2 == 0;
    text += expected.size() % 3 == 0 ? "\nv " : " ";
    if (negative) text += '-';
    text += word;
    expected.push_back(negative ? -value : value);
  }
  const Parsed parsed = parse(text);  // the last word ends the text
  ASSERT_EQ(parsed.mesh().positions.size() * 3, expected.size());
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const float found = parsed.mesh().positions[i / 3][static_cast<int>(i % 3)];
    wrong += std::bit_cast<std::uint32_t>(found) != std::bit_cast<std::uint32_t>(expected[i]);
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(ObjNumbers, IndicesOfAnyLength) {
  std::mt19937_64 random(12);
  const std::uint32_t count = 200'000;
  std::string text;
  for (std::uint32_t i = 0; i < count; ++i)
    text += "v " + std::to_string(i) + ' ' + std::to_string(i % 7) + " 0\n";
  Indices expected;
  while (expected.size() < 90'000) {
    text += "\nf";
    for (int corner = 0; corner < 3; ++corner) {
      const auto vertex = static_cast<std::uint32_t>(random() % count) >> random() % 18;
      text += std::string(" ") + (random() % 4 == 0 ? "+" : "");
      text += std::string(random() % 3 == 0 ? random() % 30 : 0, '0') + std::to_string(vertex + 1);
      if (random() % 2 == 0) text += "//";
      expected.push_back(vertex);
    }
  }
  const Parsed parsed = parse(text);
  Indices expected_kept;
  for (std::size_t i = 0; i < expected.size(); i += 3) {
    const auto a = expected[i], b = expected[i + 1], c = expected[i + 2];
    const auto turn = [](std::int64_t p, std::int64_t q, std::int64_t r) {
      return (q - p) * (r % 7 - p % 7) - (r - p) * (q % 7 - p % 7);
    };
    if (turn(a, b, c) != 0) expected_kept.insert(expected_kept.end(), {a, b, c});
  }
  Indices found;
  for (const PolygonMesh::Corner& corner : parsed.mesh().corners) found.push_back(corner.position);
  EXPECT_EQ(found, expected_kept);
  EXPECT_GT(found.size(), 80'000u);
  EXPECT_LT(found.size(), expected.size());
}

TEST(ObjNumbers, BadNumbersAreRefusedWithTheirPlace) {
  EXPECT_EQ(error_of("v 0 1,5 0"),
            "x.obj:1:5: expected y, found '1,5'; use a point as the decimal mark");
  EXPECT_EQ(error_of("\nv nan 0 0"), "x.obj:2:3: expected x, found 'nan'");
  EXPECT_EQ(error_of("v 0 0 -inf"), "x.obj:1:7: expected z, found '-inf'");
  EXPECT_EQ(error_of("v 1e39 0 0"), "x.obj:1:3: expected x, found '1e39', too large for a float");
  EXPECT_EQ(error_of("v 0 0 -3.5e38"),
            "x.obj:1:7: expected z, found '-3.5e38', too large for a float");
  EXPECT_EQ(
      error_of("v 1" + std::string(60, '0') + " 0 0"),
      "x.obj:1:3: expected x, found '1" + std::string(39, '0') + "...', too large for a float");
  EXPECT_EQ(error_of("v 1e999999999999999999999 0 0"),
            "x.obj:1:3: expected x, found '1e999999999999999999999', too large for a float");
  for (const std::string word : {"1x", "0x10", "1.2.3", "1e", "1e+", "+-1", "--1", ".", "-", "e5",
                                 "1\\", "1d5", "infinity", "1f"}) {
    EXPECT_EQ(error_of("v 0 0 0\r\n v 0  " + word + " 0"),
              "x.obj:2:7: expected y, found '" + word + "'");
  }
  EXPECT_EQ(error_of("v 0 0 \x01\xc3"), "x.obj:1:7: expected z, found '\\x01\\xc3'");
  EXPECT_EQ(error_of("vn 0 0 NaN"), "x.obj:1:8: expected z, found 'NaN'");
}

TEST(ObjNumbers, TruncatedRecordsAreRefused) {
  EXPECT_EQ(error_of("v 1 2"), "x.obj:1:6: truncated record: expected z");
  EXPECT_EQ(error_of("v\n1 2 3"), "x.obj:1:2: truncated record: expected x");
  EXPECT_EQ(error_of("v 1 2 # 3"), "x.obj:1:7: truncated record: expected z");
  EXPECT_EQ(error_of("vn 1\r\nv 0 0 0"), "x.obj:1:5: truncated record: expected y");
  EXPECT_EQ(error_of(kSquare + "f 1 2 \nv 0 0 0"),
            "x.obj:5:7: truncated record: a face needs at least 3 corners, found 2");
  EXPECT_EQ(error_of("f"), "x.obj:1:2: truncated record: a face needs at least 3 corners, found 0");
  EXPECT_EQ(error_of("v 1 2 3 4 5"), "x.obj:1:12: truncated record: expected blue");
}

TEST(ObjNumbers, TrailingTextIsRefused) {
  EXPECT_EQ(error_of("vn 1 2 3 4"), "x.obj:1:10: unexpected '4' at the end of the record");
  EXPECT_EQ(error_of("v 1 2 3 x"), "x.obj:1:9: expected a vertex weight or colour, found 'x'");
  EXPECT_EQ(error_of("v 1 2 3 1 1 1 1 1"), "x.obj:1:17: unexpected '1' at the end of the record");
}

}  // namespace
}  // namespace raytracing
