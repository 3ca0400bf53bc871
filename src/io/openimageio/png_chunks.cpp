#include <zlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "fences.h"
#include "raytracing/io/errors.h"

namespace raytracing::openimageio {
namespace {

[[noreturn]] void fail(const std::string& why) { throw InputError("damaged PNG image: " + why); }

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i)
    number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return number;
}

std::uint32_t checksum(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

// Colour primaries 1 with the transfer function 13, of full range: ITU-T H.273.
void check_cicp(std::string_view data) {
  if (data != std::string_view("\x01\x0d\x00\x01", 4))
    throw InputError(
        "its chunk cICP states a colour space other than sRGB, which is not converted");
}

double gamma_of(std::string_view data) {
  if (data.size() != 4) fail("its gamma is not a number");
  constexpr double kSrgb = 0.45455, kTolerance = 0.005;
  const double encoding = 1e-5 * number_at(data, 0);
  if (encoding == 0) fail("its gamma is 0");
  return std::abs(encoding - kSrgb) > kTolerance ? 1 / encoding : 0;
}

// White, red, green and blue, of which the white comes last here.
std::array<float, 8> chromaticities_of(std::string_view data) {
  std::array<float, 8> xy{};
  if (data.size() != 4 * xy.size()) fail("its chromaticities are not eight numbers");
  for (std::size_t i = 0; i < xy.size(); ++i)
    xy[(i + 6) % 8] = static_cast<float>(1e-5 * number_at(data, 4 * i));
  return xy;
}

}  // namespace

StatedColours check_png_chunks(const std::string& bytes) {
  constexpr std::size_t kSignature = 8, kLengthAndName = 8, kChecksum = 4;
  std::string_view rest = std::string_view(bytes).substr(std::min(kSignature, bytes.size()));
  StatedColours colours;
  bool is_srgb = false;
  while (rest.size() >= kLengthAndName) {
    const std::size_t length = number_at(rest, 0);
    if (length + kChecksum > rest.size() - kLengthAndName) break;
    const std::string_view name = rest.substr(4, 4), data = rest.substr(kLengthAndName, length);
    if (checksum(rest.substr(4, 4 + length)) != number_at(rest, kLengthAndName + length))
      fail("the checksum of its chunk " + quoted(name) + " is wrong");
    if (name == "cICP") check_cicp(data);
    if (name == "gAMA") colours.gamma = gamma_of(data);
    if (name == "cHRM") colours.chromaticities = chromaticities_of(data);
    if (name == "sRGB" || name == "cICP") is_srgb = true;
    if (name == "iCCP") colours.has_profile = true;
    if (name == "IEND") {
      if (is_srgb || colours.has_profile) return {.has_profile = colours.has_profile};
      return colours;
    }
    rest.remove_prefix(kLengthAndName + length + kChecksum);
  }
  fail("cut off within a chunk");
}

std::string with_international_text(std::string png, const std::string& keyword,
                                    const std::string& text) {
  constexpr std::size_t kLength = 4;
  // Behind the keyword: not compressed, no language, no translated keyword.
  const std::string body = "iTXt" + keyword + std::string(5, '\0') + text;
  const auto append = [](std::string& bytes, std::size_t number) {
    for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift & 0xff);
  };
  std::string chunk;
  append(chunk, body.size() - kLength);
  chunk += body;
  append(chunk, checksum(body));
  return png.insert(png.find("IDAT") - kLength, chunk);
}

}  // namespace raytracing::openimageio
