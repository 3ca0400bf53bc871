#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"
#include "raytracing/io/srgb.h"
#include "refusal.h"
#include "support/oiio.h"
#include "support/temp_dir.h"

// Round trips through the formats other than PNG and EXR, which have tests of their own.

namespace raytracing {
namespace {

/// A picture whose pixels all differ, of more rows than a strip of any format.
ImageData picture() {
  ImageData image{19, 23, {"R", "G", "B"}, {}, {{"scene_hash", "00ff"}, {"spp", std::int64_t{64}}}};
  for (int i = 0; i < 19 * 23 * 3; ++i)
    image.values.push_back(static_cast<float>(std::pow(1.013, i)) * 1e-3f);
  return image;
}

ImageData round_trip(const ImageData& image, const std::string& ending, bool as_float = false) {
  return decode_image(encode_image(image, ending, as_float), "x." + ending);
}

bool has_facts(const ImageData& image) {
  const auto has = [&](const char* name, const std::string& text) {
    return std::any_of(image.metadata.begin(), image.metadata.end(), [&](const auto& entry) {
      return entry.first == name && to_text(entry.second) == text;
    });
  };
  return has("scene_hash", "00ff") && has("spp", "64");
}

TEST(FloatTiff, KeepsEveryFloatAndTheFacts) {
  const ImageData image = picture(), back = round_trip(image, "tif", true);
  EXPECT_EQ(back.values, image.values);
  EXPECT_EQ(back.integer_bits, 0);
  EXPECT_TRUE(has_facts(back));
}

TEST(EightBits, KeepTheCodesAndTheFactsThatFit) {
  const ImageData image = picture();
  for (const char* ending : {"tif", "tiff", "png", "ppm"}) {
    const ImageData back = round_trip(image, ending);
    EXPECT_EQ(back.integer_bits, 8) << ending;
    EXPECT_EQ(has_facts(back), ending != std::string("ppm")) << ending;
    for (std::size_t i = 0; i < image.values.size(); ++i)
      ASSERT_EQ(srgb8(back.values[i]), srgb8(image.values[i])) << ending;
  }
}

// Compression changes codes of this smooth picture by a few steps, and keeps the facts.
TEST(Jpeg, IsCloseAndKeepsTheFacts) {
  ImageData image{64, 64, {"R", "G", "B"}, {}, picture().metadata};
  for (int i = 0; i < 64 * 64; ++i)
    for (const int code : {i % 64 * 4, i / 64 * 4, 128})
      image.values.push_back(static_cast<float>(srgb_to_linear(code / 255.0)));
  for (const char* ending : {"jpg", "jpeg"}) {
    const ImageData back = round_trip(image, ending);
    EXPECT_TRUE(has_facts(back));
    for (std::size_t i = 0; i < image.values.size(); ++i)
      ASSERT_LE(std::abs(srgb8(back.values[i]) - srgb8(image.values[i])), 6);
  }
}

// libjpeg would end the program for these.
TEST(Jpeg, RefusesWhatItCannotHold) {
  const ImageData wide{65501, 1, {"R", "G", "B"}, std::vector<float>(65501 * 3), {}};
  EXPECT_THROW(encode_image(wide, "jpg"), OutputError);
  const ImageData wordy{1, 1, {"R", "G", "B"}, {1, 1, 1}, {{"command", std::string(70000, 'x')}}};
  EXPECT_THROW(encode_image(wordy, "jpg"), OutputError);
}

// The three mantissas of a pixel have 8 bits and the exponent of the largest channel.
TEST(Hdr, IsExactToItsSharedExponent) {
  const ImageData image = picture(), back = round_trip(image, "hdr");
  EXPECT_EQ(back.integer_bits, 0);
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    const float largest = std::max({image.values[i], image.values[i + 1], image.values[i + 2]});
    for (std::size_t c = 0; c < 3; ++c)
      ASSERT_NEAR(back.values[i + c], image.values[i + c], double{largest} / 127);
  }
}

/// A PFM file, whose rows begin at the bottom.
std::string pfm(const ImageData& image) {
  std::string bytes =
      "PF\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n-1.0\n";
  const auto row = static_cast<std::size_t>(image.width) * 3;
  for (int y = image.height - 1; y >= 0; --y)
    bytes.append(
        reinterpret_cast<const char*>(image.values.data() + static_cast<std::size_t>(y) * row),
        row * sizeof(float));
  return bytes;
}

TEST(Pfm, IsReadTopRowFirst) {
  const ImageData image = picture();
  EXPECT_EQ(decode_image(pfm(image), "x.pfm").values, image.values);
}

TEST(Tiff, OfSeveralPagesTheFirstIsReadAndTold) {
  const TempDir folder;
  const OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeFloat);
  const std::string path = folder / "x.tif";
  const auto output = OIIO::ImageOutput::create(path);
  for (const float value : {1.0f, 2.0f}) {
    ASSERT_TRUE(output->open(
        path, spec, value == 1 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage));
    const std::vector<float> values(3, value);
    ASSERT_TRUE(output->write_image(OIIO::TypeFloat, values.data()));
  }
  output->close();
  const ImageData image = read_image(path);
  EXPECT_EQ(image.values, std::vector<float>(3, 1.0f));
  EXPECT_EQ(image.notes, (std::vector<std::string>{"image 1 of 2 in the file was read"}));
}

