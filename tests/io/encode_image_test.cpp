#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <random>

#include "raytracing/io/errors.h"
#include "raytracing/io/image.h"
#include "raytracing/io/srgb.h"
#include "support/temp_dir.h"

namespace raytracing {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct ReadBack {
  OIIO::ImageSpec spec;
  std::vector<float> values;

  /// The values of a channel, pixel by pixel, top row first.
  std::vector<float> channel(const std::string& name) const {
    const auto& names = spec.channelnames;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    std::vector<float> result;
    for (auto i = static_cast<std::size_t>(found - names.begin()); i < values.size();
         i += names.size()) {
      result.push_back(values[i]);
    }
    return result;
  }
};

ReadBack read_back(const ImageData& image, const char* name) {
  const TempDir folder;
  const std::string path = folder.write(name, encode_image(image, image_ending(name)));
  const auto input = OIIO::ImageInput::open(path);
  if (!input) throw std::runtime_error(OIIO::geterror());
  ReadBack result{input->spec(), {}};
  result.values.resize(result.spec.image_pixels() *
                       static_cast<std::size_t>(result.spec.nchannels));
  if (!input->read_image(0, 0, 0, -1, OIIO::TypeFloat, result.values.data())) {
    throw std::runtime_error(input->geterror());
  }
  return result;
}

/// The 8-bit codes of a PNG, interleaved.
std::vector<int> read_codes(const ImageData& image) {
  std::vector<int> codes;
  for (const float value : read_back(image, "x.png").values) {
    codes.push_back(static_cast<int>(std::lround(value * 255)));
  }
  return codes;
}

/// All values differ, so that swapped rows, columns or channels are detected.
ImageData numbered_image(int width, int height, std::vector<std::string> channels) {
  ImageData image{width, height, std::move(channels), {}, {}};
  const auto count =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * image.channels.size();
  for (std::size_t i = 0; i < count; ++i) image.values.push_back(static_cast<float>(i));
  return image;
}

long double decode_srgb(long double encoded) {
  return encoded <= 0.04045L ? encoded / 12.92L : std::pow((encoded + 0.055L) / 1.055L, 2.4L);
}

long double encode_srgb(long double linear) {
  return linear <= 0.0031308L ? 12.92L * linear : 1.055L * std::pow(linear, 1 / 2.4L) - 0.055L;
}

TEST(ImageEnding, IsThatOfTheName) {
  EXPECT_EQ(image_ending("a.png"), "png");
  EXPECT_EQ(image_ending("dir.exr/a.b.PNG"), "png");
  EXPECT_EQ(image_ending("/x/y.Exr"), "exr");
  for (const char* name : {"", "png", ".png", "a.foo", "a.png.", "a.exr/b", "a.exr "}) {
    EXPECT_THROW(image_ending(name), UsageError) << name;
  }
}

TEST(Srgb8, RestoresEveryCode) {
  for (int code = 0; code <= 255; ++code) {
    EXPECT_EQ(srgb8(static_cast<float>(decode_srgb(code / 255.0L))), code);
  }
}

TEST(Srgb8, RoundsToNearestAtEveryBoundary) {
  for (int code = 1; code <= 255; ++code) {
    const long double boundary = decode_srgb((code - 0.5L) / 255);
    float above = static_cast<float>(boundary);
    if (above < boundary) above = std::nextafter(above, 2.0f);
    EXPECT_EQ(srgb8(above), code);
    EXPECT_EQ(srgb8(std::nextafter(above, -1.0f)), code - 1);
  }
}

TEST(Srgb8, AgreesWithTheForwardFormula) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 100000; ++i) {
    const float linear = std::pow(uniform(random), 3.0f);
    const long double code = 255 * encode_srgb(linear);
    if (std::abs(code - std::floor(code) - 0.5L) < 1e-5L) continue;  // may go either way
    ASSERT_EQ(srgb8(linear), std::lround(code)) << linear;
  }
}

