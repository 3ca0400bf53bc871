#include <gtest/gtest.h>
#include <lcms2.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "raytracing/io/file.h"
#include "raytracing/io/image.h"
#include "raytracing/io/srgb.h"
#include "refusal.h"
#include "support/oiio.h"
#include "support/temp_dir.h"

// What a file says of its colours is applied and told, or the file is refused.

namespace raytracing {
namespace {

const std::vector<std::uint8_t> kCodes = {0, 51, 255, 200, 100, 1};

std::string write_with_profile(const TempDir& folder, const std::string& name,
                               cmsHPROFILE profile) {
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  cmsUInt32Number size = 0;
  cmsSaveProfileToMem(profile, nullptr, &size);
  std::vector<std::uint8_t> bytes(size);
  cmsSaveProfileToMem(profile, bytes.data(), &size);
  cmsCloseProfile(profile);
  spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(size)),
                 bytes.data());
  return write_oiio(folder, name, spec, kCodes);
}

cmsHPROFILE rgb_profile(const cmsCIExyYTRIPLE& primaries, double gamma) {
  constexpr cmsCIExyY kD65{0.3127, 0.3290, 1};
  cmsToneCurve* curve = cmsBuildGamma(nullptr, gamma);
  const std::array<cmsToneCurve*, 3> curves{curve, curve, curve};
  cmsHPROFILE profile = cmsCreateRGBProfile(&kD65, &primaries, curves.data());
  cmsFreeToneCurve(curve);
  return profile;
}