TEST(Tiff, OfOtherNumbersIsRefused) {
  const TempDir folder;
  const OIIO::ImageSpec spec(1, 1, 3, OIIO::TypeDesc::UINT32);
  EXPECT_EQ(refusal(write_oiio(folder, "x.tif", spec, std::vector<std::uint32_t>{1, 2, 3})),
            "values of type uint cannot be read");
}

TEST(Tiff, WhoseZeroIsWhiteIsRefused) {
  EXPECT_EQ(refusal(RAYTRACING_SOURCE_DIR "/tests/fuzz/corpus/tiff/white"),
            "TIFF images of the photometric interpretation 0 cannot be read");
}

TEST(Orientation, IsToldWhereItIsNotApplied) {
  const TempDir folder;
  OIIO::ImageSpec spec(2, 1, 3, OIIO::TypeDesc::UINT8);
  spec.attribute("Orientation", 6);
  const std::vector<std::uint8_t> codes{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(
      read_image(write_oiio(folder, "x.tif", spec, codes)).notes,
      (std::vector<std::string>{"its pixels were not turned, although its orientation is 6"}));
}

// A cut file or a flipped byte leads to an image or an InputError, nothing else.
TEST(AllFormats, SurviveDamage) {
  const TempDir folder;
  for (const char* ending : {"tif", "jpg", "hdr", "ppm"}) {
    const std::string good = encode_image(picture(), ending, true);
    for (std::size_t i = 0; i < std::min<std::size_t>(good.size(), 600); i += 3) {
      refusal(folder.write("cut", std::string_view(good).substr(0, i)));
      std::string bytes = good;
      bytes[i] = static_cast<char>(bytes[i] ^ (i % 2 == 0 ? 0xff : 0x80));
      refusal(folder.write("x", bytes));
    }
  }
}

/// A picture whose files are long beside their headers.
ImageData long_picture() {
  ImageData image{64, 64, {"R", "G", "B"}, {}, {}};
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 64 * 64 * 3; ++i) image.values.push_back(uniform(random));
  return image;
}

// A part of a file is not a part of a picture: nothing is filled in.
TEST(AllFormats, RefuseAPartOfAFile) {
  const TempDir folder;
  for (const char* ending : {"exr", "png", "tif", "jpg", "hdr", "ppm"}) {
    const std::string good = encode_image(long_picture(), ending, true);
    for (const int percent : {50, 60, 75, 90, 97})
      EXPECT_NE(
          refusal(folder.write("x", std::string_view(good).substr(
                                        0, good.size() * static_cast<std::size_t>(percent) / 100))),
          "read")
          << ending << " " << percent;
  }
  const std::string whole = pfm(picture());
  EXPECT_NE(refusal(folder.write("x", std::string_view(whole).substr(0, whole.size() / 2))),
            "read");
}

TEST(AllFormats, NameTheEndingsThatCanBeWritten) {
  for (const char* name :
       {"a.png", "a.EXR", "b.tif", "c.tiff", "d.jpg", "e.jpeg", "f.hdr", "g.bmp"})
    EXPECT_NO_THROW(image_ending(name)) << name;
  try {
    image_ending("x.foo");
    ADD_FAILURE();
  } catch (const UsageError& error) {
    EXPECT_TRUE(std::string(error.what())
                    .starts_with("x.foo: the name of an image must end in one of .exr .hdr .tif"))
        << error.what();
  }
  EXPECT_TRUE(holds_floats("exr") && holds_floats("hdr") && holds_floats("tif", true));
  EXPECT_FALSE(holds_floats("tif") || holds_floats("png", true));
}

}  // namespace
}  // namespace raytracing