TEST(Srgb8, ClampsWhatIsOutside) {
  for (const float value : {-0.0f, -1.0f, -kInfinity, kNan, -kNan, 1e-40f}) {
    EXPECT_EQ(srgb8(value), 0) << value;
  }
  for (const float value : {1.0f, 1.5f, 1e30f, kInfinity}) EXPECT_EQ(srgb8(value), 255) << value;
}

TEST(Exr, KeepsEveryFloatBitForBit) {
  const float signalling = std::bit_cast<float>(0x7f800001u);
  const float payload = std::bit_cast<float>(0xffc12345u);
  ImageData image{4, 3, {"R"}, {}, {}};
  image.values = {0.0f,      -0.0f,      -1.5f, 1e-45f,  3.4e38f,    -3.4e38f,
                  kInfinity, -kInfinity, kNan,  payload, signalling, 0.1f};
  const std::vector<float> values = read_back(image, "x.exr").channel("R");
  ASSERT_EQ(values.size(), image.values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(values[i]),
              std::bit_cast<std::uint32_t>(image.values[i]))
        << i;
  }
}

TEST(Exr, KeepsOrderOfPixelsAndNamesOfChannels) {
  // Neither order of the names is alphabetical; more rows than one ZIP block of 16.
  const ImageData image =
      numbered_image(7, 37, {"R", "G", "B", "variance.R", "variance.G", "variance.B", "A.x"});
  const ReadBack back = read_back(image, "x.exr");
  EXPECT_EQ(back.spec.width, 7);
  EXPECT_EQ(back.spec.height, 37);
  EXPECT_EQ(back.spec.format, OIIO::TypeFloat);
  EXPECT_EQ(back.spec.get_string_attribute("compression").substr(0, 3), "zip");
  EXPECT_EQ(back.spec.nchannels, 7);
  for (std::size_t c = 0; c < image.channels.size(); ++c) {
    const std::vector<float> values = back.channel(image.channels[c]);
    ASSERT_EQ(values.size(), 7u * 37u) << image.channels[c];
    for (std::size_t i = 0; i < values.size(); ++i) {
      ASSERT_EQ(values[i], image.values[i * image.channels.size() + c]) << image.channels[c];
    }
  }
}

TEST(Exr, KeepsTypedAttributes) {
  ImageData image = numbered_image(1, 1, {"R", "G", "B"});
  const std::string long_text(5000, 'x');
  image.metadata = {{"render:command", "a \"b\" c\nüñ"},
                    {"render:spp", std::int64_t{64}},
                    {"render:lowest", std::int64_t{-2147483648}},
                    {"render:seed", std::int64_t{2147483648}},
                    {"render:least", std::numeric_limits<std::int64_t>::min()},
                    {"render:seconds", 0.1},
                    {"render:a_name_of_more_than_thirty_one_letters", long_text}};
  const OIIO::ImageSpec spec = read_back(image, "x.exr").spec;
  const auto attribute = [&](const char* name, OIIO::TypeDesc type) {
    const OIIO::ParamValue* found = spec.find_attribute(name, type);
    EXPECT_TRUE(found) << name;
    return found;
  };
  EXPECT_EQ(attribute("render:command", OIIO::TypeString)->get_string(), "a \"b\" c\nüñ");
  EXPECT_EQ(attribute("render:spp", OIIO::TypeInt)->get<int>(), 64);
  EXPECT_EQ(attribute("render:lowest", OIIO::TypeInt)->get<int>(), -2147483647 - 1);
  EXPECT_EQ(attribute("render:seed", OIIO::TypeString)->get_string(), "2147483648");
  EXPECT_EQ(attribute("render:least", OIIO::TypeString)->get_string(), "-9223372036854775808");
  EXPECT_EQ(attribute("render:seconds", OIIO::TypeDesc::DOUBLE)->get<double>(), 0.1);
  EXPECT_EQ(spec.get_string_attribute("render:a_name_of_more_than_thirty_one_letters"), long_text);
}

