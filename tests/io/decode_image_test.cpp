#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "raytracing/io/errors.h"
#include "raytracing/io/file.h"
#include "raytracing/io/image.h"
#include "raytracing/io/srgb.h"
#include "refusal.h"
#include "support/oiio.h"
#include "support/temp_dir.h"

// The library itself writes the files of kinds that this program does not write.

namespace raytracing {
namespace {

using Channels = std::vector<std::string>;

ImageData small_picture() {
  ImageData image{3, 2, {"R", "G", "B", "variance.R"}, {}, {}};
  for (int i = 0; i < 24; ++i) image.values.push_back(static_cast<float>(i) / 24);
  image.metadata = {{"scene_hash", "00ff"}, {"spp", std::int64_t{64}}, {"seconds", 0.25}};
  return image;
}

float linear(double code, double most) { return static_cast<float>(srgb_to_linear(code / most)); }

TEST(ReadExr, RestoresWhatWasWritten) {
  const TempDir folder;
  const ImageData image = small_picture();
  const std::string path = folder.write("x.exr", encode_image(image, "exr"));
  const ImageData back = read_image(path);
  EXPECT_EQ(back.width, 3);
  EXPECT_EQ(back.height, 2);
  EXPECT_EQ(back.channels, image.channels);
  EXPECT_EQ(back.values, image.values);
  for (const auto& entry : image.metadata)
    EXPECT_EQ(std::count(back.metadata.begin(), back.metadata.end(), entry), 1) << entry.first;
}

TEST(ReadExr, KeepsNonFiniteValues) {
  const TempDir folder;
  ImageData image{2, 1, {"R", "G", "B"}, {}, {}};
  const float inf = std::numeric_limits<float>::infinity();
  image.values = {inf, -inf, std::numeric_limits<float>::quiet_NaN(), -1, 3e38f, 1e-45f};
  const ImageData back = read_image(folder.write("x.exr", encode_image(image, "exr")));
  ASSERT_EQ(back.values.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_EQ(std::bit_cast<std::uint32_t>(back.values[i]),
              std::bit_cast<std::uint32_t>(image.values[i]));
}

// The image has more rows than a strip of the reader, a data window off the origin, and tiles.
TEST(ReadExr, TakesHalfUintTilesAndAnyDataWindow) {
  const TempDir folder;
  constexpr int kWidth = 5, kHeight = 150;
  std::vector<float> values;
  for (int i = 0; i < kWidth * kHeight * 4; ++i) values.push_back(static_cast<float>(i % 1999));
  for (const OIIO::TypeDesc type :
       {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT, OIIO::TypeDesc::UINT32})
    for (const int tile : {0, 16}) {
      OIIO::ImageSpec spec(kWidth, kHeight, 4, type);
      spec.channelnames = {"R", "G", "B", "halfA.R"};
      spec.x = -7;
      spec.y = 11;
      spec.tile_width = spec.tile_height = tile;
      if (tile != 0) spec.x = spec.y = 0;
      std::vector<std::uint32_t> whole(values.begin(), values.end());
      const std::string path = type == OIIO::TypeDesc::UINT32
                                   ? write_oiio(folder, "x.exr", spec, whole)
                                   : write_oiio(folder, "x.exr", spec, values);
      const ImageData back = read_image(path);
      EXPECT_EQ(back.channels, (Channels{"R", "G", "B", "halfA.R"}));
      EXPECT_EQ(back.width, kWidth);
      EXPECT_EQ(back.height, kHeight);
      EXPECT_EQ(back.values, values) << type.c_str() << " " << tile;
    }
}

TEST(ReadPng, DecodesWhatWasWritten) {
  const TempDir folder;
  ImageData image{256, 1, {"R", "G", "B"}, {}, {{"spp", std::int64_t{64}}}};
  for (int code = 0; code < 256; ++code)
    for (const int c : {code, 255 - code, (code + 85) % 256})
      image.values.push_back(linear(c, 255));
  const ImageData back = read_image(folder.write("x.png", encode_image(image, "png")));
  EXPECT_EQ(back.width, 256);
  EXPECT_EQ(back.height, 1);
  EXPECT_EQ(back.channels, image.channels);
  EXPECT_EQ(back.values, image.values);
  EXPECT_EQ(back.integer_bits, 8);
  EXPECT_EQ(back.metadata, (ImageMetadata{{"spp", std::string("64")}}));
}

// By IEC 61966-2-1: 0.5 -> ((0.5 + 0.055) / 1.055)^2.4 = 0.214041, 10/255/12.92 = 0.00303527.
TEST(ReadPng, KnowsTheCurve) {
  EXPECT_NEAR(srgb_to_linear(0.5), 0.2140411, 1e-7);
  EXPECT_NEAR(srgb_to_linear(10 / 255.0), 0.003035270, 1e-9);
  EXPECT_EQ(srgb_to_linear(0), 0);
  EXPECT_EQ(srgb_to_linear(1), 1);
}

TEST(ReadPng, TakesGreySixteenBitsAndOpaqueAlpha) {
  const TempDir folder;
  const std::vector<std::uint8_t> grey = {0, 1, 128, 255};
  ImageData back =
      read_image(write_oiio(folder, "grey.png", {2, 2, 1, OIIO::TypeDesc::UINT8}, grey));
  ASSERT_EQ(back.values.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(back.values[i], linear(grey[i / 3], 255));

  const std::vector<std::uint16_t> wide = {0, 1, 256, 4660, 65534, 65535};
  back = read_image(write_oiio(folder, "wide.png", {2, 1, 3, OIIO::TypeDesc::UINT16}, wide));
  ASSERT_EQ(back.values.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(back.values[i], linear(wide[i], 65535)) << i;

  OIIO::ImageSpec rgba(2, 1, 4, OIIO::TypeDesc::UINT8);
  rgba.attribute("oiio:UnassociatedAlpha", 1);
  std::vector<std::uint8_t> values = {1, 2, 3, 255, 4, 5, 6, 255};
  back = read_image(write_oiio(folder, "opaque.png", rgba, values));
  EXPECT_EQ(back.channels, (Channels{"R", "G", "B"}));
  ASSERT_EQ(back.values.size(), 6u);
  for (int i = 0; i < 6; ++i)
    EXPECT_EQ(back.values[static_cast<std::size_t>(i)], linear(i + 1, 255));
  values[7] = 254;
  EXPECT_EQ(refusal(write_oiio(folder, "seen.png", rgba, values)), "has transparent pixels");
}

TEST(ReadImage, RefusesWhatIsNoPicture) {
  const TempDir folder;
  EXPECT_EQ(refusal(folder / "nope.exr"), "No such file or directory");
  EXPECT_EQ(refusal(folder.path()), "Is a directory");
  for (const char* text : {"", "x", "\x89PNG", "RIFF and more of the like"})
    EXPECT_EQ(refusal(folder.write("x.png", text)),
              "not an image of a known format: EXR, PNG, TIFF, JPEG, HDR, PFM or PNM");
}

TEST(ReadImage, GoesByTheBytesNotTheName) {
  const TempDir folder;
  const ImageData image = small_picture();
  EXPECT_EQ(read_image(folder.write("x.png", encode_image(image, "exr"))).values, image.values);
}

// Prefixes of every third length cut each part of a file.
TEST(ReadImage, RefusesTruncatedFiles) {
  const TempDir folder;
  for (const char* format : {"exr", "png"}) {
    const std::string bytes = encode_image(small_picture(), format);
    for (std::size_t size = 0; size < bytes.size(); size += 3)
      ASSERT_NE(refusal(folder.write("x", std::string_view(bytes).substr(0, size))), "read")
          << size << " of " << bytes.size();
  }
}

// A flipped byte leads to an image or an InputError, nothing else.
TEST(ReadImage, SurvivesDamagedBytes) {
  const TempDir folder;
  for (const char* format : {"exr", "png"}) {
    const std::string good = encode_image(small_picture(), format);
    for (std::size_t i = 0; i < good.size(); ++i) {
      std::string bytes = good;
      bytes[i] = static_cast<char>(bytes[i] ^ (i % 2 == 0 ? 0xff : 0x80));
      refusal(folder.write("x", bytes));
    }
  }
}

/// Replaces four bytes, `skip` bytes after the beginning of `name`.
std::string with_number(std::string bytes, std::string_view name, std::size_t skip,
                        std::uint32_t value, bool big_endian) {
  const std::size_t at = bytes.find(name) + skip;
  for (std::size_t i = 0; i < 4; ++i)
    bytes[at + i] = static_cast<char>(value >> 8 * (big_endian ? 3 - i : i));
  return bytes;
}

TEST(ReadImage, RefusesHugeClaimsBeforeTakingTheMemory) {
  const TempDir folder;
  const std::string exr = encode_image(small_picture(), "exr");
  const std::size_t window = sizeof("dataWindow") + sizeof("box2i") + 4;
  for (const auto& [field, claim] :
       std::vector<std::pair<std::size_t, std::uint32_t>>{{2, 65536},
                                                          {2, 0x7fffffff},
                                                          {3, 0x7fffffff},
                                                          {3, 65536},
                                                          {0, 0x80000000},
                                                          {1, 0x80000000},
                                                          {2, 0xffffffff},
                                                          {3, 60000}}) {
    const std::string bytes = with_number(exr, "dataWindow", window + 4 * field, claim, false);
    EXPECT_NE(refusal(folder.write("x", bytes)), "read") << field << " " << claim;
  }
  EXPECT_EQ(refusal(folder.write("x", with_number(exr, "dataWindow", window + 8, 65536, false))),
            "65537x2 pixels are more than can be read");
  const std::size_t text = sizeof("scene_hash") + sizeof("string");
  EXPECT_EQ(refusal(folder.write("x", with_number(exr, "scene_hash", text, 0x7fffffff, false))),
            "its header is cut off or contradicts itself");
}

// An attribute that states a size other than that of its type shifts everything behind it: OpenEXR
// would then allocate 2 GB for a text.
TEST(ReadImage, RefusesAttributesThatShiftTheNext) {
  const TempDir folder;
  const std::string exr = encode_image(small_picture(), "exr");
  const auto with_size = [&](std::string_view name, std::string_view type, char size) {
    std::string bytes = exr;
    bytes[bytes.find(name) + name.size() + type.size() + 2] = size;
    return refusal(folder.write("x", bytes));
  };
  const std::string wrong = "its header is cut off or contradicts itself";
  EXPECT_EQ(with_size("compression", "compression", 2), wrong);
  EXPECT_EQ(with_size("dataWindow", "box2i", 15), wrong);
  EXPECT_EQ(with_size("channels", "chlist", 1), wrong);
  EXPECT_EQ(with_size("spp", "int", 5), wrong);
  EXPECT_EQ(with_size("compression", "compression", 1), "read");
  const std::size_t type = sizeof("channels") + sizeof("chlist") + 4 + sizeof("B");
  EXPECT_EQ(refusal(folder.write("x", with_number(exr, "channels", type, 3, false))), wrong);
  EXPECT_EQ(refusal(folder.write("x", with_number(exr, "channels", type, 2, false))), "read");
}

// These few bytes once allocated 16 MB and 700 MB.
TEST(ReadImage, RefusesChunksAndTilesThatTheFileDoesNotHold) {
  const TempDir folder;
  const std::string png = encode_image(small_picture(), "png");
  std::string text = png.substr(0, 33) + std::string("\x00\xf0\x00\x00tEXt", 8) + png.substr(33);
  EXPECT_EQ(refusal(folder.write("x", text)), "damaged PNG image: cut off within a chunk");

  OIIO::ImageSpec spec(32, 32, 3, OIIO::TypeDesc::FLOAT);
  spec.tile_width = spec.tile_height = 16;
  const std::string tiled =
      read_file(write_oiio(folder, "t.exr", spec, std::vector<float>(32 * 32 * 3)));
  const std::size_t sizes = sizeof("tiles") + sizeof("tiledesc") + 4;
  std::string small = with_number(tiled, "tiles", sizes, 1, false);
  small = with_number(small, "tiles", sizes + 4, 1, false);
  const std::size_t window = sizeof("dataWindow") + sizeof("box2i") + 4;
  small = with_number(small, "dataWindow", window + 8, 9000, false);
  small = with_number(small, "dataWindow", window + 12, 9000, false);
  EXPECT_EQ(refusal(folder.write("x", small)), "is too short for its tiles or rows");
}

}  // namespace
}  // namespace raytracing