constexpr cmsCIExyYTRIPLE kRec709{{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
constexpr cmsCIExyYTRIPLE kDisplayP3{{0.68, 0.32, 1}, {0.265, 0.69, 1}, {0.15, 0.06, 1}};

TEST(Profiles, ThatOfSrgbChangesNothing) {
  const TempDir folder;
  for (const char* name : {"x.png", "x.tif", "x.jpg"}) {
    const std::string path = write_with_profile(folder, name, cmsCreate_sRGBProfile());
    const ImageData image = read_image(path);
    EXPECT_EQ(image.notes, std::vector<std::string>()) << name;
    if (name == std::string("x.jpg")) continue;  // its codes are not exact
    for (std::size_t i = 0; i < kCodes.size(); ++i)
      EXPECT_EQ(image.values[i], static_cast<float>(srgb_to_linear(kCodes[i] / 255.0)));
  }
}

TEST(Profiles, ALinearOneIsApplied) {
  const TempDir folder;
  for (const char* name : {"x.png", "x.tif"}) {
    const ImageData image = read_image(write_with_profile(folder, name, rgb_profile(kRec709, 1)));
    ASSERT_EQ(image.notes.size(), 1u) << name;
    EXPECT_TRUE(image.notes[0].starts_with("its colours were converted from the ICC profile"));
    for (std::size_t i = 0; i < kCodes.size(); ++i)
      EXPECT_NEAR(image.values[i], kCodes[i] / 255.0, 2e-4);
  }
}

// White stays white, and the green of Display P3 is more saturated than that of Rec. 709: its red
// and blue are negative there. The matrix is that of SMPTE EG 432-1 primaries with D65.
TEST(Profiles, OtherPrimariesAreConverted) {
  const TempDir folder;
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  const ImageData image =
      read_image(write_with_profile(folder, "x.png", rgb_profile(kDisplayP3, 2.2)));
  const double g = std::pow(51 / 255.0, 2.2), b = 1;  // the first pixel is 0, 51, 255
  EXPECT_NEAR(image.values[0], -0.2249 * g, 2e-3);
  EXPECT_NEAR(image.values[1], 1.0421 * g, 2e-3);
  EXPECT_NEAR(image.values[2], -0.0786 * g + 1.0979 * b, 2e-3);
}

TEST(Profiles, ThoseOfOtherSpacesAndDamagedOnesAreRefused) {
  const TempDir folder;
  EXPECT_TRUE(refusal(write_with_profile(folder, "x.tif", cmsCreateLab4Profile(nullptr)))
                  .ends_with("is not one of RGB"));
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  const std::vector<std::uint8_t> garbage(200, 7);
  spec.attribute("ICCProfile", OIIO::TypeDesc(OIIO::TypeDesc::UINT8, 200), garbage.data());
  EXPECT_EQ(refusal(write_oiio(folder, "x.tif", spec, kCodes)), "its ICC profile is damaged");
}

TEST(Gamma, OfAPngIsAppliedAndTold) {
  const TempDir folder;
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("oiio:ColorSpace", "GammaCorrected");
  for (const float gamma : {1.0f, 1.8f}) {
    spec.attribute("oiio:Gamma", gamma);
    const ImageData image = read_image(write_oiio(folder, "x.png", spec, kCodes));
    EXPECT_EQ(image.notes.size(), 1u);
    for (std::size_t i = 0; i < kCodes.size(); ++i)
      EXPECT_NEAR(image.values[i], std::pow(kCodes[i] / 255.0, double{gamma}), 1e-5);
  }
}

/// Puts a chunk before the pixels of a PNG file.
std::string with_chunk(const std::string& png, const std::string& chunk) {
  const std::size_t at = png.find("IDAT") - 4;
  return png.substr(0, at) + chunk + png.substr(at);
}

std::string chunk(const std::string& name, const std::vector<std::uint32_t>& numbers) {
  std::string body = name;
  const auto append = [](std::string& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xff);
  };
  for (const std::uint32_t number : numbers) append(body, number);
  std::string bytes;
  append(bytes, static_cast<std::uint32_t>(4 * numbers.size()));
  bytes += body;
  append(bytes, static_cast<std::uint32_t>(
                    crc32_z(0, reinterpret_cast<const Bytef*>(body.data()), body.size())));
  return bytes;
}

// Display P3 with the gamma 2.2; the matrix is that of the test of profiles.
TEST(Chrm, OfAPngIsConverted) {
  const TempDir folder;
  const OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  std::string png = read_file(write_oiio(folder, "x.png", spec, kCodes));
  png = with_chunk(png, chunk("cHRM", {31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000}));
  const std::size_t srgb = png.find("sRGB");
  if (srgb != std::string::npos) png.erase(srgb - 4, 13);
  const ImageData image = read_image(folder.write("y.png", png));
  EXPECT_EQ(image.notes,
            (std::vector<std::string>{
                "its colours were converted from its own chromaticities to Rec. 709"}));
  const double g = srgb_to_linear(51 / 255.0);
  EXPECT_NEAR(image.values[0], -0.2249 * g, 2e-3);
  EXPECT_NEAR(image.values[1], 1.0421 * g, 2e-3);
  EXPECT_NEAR(image.values[2], -0.0786 * g + 1.0979, 2e-3);
}

TEST(Hdr, FactorsOfItsHeaderAreRefusedAndPrimariesConverted) {
  const TempDir folder;
  const ImageData grey{8, 1, {"R", "G", "B"}, std::vector<float>(24, 0.5f), {}};
  const std::string hdr = encode_image(grey, "hdr");
  const auto with_line = [&](const std::string& line) {
    std::string bytes = hdr;
    return folder.write("x.hdr", bytes.insert(bytes.find("FORMAT="), line + "\n"));
  };
  EXPECT_EQ(refusal(with_line("EXPOSURE=1.0")), "read");
  EXPECT_EQ(refusal(with_line("EXPOSURE=2.0")),
            "its header states EXPOSURE=2.0, which is not applied");
  EXPECT_EQ(refusal(with_line("COLORCORR=1 0.5 1")),
            "its header states COLORCORR=1 0.5 1, which is not applied");
  const ImageData p3 =
      read_image(with_line("PRIMARIES=0.68 0.32 0.265 0.69 0.15 0.06 0.3127 0.329"));
  EXPECT_EQ(p3.notes.size(), 1u);
  for (const float value : p3.values) EXPECT_NEAR(value, 0.5, 0.01);  // grey stays grey
}

TEST(Pnm, OfOtherLargestValuesIsRefused) {
  const TempDir folder;
  EXPECT_EQ(refusal(folder.write("x.ppm", std::string("P6 # note\n1 1\n255\nabc"))), "read");
  EXPECT_EQ(refusal(folder.write("x.ppm", std::string("P6 1 1 100\nabc"))),
            "PNM images with the largest value 100 cannot be read, only 255");
}

TEST(Cicp, OfOtherSpacesIsRefused) {
  const TempDir folder;
  const std::string png = encode_image({1, 1, {"R", "G", "B"}, {0.1f, 0.2f, 0.3f}, {}}, "png");
  const std::string srgb("\0\0\0\4cICP\x01\x0d\x00\x01\x9c\x69\x3b\x32", 16);
  const std::string pq("\0\0\0\4cICP\x09\x10\x00\x01\x4d\x23\x23\xfe", 16);
  EXPECT_EQ(refusal(folder.write("s.png", with_chunk(png, srgb))), "read");
  EXPECT_EQ(refusal(folder.write("p.png", with_chunk(png, pq))),
            "its chunk cICP states a colour space other than sRGB, which is not converted");
}

// CIE XYZ as primaries: the values are X, Y and Z. The matrix to Rec. 709 is that of IEC 61966-2-1.
TEST(Chromaticities, OfAnExrAreConverted) {
  const TempDir folder;
  OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeFloat);
  const std::array<float, 8> xyz{1, 0, 0, 1, 0, 0, 1 / 3.0f, 1 / 3.0f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), xyz.data());
  const std::vector<float> values{0.3f, 0.5f, 0.2f};
  const ImageData image = read_image(write_oiio(folder, "x.exr", spec, values));
  EXPECT_NEAR(image.values[0], 3.2406 * 0.3 - 1.5372 * 0.5 - 0.4986 * 0.2, 2e-4);
  EXPECT_NEAR(image.values[1], -0.9689 * 0.3 + 1.8758 * 0.5 + 0.0415 * 0.2, 2e-4);
  EXPECT_NEAR(image.values[2], 0.0557 * 0.3 - 0.2040 * 0.5 + 1.0570 * 0.2, 2e-4);
  EXPECT_EQ(image.notes,
            (std::vector<std::string>{
                "its colours were converted from its own chromaticities to Rec. 709"}));

  spec.nchannels = 6;
  spec.channelnames = {"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  const ImageData mixed =
      read_image(write_oiio(folder, "v.exr", spec, std::vector<float>(6, 0.1f)));
  EXPECT_EQ(mixed.channels, (std::vector<std::string>{"R", "G", "B"}));
  EXPECT_EQ(mixed.notes.back(),
            "its layers of variance and halves were left out, since its colours were converted");
  spec.nchannels = 3;
  spec.channelnames = {"R", "G", "B"};

  const std::array<float, 8> rec709{0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), rec709.data());
  const ImageData same = read_image(write_oiio(folder, "x.exr", spec, values));
  EXPECT_EQ(same.values, values);
  EXPECT_EQ(same.notes, std::vector<std::string>());

  const std::array<float, 8> line{0.1f, 0.1f, 0.2f, 0.2f, 0.3f, 0.3f, 0.4f, 0.4f};
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), line.data());
  EXPECT_EQ(refusal(write_oiio(folder, "x.exr", spec, values)),
            "its chromaticities are not those of three primaries");
}

}  // namespace
}  // namespace raytracing