TEST(Exr, RefusesAttributesThatWouldReplaceOthers) {
  ImageData image = numbered_image(1, 1, {"R"});
  for (const char* name : {"", "compression", "channels"}) {
    image.metadata = {{name, std::int64_t{1}}};
    EXPECT_THROW(encode_image(image, "exr"), OutputError) << name;
  }
  image.metadata = {{"twice", 1.0}, {"twice", 2.0}};
  EXPECT_THROW(encode_image(image, "exr"), OutputError);
}

TEST(Png, KeepsEveryCode) {
  ImageData image{256, 1, {"R", "G", "B"}, {}, {}};
  std::vector<int> expected;
  for (int code = 0; code <= 255; ++code) {
    for (const int shifted : {code, 255 - code, (code + 85) % 256}) {
      image.values.push_back(static_cast<float>(decode_srgb(shifted / 255.0L)));
      expected.push_back(shifted);
    }
  }
  EXPECT_EQ(read_codes(image), expected);
}

TEST(Png, KeepsOrderOfPixelsAndPicksItsChannels) {
  ImageData image{3, 5, {"variance.R", "B", "G", "R"}, {}, {}};
  std::vector<int> expected;
  for (int pixel = 0; pixel < 15; ++pixel) {
    const int r = 10 * pixel, g = 10 * pixel + 1, b = 10 * pixel + 2;
    image.values.push_back(1e6f);
    for (const int code : {b, g, r}) {
      image.values.push_back(static_cast<float>(decode_srgb(code / 255.0L)));
    }
    expected.insert(expected.end(), {r, g, b});
  }
  EXPECT_EQ(read_codes(image), expected);
}

TEST(Png, SaysThatItIsSrgbAndKeepsMetadata) {
  ImageData image = numbered_image(2, 2, {"R", "G", "B"});
  image.metadata = {{"Command", "Raytracing render \"a b\""},
                    {"Scene", "Schloß.toml"},
                    {"Samples per pixel", std::int64_t{9007199254740993}},
                    {"Seconds", 0.1}};
  const OIIO::ImageSpec spec = read_back(image, "x.png").spec;
  EXPECT_EQ(spec.nchannels, 3);
  EXPECT_EQ(spec.format, OIIO::TypeUInt8);
  EXPECT_EQ(spec.get_string_attribute("oiio:ColorSpace"), "sRGB");
  EXPECT_EQ(spec.get_string_attribute("Command"), "Raytracing render \"a b\"");
  EXPECT_EQ(spec.get_string_attribute("Scene"), "Schloß.toml");
  EXPECT_EQ(spec.get_string_attribute("Samples per pixel"), "9007199254740993");
  EXPECT_EQ(spec.get_string_attribute("Seconds"), "0.1");
  const std::string bytes = encode_image(image, "png");
  for (const char* chunk : {"sRGB", "tEXtCommand", "iTXtScene"}) {
    EXPECT_NE(bytes.find(chunk), std::string::npos) << chunk;
  }
}

TEST(Png, RefusesWhatItCannotHold) {
  EXPECT_THROW(encode_image(numbered_image(1, 1, {"R", "G"}), "png"), OutputError);
  ImageData image = numbered_image(1, 1, {"R", "G", "B"});
  image.metadata = {{std::string(80, 'k'), 1.0}};  // a keyword has at most 79 bytes
  EXPECT_THROW(encode_image(image, "png"), OutputError);
}

TEST(EncodeImage, RefusesWrongLayouts) {
  ImageData image = numbered_image(2, 2, {"R", "G", "B"});
  image.values.pop_back();
  ImageData twice = numbered_image(2, 2, {"R", "R", "B"});
  ImageData nothing{0, 0, {"R", "G", "B"}, {}, {}};
  for (const char* format : {"png", "exr"}) {
    EXPECT_THROW(encode_image(image, format), OutputError);
    EXPECT_THROW(encode_image(twice, format), OutputError);
    EXPECT_THROW(encode_image(nothing, format), OutputError);
  }
}

}  // namespace
}  // namespace raytracing
