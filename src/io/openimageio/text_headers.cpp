// The headers of HDR and PNM files, which are text.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>
#include <string>

#include "fences.h"
#include "raytracing/io/errors.h"

namespace raytracing::openimageio {
namespace {

constexpr std::size_t kLongestHeader = 1 << 16;

// The header ends with an empty line.
std::istringstream hdr_header(const std::string& bytes) {
  const std::size_t end = std::min(bytes.find("\n\n"), kLongestHeader);
  return std::istringstream(bytes.substr(0, std::min(end, bytes.size())));
}

void check_factors(const std::string& key, const std::string& value) {
  std::istringstream numbers(value);
  for (double factor = 1; numbers >> factor;)
    if (factor != 1)
      throw InputError(
          fmt::format("its header states {}={}, which is not applied", key, one_line(value)));
}

}  // namespace

StatedColours check_hdr_header(const std::string& bytes) {
  std::istringstream lines = hdr_header(bytes);
  StatedColours colours;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string key = line.substr(0, equals), value = line.substr(equals + 1);
    if (key == "EXPOSURE" || key == "COLORCORR" || key == "GAMMA") check_factors(key, value);
    if (key != "PRIMARIES") continue;
    std::istringstream numbers(value);
    std::array<float, 8> xy{};
    for (float& number : xy)
      if (!(numbers >> number)) throw InputError("its PRIMARIES are not eight numbers");
    colours.chromaticities = xy;
  }
  return colours;
}

void check_pnm_header(const std::string& bytes) {
  const char kind = bytes[1];
  if (kind != '2' && kind != '3' && kind != '5' && kind != '6') return;
  std::istringstream text(bytes.substr(2, kLongestHeader));
  std::array<long, 3> numbers{};  // width, height, largest value
  for (long& number : numbers) {
    while (text >> std::ws && text.peek() == '#') text.ignore(kLongestHeader, '\n');
    if (!(text >> number)) throw InputError("damaged PNM image: its header is cut off");
  }
  if (numbers[2] != 255)
    throw InputError(
        fmt::format("PNM images with the largest value {} cannot be read, only 255", numbers[2]));
}

}  // namespace raytracing::openimageio
